//! Records of the plane sweep.

record! {
    /// The light of a texel.
    light: Light {
        /// Flux over that of unoccluded light, by absorption and by how much denser refraction has made it.
        flux: Color,
        /// Optical direction v; z is depth.
        direction: Vec3,
        /// Distance across from the texel that the light would be on if nothing had refracted it, in texels.
        displacement_x: f32,
        /// Distance up from that texel, in texels.
        displacement_y: f32,
        /// How much denser refraction has made the light: its flux without absorption.
        concentration: f32,
    }
}

record! {
    /// Light falling on a texel of a plane: plane irradiance (or radiance, see [`crate::abi::sweep::flag::STORE_RADIANCE`]) over that of
    /// unoccluded light, and its direction.
    irradiance: Irradiance {
        /// The share of unoccluded light.
        share: Color,
        /// The direction, as [`crate::sweep::light::offset`] packs it.
        direction: f32,
    }
}

record! {
    /// The ways of light from the plane behind: the way to its texel from where its light comes, and that of the light on its texel there.
    trace: Trace {
        /// Across, in texels.
        across: f32,
        /// Up, in texels.
        up: f32,
        /// The way from its texel of the plane behind on to this plane: across, in texels.
        ahead_x: f32,
        /// Up, in texels.
        ahead_y: f32,
    }
}

record! {
    /// A node of the wavefront of light, in the wavefront's frame.
    node: Node {
        /// Position where the light last bent; from there it flies straight.
        position: Vec3,
        /// Optical direction v; z is depth.
        direction: Vec3,
        /// The share of unoccluded light that is left.
        flux: Color,
        /// 1 inside the space in which the volume bends, see [`border`](crate::sweep::border), as it was known last; else 0.
        inside: f32,
        /// 1 if anything has bent the light; else 0.
        bent: f32,
        /// One of [`node_status`](crate::abi::record::node_status).
        status: f32,
        /// The sum of the depths at which light was absorbed, each weighted by the share that was, mean of the colours.
        absorbed_at: f32,
        /// That sum when the light bent first, with what was left then at the depth of that bend.
        left_at: f32,
    }
}

record! {
    /// What a node of the wavefront has left of its light, blurred as by a light of some width.
    blurred: Blurred {
        /// The share of unoccluded light that is left.
        flux: Color,
        /// The sum of the depths at which light was absorbed, as that of a node.
        absorbed_at: f32,
    }
}

/// States of a node of the wavefront.
pub mod node_status {
    /// Under way.
    pub const ACTIVE: f32 = 0.0;
    /// It turned back: the planes cannot follow it.
    pub const TURNED: f32 = 1.0;
    /// No light is left.
    pub const DARK: f32 = 2.0;
    /// It is about to meet a receiver.
    pub const LANDED: f32 = 3.0;
}

record! {
    /// A node of the wavefront on a plane.
    projected: Projected {
        /// Column among the samples of the plane.
        x: f32,
        /// Row among the samples of the plane.
        y: f32,
        /// Fluence over that of unoccluded light.
        fluence: Color,
        /// Difference of the unit direction from the direction of unrefracted light, x.
        aside_x: f32,
        /// Difference of the unit direction, y.
        aside_y: f32,
        /// One of [`course`](crate::abi::record::course).
        course: f32,
    }
}

/// Courses of a node's light so far.
pub mod course {
    /// It is where unrefracted light is.
    pub const STRAIGHT: f32 = 0.0;
    /// It was bent.
    pub const BENT: f32 = 1.0;
    /// It turned back.
    pub const TURNED: f32 = 2.0;
}

record! {
    /// The samples inside a cell of the wavefront, and the light that it brings to each of them: in units of the sums, or, if it is the sample in the
    /// cell's place alone, over that of unoccluded light.
    covered: Covered {
        /// One of [`cover`](crate::abi::record::cover), or a sum of the samples' weights there.
        samples: f32,
        /// Column of the first one of four samples.
        column: f32,
        /// Row of the first one of four samples.
        row: f32,
        /// Fluence.
        fluence: Color,
        /// Fluence times the difference of its direction, x.
        aside_x: f32,
        /// Fluence times the difference of its direction, y.
        aside_y: f32,
    }
}

