//! How voxels are stored.
//!
//! Where the volume lies in one piece it is as it came, x fastest, without padding. Where it does not fit the device, the buffer holds
//! a table with an entry for each [`page`], and then the pages that are needed now.

/// A format of voxels, for hosts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// See [`U8`].
    U8,
    /// See [`U16`].
    U16,
    /// See [`F32`].
    F32,
    /// See [`F32WithIor`].
    F32WithIor,
    /// See [`U16WithColor`].
    U16WithColor,
    /// See [`U16WithBodies`].
    U16WithBodies,
    /// See [`U8Paged`].
    U8Paged,
    /// See [`U16Paged`].
    U16Paged,
    /// See [`F32Paged`].
    F32Paged,
    /// See [`F32WithIorPaged`].
    F32WithIorPaged,
}

impl Format {
    /// All formats, in order of their numbers.
    pub const ALL: [Self; 10] = [
        Self::U8,
        Self::U16,
        Self::F32,
        Self::F32WithIor,
        Self::U16WithColor,
        Self::U16WithBodies,
        Self::U8Paged,
        Self::U16Paged,
        Self::F32Paged,
        Self::F32WithIorPaged,
    ];

    /// The format of the same voxels in pages; `None` where colours or bodies belong to them, which come in one piece.
    #[must_use]
    pub const fn paged(self) -> Option<Self> {
        match self {
            Self::U8 | Self::U8Paged => Some(Self::U8Paged),
            Self::U16 | Self::U16Paged => Some(Self::U16Paged),
            Self::F32 | Self::F32Paged => Some(Self::F32Paged),
            Self::F32WithIor | Self::F32WithIorPaged => Some(Self::F32WithIorPaged),
            Self::U16WithColor | Self::U16WithBodies => None,
        }
    }

    /// Bytes of a voxel.
    #[must_use]
    pub const fn bytes(self) -> u64 {
        match self {
            Self::U8 | Self::U8Paged => 1,
            Self::U16 | Self::U16WithColor | Self::U16WithBodies | Self::U16Paged => 2,
            Self::F32 | Self::F32WithIor | Self::F32Paged | Self::F32WithIorPaged => 4,
        }
    }

    /// Whether voxels lie in pages.
    #[must_use]
    pub const fn is_paged(self) -> bool {
        matches!(self, Self::U8Paged | Self::U16Paged | Self::F32Paged | Self::F32WithIorPaged)
    }
}

/// A format of voxels, for kernels: a family has a member for each type with this trait.
pub trait VoxelFormat {
    /// Bits of a voxel: 8 or 16 of an unsigned integer, 32 of a float.
    const BITS: u32;
    /// Whether voxels lie in pages.
    const PAGED: bool;
    /// Whether a second volume, stored alike, gives the index of refraction.
    const SECOND: bool;
    /// Whether a second volume on the same grid gives the colour of each voxel.
    const COLORED: bool;
    /// Whether a second volume on a grid of its own has opaque bodies.
    const BODIES: bool;
}

macro_rules! formats {
    ($($(#[$doc:meta])* $name:ident: $bits:literal, $paged:literal, $second:literal, $colored:literal, $bodies:literal;)*) => {
        $(
            $(#[$doc])*
            pub struct $name;

            impl VoxelFormat for $name {
                const BITS: u32 = $bits;
                const PAGED: bool = $paged;
                const SECOND: bool = $second;
                const COLORED: bool = $colored;
                const BODIES: bool = $bodies;
            }
        )*
    };
}

formats! {
    /// Four unsigned bytes a word.
    U8: 8, false, false, false, false;
    /// Two unsigned 16-bit integers a word.
    U16: 16, false, false, false, false;
    /// One float a word.
    F32: 32, false, false, false, false;
    /// As [`F32`], with a second volume, also [`F32`], that gives the index of refraction.
    F32WithIor: 32, false, true, false, false;
    /// As [`U16`], with a second volume on the same grid, four bytes a voxel: the voxel's colour in sRGB, red in the lowest byte, and the factor of its extinction over
    /// 255 in the highest. See [`crate::field::colors`].
    U16WithColor: 16, false, false, true, false;
    /// As [`U16`], with a second volume on a grid of its own, four bytes a voxel: the reflectance of opaque bodies in sRGB, red in the lowest byte, and the share
    /// of the voxel that they fill over 255 in the highest. See [`crate::field::bodies`].
    U16WithBodies: 16, false, false, false, true;
    /// As [`U8`], in pages.
    U8Paged: 8, true, false, false, false;
    /// As [`U16`], in pages.
    U16Paged: 16, true, false, false, false;
    /// As [`F32`], in pages.
    F32Paged: 32, true, false, false, false;
    /// As [`F32WithIor`], both volumes in pages.
    F32WithIorPaged: 32, true, true, false, false;
}

/// Cubes of voxels that come to the device and leave it as a whole.
///
/// Page (i, j, k) is for the cells (look-ups between voxel n and n + 1) from [`EDGE`](page::EDGE) · (i, j, k) − 1 on, and holds all
/// voxels that a stencil in one of them reads; voxels beyond the grid are the nearest one in it. Its entry in the table,
/// x fastest, counts the voxels from the buffer's start to its first one.
pub mod page {
    /// log₂ of the cells along an edge.
    pub const SHIFT: i32 = 4;
    /// Cells along an edge.
    pub const EDGE: i32 = 1 << SHIFT;
    /// The bits of a cell's number that are its place in a page.
    pub const MASK: i32 = EDGE - 1;
    /// Voxels before the first cell's: a stencil's reach.
    pub const BEFORE: i32 = 1;
    /// Voxels along an edge.
    pub const ROW: i32 = EDGE + 3;
    /// Voxels in a slice.
    pub const SLICE: i32 = ROW * ROW;
    /// Voxels from a page to the next: whole words of any format.
    pub const STRIDE: i32 = (SLICE * ROW + 3) / 4 * 4;
}
