//! Records of beams.

record! {
    /// A pencil: a ray with its first derivatives by the two coordinates of the texel or pixel that it goes through the centre of (Igehy 1999).
    /// It goes, one after the other, along all ways on which surfaces send its flux, by refraction or by reflection, the strongest first.
    pencil: Pencil {
        /// Position in voxels, where the present straight piece begins.
        position: Vec3,
        /// Unit direction.
        direction: Vec3,
        /// Change of the position over a texel along the first coordinate.
        position_u: Vec3,
        /// Change of the position over a texel along the second coordinate.
        position_v: Vec3,
        /// Change of the direction over a texel along the first coordinate.
        direction_u: Vec3,
        /// Change of the direction over a texel along the second coordinate.
        direction_v: Vec3,
        /// The share of the flux at the start that is left, 0 to 1.
        transmittance: Color,
        /// A bit for each material around the ray.
        media: i32,
        /// The node of the tree of triangles that is next.
        node: i32,
        /// The nearest triangle so far on the straight piece, or one of [`ahead`](crate::abi::receivers::ahead).
        triangle: i32,
        /// The distance of that triangle, in voxels.
        distance: f32,
        /// The number `enters` of a [`Contact`](crate::voxels::contact::Contact).
        enters: i32,
        /// The number `leaves` of a [`Contact`](crate::voxels::contact::Contact).
        leaves: i32,
        /// The number `start` of a [`Contact`](crate::voxels::contact::Contact).
        start: f32,
        /// The number `end` of a [`Contact`](crate::voxels::contact::Contact).
        end: f32,
        /// One of [`stage`].
        stage: f32,
        /// Surfaces that the present way has met.
        bounces: i32,
        /// A bit for each surface of the present way, by its number from 0 on, at which the ray takes the weaker of two ways: a turn.
        turns: i32,
        /// A bit for each surface of the present way whose weaker way is taken later.
        pending: i32,
        /// Surfaces of the present way at which the way is decided by `turns`.
        decided: i32,
        /// Turns of the ways that are followed now: first all ways without a turn, then those with one, and so on.
        level: i32,
        /// 1 if there are ways with more turns, else 0.
        deeper: i32,
        /// Straight pieces in air so far, over all ways, without those that ways share.
        pieces: i32,
        /// Share of the flux that has left all bodies and goes on, the mean of the channels.
        escaped: f32,
        /// Share that has met an opaque surface or a receiver.
        received: f32,
        /// Share that clear bodies and mirrors have absorbed.
        absorbed: f32,
        /// Share that the medium has absorbed or scattered.
        extinguished: f32,
        /// Share that was not followed.
        lost: f32,
    }

    /// Stages of a pencil.
    pub mod stage {
        /// Not begun.
        pub const NEW: f32 = 0.0;
        /// Under way to the end of a straight piece.
        pub const UNDER_WAY: f32 = 1.0;
        /// At the beginning of a straight piece in air whose end is known.
        pub const PAUSED: f32 = 2.0;
        /// All ways have ended.
        pub const DONE: f32 = 3.0;
    }
}

record! {
    /// The maps of the bodies at a texel of the lattice (Hu et al. 2010, §5.1), and the search for them. Distances are along the texel's ray, in voxels.
    faces: Faces {
        /// One of [`stage`].
        stage: f32,
        /// The node of the tree of triangles that is next.
        node: i32,
        /// The nearest triangle so far, or one of [`ahead`](crate::abi::receivers::ahead).
        triangle: i32,
        /// Its distance from where the search begins.
        distance: f32,
        /// Distance of the first surface from the light, or from the plane on which the rays of a distant light start.
        front_distance: f32,
        /// Unit normal there, on the side that the light comes from.
        front_normal: Vec3,
        /// Its triangle, or one of [`ahead`](crate::abi::receivers::ahead).
        front_triangle: i32,
        /// The number of its material, −1 if there is no surface.
        front_material: i32,
        /// Distance of the last surface by which light leaves a clear body.
        back_distance: f32,
        /// Unit normal there, on the side that the light goes to.
        back_normal: Vec3,
        /// The number of its material, −1 if there is none.
        back_material: i32,
    }