/// Which of the four samples from a cell's first one on are inside the cell.
pub mod cover {
    /// Nothing looks at the cell's light.
    pub const NONE: f32 = 0.0;
    /// Weight of the first sample.
    pub const FIRST: f32 = 1.0;
    /// Weight of the sample beside the first one.
    pub const BESIDE: f32 = 2.0;
    /// Weight of the sample above the first one.
    pub const ABOVE: f32 = 4.0;
    /// Weight of the sample beside that one.
    pub const ACROSS: f32 = 8.0;
    /// More samples may be inside, or the cell has no inside.
    pub const OTHERS: f32 = 16.0;
    /// The sample in the cell's place alone is inside.
    pub const STAYS: f32 = 32.0;
}

record! {
    /// Light around a sample of the wavefront's planes.
    carried: Carried {
        /// Fluence over that of unoccluded light.
        share: Color,
        /// The direction, as [`crate::sweep::light::offset`] packs it.
        direction: f32,
    }
}

record! {
    /// Light around a sample of the wavefront's planes, in a clear medium.
    carried_clear: CarriedClear {
        /// Fluence over that of unoccluded light.
        share: f32,
        /// The direction, as [`crate::sweep::light::offset`] packs it.
        direction: f32,
    }
}

record! {
    /// Light around a sample of the wavefront's planes, in a clear medium that does not bend it.
    carried_straight: CarriedStraight {
        /// Fluence over that of unoccluded light.
        share: f32,
    }
}

record! {
    /// Light on a texel of a receiver.
    received: Received {
        /// Irradiance over that of unoccluded light; of a point or spot, less what unoccluded light has.
        share: Color,
    }
}

record! {
    /// A viewing ray.
    ray: Ray {
        /// Position in the view frame where the ray last bent, or ended; from there it flies straight.
        position: Vec3,
        /// Optical direction v; z is depth.
        direction: Vec3,
        /// Normalised scalar on the plane at depth `sampled`; in a projection, what [`project_rays`](crate::sweep::project_rays) has gathered.
        scalar: f32,
        /// One of [`status`](crate::abi::record::status).
        status: f32,
        /// Opacity-weighted sum of depths; in a projection, until it is coloured, see [`project_rays`](crate::sweep::project_rays).
        depth: f32,
        /// Particle colour C.
        color: Color,
        /// Opacity A.
        opacity: f32,
        /// Transmittance of the filter, the paper's medium colour M.
        transmittance: Color,
        /// η on the plane at depth `sampled`; 0 outside the space in which the volume bends, see [`border`](crate::sweep::border).
        ior: f32,
        /// Depth of the plane on which scalar and η were last sampled; [`NOWHERE`] if on none.
        sampled: f32,
        /// η at the beginning of the layer of changing η in which the ray is, see [`surface`](crate::sweep::surface); negative behind the first surface, 0
        /// before anything was sampled.
        layer_ior: f32,
        /// Reflectance of the first surface so far.
        reflectance: f32,
        /// Mirrored directions outside of the first surface, each weighted by what is seen of it there.
        mirrored: Vec3,
    }

    /// The depth of no plane: −2¹⁰⁰. Not `f32::MIN`, which some browsers refuse as translators write it.
    pub const NOWHERE: f32 = -1.267_650_6e30;
}

/// States of a viewing ray.
pub mod status {
    /// Under way.
    pub const ACTIVE: f32 = 0.0;
    /// Opaque, or ended on a receiver.
    pub const ENDED: f32 = 1.0;
    /// Its depth component reached ε: turned back or grazing; the plane sweep cannot follow. The ray waits on the plane before, or at the
    /// border of the volume, with the direction in which it would have gone on.
    pub const TURNED: f32 = 2.0;
    /// Followed beyond the plane sweep ([`crate::sweep::follow_rays`]) until it left the volume.
    pub const LEFT: f32 = 3.0;
    /// Being followed beyond the plane sweep.
    pub const FOLLOWED: f32 = 4.0;
}

record! {
    /// A finished pixel.
    film: Pixel {
        /// Linear radiance.
        color: Color,
        /// Coverage, 0 to 1.
        coverage: f32,
        /// Opacity A.
        opacity: f32,
        /// Transmittance of the filter, the paper's medium colour M.
        transmittance: Color,
        /// Opacity-weighted mean depth from the eye, world units; 0 where nothing is opaque.
        depth: f32,
        /// Final unit direction in view space (looking along −z).
        direction: Vec3,
        /// Final position in view space, world units.
        position: Vec3,
        /// One of [`status`](crate::abi::record::status).
        status: f32,
    }
}
