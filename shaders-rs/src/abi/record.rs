//! Records: what a kernel returns for one index. Component `c` of record `i` out of `n` lies at `c·n + i` (planar).

/// The light of a texel.
pub mod light {
    /// Components.
    pub const SIZE: usize = 9;
    /// Flux over that of unoccluded light, by absorption and by the product over the planes of how much denser refraction has
    /// made it: red; green and blue follow.
    pub const FLUX: usize = 0;
    /// Optical direction v, x; y and z (depth) follow.
    pub const DIRECTION_X: usize = 3;
    /// How far from here, in texels across, it would be if it had not been refracted; up follows.
    pub const DISPLACEMENT_X: usize = 6;
    /// That product.
    pub const CONCENTRATION: usize = 8;
}

/// Light falling on a texel of a plane: plane irradiance (or radiance, see [`super::sweep::flag::STORE_RADIANCE`]) over that of unoccluded
/// light, and its direction.
pub mod irradiance {
    /// Components.
    pub const SIZE: usize = 4;
    /// Red; green and blue follow.
    pub const SHARE: usize = 0;
    /// The direction, as [`crate::sweep::light::offset`] packs it.
    pub const DIRECTION: usize = 3;
}

/// Where light comes from: the way to its texel from the plane behind, x and y, in texels.
pub mod trace {
    /// Components.
    pub const SIZE: usize = 2;
}

/// A node of a sheet of light: where light that crossed a corner between texels on the first plane is now.
pub mod sheet {
    /// Components.
    pub const SIZE: usize = 11;
    /// How far from its corner it is, in texels across; up follows.
    pub const DISPLACEMENT_X: usize = 0;
    /// How far it would be if nothing had bent it, in texels across; up follows.
    pub const UNREFRACTED_X: usize = 2;
    /// Optical direction v, x; y and z (depth) follow.
    pub const DIRECTION_X: usize = 4;
    /// Flux of a texel of light here, over that of all unoccluded light: red; green and blue follow.
    pub const FLUX: usize = 7;
    /// 1 if it turned back: the plane sweep cannot follow.
    pub const TURNED: usize = 10;
}

/// Fixed-point sums of the changes that sheets make on a texel: for each channel a low and a high word, next to each other (not planar).
pub mod sums {
    /// Words.
    pub const SIZE: usize = 2 * CHANNELS;
    /// Channels.
    pub const CHANNELS: usize = 5;
    /// Flux over that of unoccluded light, red; green and blue follow.
    pub const FLUX: usize = 0;
    /// Flux (the mean of its colours) times the change of its slope v_x / v_z; v_y / v_z follows.
    pub const SLOPE_X: usize = 3;
    /// Units in 1, of flux.
    pub const FLUX_SCALE: f32 = 16_777_216.0;
    /// Units in 1, of flux times slope: a slope changes by less than 2⁷, so that one contribution has less than 2³¹ units.
    pub const SLOPE_SCALE: f32 = 8_388_608.0;
}

/// A single word a place: bits of a mask, or a count.
pub mod word {
    /// Words.
    pub const SIZE: usize = 1;
}

/// Sums of the attributes of the triangles that meet a voxel: words next to each other (not planar), sums as in [`crate::field::sums`].
pub mod attributes {
    /// Words.
    pub const SIZE: usize = 14;
    /// Triangles.
    pub const COUNT: usize = 0;
    /// The largest number of a material, counted from 1; 0 for none.
    pub const MATERIAL: usize = 1;
    /// Sum of unit normals, x, a low and a high word; y and z follow.
    pub const NORMAL: usize = 2;
    /// Sum of linear colours, red, a low and a high word; green and blue follow.
    pub const COLOR: usize = 8;
    /// Units in 1, of either.
    pub const SCALE: f32 = 65536.0;
}

/// Optical depth of a voxel of the shadow map: for each channel a low and a high word, next to each other, channel by channel.
pub mod absorption {
    /// Words.
    pub const SIZE: usize = 2;
    /// Units in 1.
    pub const SCALE: f32 = 16_777_216.0;
    /// The largest optical depth of one contribution: e^−64 is nothing, and has less than 2³¹ units.
    pub const MOST: f32 = 64.0;
}

/// Arguments and results of [`crate::probe::apply_function`] for an index.
pub mod probe {
    /// Arguments.
    pub const ARGUMENTS: usize = 8;
    /// Results; those that a function does not have are 0.
    pub const SIZE: usize = 4;
}

/// A viewing ray.
pub mod ray {
    /// Components.
    pub const SIZE: usize = 18;
    /// Position in the view frame where the ray last bent, or ended; from there it flies straight.
    pub const X: usize = 0;
    /// See `X`.
    pub const Y: usize = 1;
    /// See `X`.
    pub const Z: usize = 16;
    /// Optical direction v, x; y and z (depth) follow.
    pub const DIRECTION_X: usize = 2;
    /// Normalised scalar on the plane at depth `SAMPLED`.
    pub const FRONT: usize = 5;
    /// One of [`super::status`].
    pub const STATUS: usize = 6;
    /// Opacity-weighted sum of depths.
    pub const DEPTH: usize = 7;
    /// Particle colour C, red; green and blue follow.
    pub const COLOR: usize = 8;
    /// Opacity A.
    pub const OPACITY: usize = 11;
    /// Medium colour M, red; green and blue follow.
    pub const MEDIUM: usize = 12;
    /// η on the plane at depth `SAMPLED`.
    pub const IOR: usize = 15;
    /// Depth of the plane on which scalar and η were last sampled; [`NOWHERE`] if on none.
    pub const SAMPLED: usize = 17;
    /// The depth of no plane: −2¹⁰⁰. Not `f32::MIN`, which some browsers refuse as translators write it.
    pub const NOWHERE: f32 = -1.267_650_6e30;
}