    /// Stages of the search.
    pub mod stage {
        /// Not begun.
        pub const NEW: f32 = 0.0;
        /// Looks for the front.
        pub const FRONT: f32 = 1.0;
        /// Looks for the back.
        pub const BACK: f32 = 2.0;
        /// Both are known.
        pub const DONE: f32 = 3.0;
    }
}

record! {
    /// The light of a texel where it leaves a clear body, by the maps of the body.
    way: Way {
        /// Position on the back, in voxels.
        position: Vec3,
        /// Unit direction behind it.
        direction: Vec3,
        /// Unit normal of the back, on the side that the light goes to.
        normal: Vec3,
        /// Share of the light that the back reflects, 0 to 1; 1 where no light gets through.
        reflectance: f32,
        /// Length of the way within the body, in voxels.
        length: f32,
    }
}

record! {
    /// A beam: the light of one texel of the lattice along a straight piece in air.
    beam: Beam {
        /// Position of its beginning, in voxels.
        position: Vec3,
        /// Unit direction.
        direction: Vec3,
        /// Change of the position over the texel along the first coordinate.
        position_u: Vec3,
        /// Change of the position over the texel along the second coordinate.
        position_v: Vec3,
        /// Change of the direction over the texel along the first coordinate.
        direction_u: Vec3,
        /// Change of the direction over the texel along the second coordinate.
        direction_v: Vec3,
        /// Flux at its beginning, RGB: irradiance over π times squared voxels. 0 if there is no beam.
        flux: Color,
        /// Half the sum of the lengths of the changes of the position: the radius of a sphere around the cross-section at the beginning;
        /// negative if there is no beam.
        radius: f32,
        /// Half the sum of the lengths of the changes of the direction, radians.
        opening: f32,
        /// Length in the medium, in voxels.
        length: f32,
        /// Distance of the surface that ends it, in voxels.
        reach: f32,
        /// That surface: a triangle, or one of [`ahead`](crate::abi::receivers::ahead).
        target: i32,
    }
}

record! {
    /// The projection of a beam: its edge functions over the picture's pixels by the axes along which it is drawn, and the part of the major axis that it
    /// covers, along which the middle's edge function changes more slowly.
    projection: Projection {
        /// 1 if the major axis points downwards, 0 if it points to the right.
        steep: f32,
        /// The edge function of the beam's middle, 0 on it: its factors along the major and the minor axis, and its constant.
        middle: Vec3,
        /// Change of the edge function over the texel along its first coordinate.
        change_u: Vec3,
        /// Change along its second coordinate.
        change_v: Vec3,
        /// The first column with any of the beam.
        begin: f32,
        /// The last column with any of the beam; before the first one where the beam does not show.
        end: f32,
        /// The first column across which the beam has no end.
        inner_begin: f32,
        /// The last one.
        inner_end: f32,
    }
}

record! {
    /// The depths of the viewing rays of a pixel of a level of the pyramid.
    depths: Depths {
        /// The least distance from the eye at which a ray ends, in voxels.
        nearest: f32,
        /// The greatest.
        farthest: f32,
        /// Distance from the eye at which rays enter the medium, the mean.
        enters: f32,
    }
}

record! {
    /// The depths of the viewing rays around a pixel of a level of the pyramid.
    around: Around {
        /// The least distance at which a ray of the pixel ends, or of the eight beside it, in voxels.
        nearest: f32,
        /// The greatest.
        farthest: f32,
        /// The least one up to two pixels away.
        least: f32,
        /// Distance from the eye at which the pixel's rays enter the medium, the mean.
        enters: f32,
    }
}

