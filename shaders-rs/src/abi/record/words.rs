//! Records of words and sums, whose components are no fields of a struct: bits, counts, and the halves of integers.

/// Fixed-point sums of the light that refracted cells of the wavefront bring to a sample: pairs of sums of 32 bits, next to each other (not planar), in
/// units of 1 / [`units`](crate::abi::wavefront::Wavefront::units).
pub mod sums {
    /// Words.
    pub const SIZE: usize = 6;
    /// Fluence over that of unoccluded light, red and green.
    pub const RED_AND_GREEN: usize = 0;
    /// Fluence (the mean of its colours) times the change of the unit direction's x, and of its y.
    pub const DIRECTION: usize = 2;
    /// Fluence, blue, and nothing.
    pub const BLUE: usize = 4;
    /// The words' names.
    #[cfg(not(target_arch = "spirv"))]
    pub const NAMES: [&str; SIZE] = ["red", "green", "direction x", "direction y", "blue", "nothing"];
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

/// Fixed-point sums of the light that refracted cells of the wavefront bring to a texel of a receiver: for each channel a low and a high word,
/// next to each other (not planar).
pub mod landed {
    /// Words.
    pub const SIZE: usize = 6;
    /// Units in 1.
    pub const SCALE: f32 = 16_777_216.0;
    /// The words' names.
    #[cfg(not(target_arch = "spirv"))]
    pub const NAMES: [&str; SIZE] = ["red, low", "red, high", "green, low", "green, high", "blue, low", "blue, high"];
}
