//! Layout of an environment map: a chain of equirectangular levels, RGB floats, level 0 first, each half the size of the
//! one before (at least 1), rows from the zenith down.

/// The environment's pattern.
pub mod kind {
    /// One colour.
    pub const COLOR: u32 = 0;
    /// Nadir, horizon, zenith.
    pub const GRADIENT: u32 = 1;
    /// Squares in longitude and latitude.
    pub const CHECKERBOARD: u32 = 2;
    /// An equirectangular map.
    pub const MAP: u32 = 3;
}

/// The most levels a chain has.
pub const MAX_LEVELS: u32 = 15;