record! {
    /// A node of the tree over the beams of a round: boxes around all beams below it. Where there is none, the beams' box is inside out.
    bundle: Bundle {
        /// Low corner of the box of the beams in the medium, in voxels.
        low: Vec3,
        /// High corner of that box.
        high: Vec3,
        /// Middle of the box of the positions at which the beams begin, over their whole cross-sections.
        position: Vec3,
        /// Half the extent of that box.
        position_half: Vec3,
        /// Middle of the box of the beams' directions.
        direction: Vec3,
        /// Half the extent of that box.
        direction_half: Vec3,
        /// Low corner of the box of the beams' ends on surfaces.
        end_low: Vec3,
        /// High corner of that box.
        end_high: Vec3,
    }
}

record! {
    /// The search for a body between a diffuse surface and the source of light.
    search: Search {
        /// Number of the viewing ray's piece that ends at the surface, from 1 on.
        piece: i32,
        /// The node of the tree of triangles that is next.
        node: i32,
        /// 1 if there is a body, else 0.
        hidden: f32,
    }
}

record! {
    /// What a pixel sees so far, besides what beams bring to the first straight piece of its ray.
    sight: Sight {
        /// Distance from the eye at which the first straight piece ends, in voxels.
        depth: f32,
        /// Distance from the eye at which the ray enters the medium, in voxels.
        enters: f32,
        /// Distance from the eye at which the first straight piece leaves the medium, or ends in it, in voxels.
        leaves: f32,
        /// Radiance of surfaces and of the environment.
        radiance: Color,
        /// Radiance that the medium scatters out of the light of the source where nothing is in its way.
        airlight: Color,
        /// Volume caustics on the further pieces: in-scattered radiance.
        caustics: Color,
        /// Volumetric shadow on the further pieces: in-scattered radiance that bodies take away.
        shadow: Color,
        /// Radiance that the medium has scattered more than once.
        multiple: Color,
        /// Coverage, 0 to 1.
        coverage: f32,
        /// Unit normal at the first surface, along the grid's axes; 0 if there is none.
        normal: Vec3,
    }
}

record! {
    /// Optical depth at a node of a straight piece, over the extinction coefficient where the density is 1: the integral of the density along the
    /// piece, in voxels.
    optical_depth: OpticalDepth {
        /// Up to the node, or over the part between it and the node before.
        depth: f32,
    }
}

record! {
    /// A finished pixel.
    beam_pixel: BeamPixel {
        /// Linear radiance.
        color: Color,
        /// Coverage, 0 to 1.
        coverage: f32,
        /// Radiance of surfaces and of the environment through bodies and medium.
        surfaces: Color,
        /// Airlight: in-scattered radiance of the source without any body.
        airlight: Color,
        /// Volume caustics: in-scattered radiance of light that bodies have refracted or reflected.
        caustics: Color,
        /// Volumetric shadow: the part of the airlight that bodies take away.
        shadow: Color,
        /// Radiance that the medium has scattered more than once.
        multiple: Color,
        /// Depth of the first surface along the viewing direction, world units; 0 if there was none.
        depth: f32,
        /// Unit normal at the first surface in view space (looking along −z). 0 if there was none.
        normal: Vec3,
    }
}

record! {
    /// A cell of the medium: the light that arrives in it.
    cell: Cell {
        /// Fluence rate over π, RGB: the integral of the radiance over all directions.
        fluence: Color,
        /// Unit vector along the mean of the light's directions, each by its fluence.
        direction: Vec3,
        /// Length of that mean, 0 to 1: 1 if all light goes the same way.
        directed: f32,
        /// The medium's density, 0 behind the ground and the wall.
        density: f32,
    }
}

/// Sums of light in the cells of the medium: the flux of beams over π, in squared voxels, times the length of their ways in a cell, in voxels, RGB, and the mean of
/// the channels along the three axes. A low and a high word each, next to each other (not planar).
pub mod deposit {
    /// Words.
    pub const SIZE: usize = 12;
}

/// Sums of in-scattered radiance: for each channel a low and a high word, next to each other (not planar).
pub mod inscattered {
    /// Words.
    pub const SIZE: usize = 6;
}

record! {
    /// Whether a texel of the lattice is split into four.
    curved: Curved {
        /// 1 if it is, because its light's wavefront bends so much that the beam shows it in the picture, else 0.
        is_curved: f32,
    }
}