/// A ray through a mesh.
pub mod path {
    /// Components.
    pub const SIZE: usize = 25;
    /// Position in voxels from the grid's low corner; y and z follow.
    pub const POSITION: usize = 0;
    /// Unit direction along the grid's axes; y and z follow.
    pub const DIRECTION: usize = 3;
    /// Transmittance of absorption and reflection, red; green and blue follow.
    pub const TRANSMITTANCE: usize = 6;
    /// Unit normal at the first surface, outwards; y and z follow. 0 if there was none.
    pub const NORMAL: usize = 9;
    /// Unit normal at the last surface, outwards; y and z follow. 0 if there was none.
    pub const LAST_NORMAL: usize = 12;
    /// Distance since the last surface, in voxels.
    pub const SINCE: usize = 15;
    /// One of [`super::fate`].
    pub const STATUS: usize = 16;
    /// The number of the material around the ray, [`super::super::voxels::AIR`] outside. For triangles, where it is in
    /// any, minus the number that has a bit for each material that it is in.
    pub const MEDIUM: usize = 17;
    /// Surfaces at which the ray was refracted or reflected.
    pub const BOUNCES: usize = 18;
    /// Distance within materials, in voxels.
    pub const LENGTH: usize = 19;
    /// Distance from the eye to the first surface, in voxels.
    pub const DEPTH: usize = 20;
    /// Share of the light that the first surface reflects.
    pub const REFLECTANCE: usize = 21;
    /// The node of the tree of triangles that is next.
    pub const NODE: usize = 22;
    /// The nearest triangle so far on the ray's straight way, or one of [`ahead`](super::super::receivers::ahead).
    pub const TRIANGLE: usize = 23;
    /// Its distance, in voxels.
    pub const DISTANCE: usize = 24;
}

/// The search for the triangle that the first surface mirrors.
pub mod mirror {
    /// Components.
    pub const SIZE: usize = 4;
    /// One of [`stage`].
    pub const STAGE: usize = 0;
    /// The node of the tree of triangles that is next.
    pub const NODE: usize = 1;
    /// The nearest opaque triangle so far on the reflected ray's way, or one of [`ahead`](super::super::receivers::ahead).
    pub const TRIANGLE: usize = 2;
    /// Its distance, in voxels.
    pub const DISTANCE: usize = 3;

    /// How far the search is.
    pub mod stage {
        /// Not begun.
        pub const NEW: f32 = 0.0;
        /// Under way.
        pub const SEEKS: f32 = 1.0;
        /// Done.
        pub const FOUND: f32 = 2.0;
    }
}

/// States of a ray through a mesh.
pub mod fate {
    /// Under way.
    pub const ACTIVE: f32 = 0.0;
    /// It left the grid.
    pub const LEFT: f32 = 1.0;
    /// It was still within a material after as many surfaces as it may meet.
    pub const TRAPPED: f32 = 2.0;
    /// It met an opaque triangle or a receiver.
    pub const MET: f32 = 3.0;
    /// Under way, and looking for the opaque triangle or receiver ahead.
    pub const SEEKS: f32 = 4.0;
}

/// A finished pixel of a mesh.
pub mod view {
    /// Components.
    pub const SIZE: usize = 18;
    /// Linear radiance, red; green, blue and coverage follow.
    pub const COLOR: usize = 0;
    /// Unit normal at the first surface, clear or opaque, in view space (looking along −z), x; y and z follow. 0 if there was none.
    pub const NORMAL: usize = 4;
    /// Surfaces at which the ray was refracted or reflected.
    pub const BOUNCES: usize = 7;
    /// Distance within materials, world units.
    pub const LENGTH: usize = 8;
    /// Depth of the first surface along the viewing direction, world units; 0 if there was none.
    pub const DEPTH: usize = 9;
    /// Final unit direction in view space, x; y and z follow.
    pub const DIRECTION: usize = 10;
    /// Transmittance of absorption and reflection, red; green and blue follow.
    pub const TRANSMITTANCE: usize = 13;
    /// Share of the light that the first surface reflects.
    pub const REFLECTANCE: usize = 16;
    /// One of [`super::fate`].
    pub const STATUS: usize = 17;
}

/// States of a viewing ray.
pub mod status {
    /// Under way.
    pub const ACTIVE: f32 = 0.0;
    /// Opaque, or ended on a receiver.
    pub const ENDED: f32 = 1.0;
    /// Its depth component reached ε: turned back or grazing; the plane sweep cannot follow.
    pub const TURNED: f32 = 2.0;
}

/// A finished pixel.
pub mod film {
    /// Components.
    pub const SIZE: usize = 16;
    /// Linear radiance, red; green, blue and coverage follow.
    pub const COLOR: usize = 0;
    /// Opacity A.
    pub const OPACITY: usize = 4;
    /// Medium colour M, red; green and blue follow.
    pub const MEDIUM: usize = 5;
    /// Opacity-weighted mean depth from the eye, world units; 0 where nothing is opaque.
    pub const DEPTH: usize = 8;
    /// Final unit direction in view space (looking along −z), x; y and z follow.
    pub const DIRECTION: usize = 9;
    /// Final position in view space, world units, x; y and z follow.
    pub const POSITION: usize = 12;
    /// One of [`super::status`].
    pub const STATUS: usize = 15;
}
