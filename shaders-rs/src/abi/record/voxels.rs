//! Records of rays through meshes.

record! {
    /// A ray through a mesh.
    path: Path {
        /// Position in voxels from the grid's low corner.
        position: Vec3,
        /// Unit direction along the grid's axes.
        direction: Vec3,
        /// Transmittance of absorption and reflection so far, 0 to 1.
        transmittance: Color,
        /// Unit normal at the first surface, outwards. 0 if there was none.
        normal: Vec3,
        /// Unit normal at the last surface, outwards. 0 if there was none. For triangles the numbers `enters`, `leaves` and `start` of a
        /// [`Contact`](crate::voxels::contact::Contact).
        last_normal: Vec3,
        /// Distance since the last surface, in voxels. For triangles the number `end` of a
        /// [`Contact`](crate::voxels::contact::Contact).
        since: f32,
        /// One of [`fate`](crate::abi::record::fate).
        status: f32,
        /// The number of the material around the ray, [`AIR`](crate::abi::voxels::AIR) outside. For triangles, where it is in
        /// any, minus the number that has a bit for each material that it is in.
        medium: i32,
        /// Surfaces at which the ray was refracted or reflected.
        bounces: f32,
        /// Distance within materials, in voxels.
        length: f32,
        /// Distance from the eye to the first surface, in voxels.
        depth: f32,
        /// Share of the light that the first surface reflects to an eye in air; 0 for an eye within a body.
        reflectance: f32,
        /// Share of the light from all sides that rays would bring which surfaces behind the first one reflect, and which are not
        /// followed, 0 to 1.
        rest: Color,
        /// The share that the strongest of those reflections would add to the rest if the next way did not follow it. 0 if there is none.
        kept: Color,
        /// A bit for each surface, by its number on the way from 0 on, at which the ray is reflected where it could be refracted; and
        /// above these the bit of the surface whose reflection is kept for the next way.
        turns: i32,
        /// The node of the tree of triangles that is next.
        node: i32,
        /// The nearest triangle so far on the ray's straight way, or one of [`ahead`](crate::abi::receivers::ahead).
        triangle: i32,
        /// The distance of that triangle, in voxels.
        distance: f32,
    }
}

record! {
    /// The search for the triangle that the first surface mirrors.
    mirror: Mirror {
        /// One of [`stage`].
        stage: f32,
        /// The node of the tree of triangles that is next.
        node: i32,
        /// The nearest opaque triangle so far on the reflected ray's way, or one of [`ahead`](crate::abi::receivers::ahead).
        triangle: i32,
        /// The distance of that triangle, in voxels.
        distance: f32,
    }

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

record! {
    /// A finished pixel of a mesh.
    view: MeshPixel {
        /// Linear radiance.
        color: Color,
        /// Coverage, 0 to 1.
        coverage: f32,
        /// Unit normal at the first surface, clear or opaque, in view space (looking along −z). 0 if there was none.
        normal: Vec3,
        /// Surfaces at which the ray was refracted or reflected.
        bounces: f32,
        /// Distance within materials, world units.
        length: f32,
        /// Depth of the first surface along the viewing direction, world units; 0 if there was none.
        depth: f32,
        /// Final unit direction in view space.
        direction: Vec3,
        /// Transmittance of absorption and reflection.
        transmittance: Color,
        /// Share of the light that the first surface reflects to an eye in air; 0 for an eye within a body.
        reflectance: f32,
        /// One of [`fate`](crate::abi::record::fate).
        status: f32,
    }
}
