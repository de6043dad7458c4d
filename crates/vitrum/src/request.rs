//! The outputs that a caller asks for, and the progress that a caller is told.

/// How far a frame is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Progress {
    /// Planes done.
    pub done: u32,
    /// All planes.
    pub total: u32,
}

/// Outputs that cost time of their own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Wanted {
    /// The light on the last plane. Without it, light is carried only where viewing rays can see it, and a frame may end as soon as every
    /// ray has.
    pub light: bool,
}

impl Default for Wanted {
    fn default() -> Self {
        Self { light: true }
    }
}
