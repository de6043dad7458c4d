//! The outputs that a caller asks for, and the progress that a caller is told.

/// Outputs that cost time of their own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct OutputRequest {
    /// The light on the last plane. Without it, light is carried only where viewing rays can see it, and a frame may end as soon as every
    /// ray has.
    pub light: bool,
}

impl Default for OutputRequest {
    fn default() -> Self {
        Self { light: true }
    }
}

/// The kind of work that is under way.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Stage {
    /// A mesh is turned into voxels.
    Voxelize,
    /// The shadow map of a mesh is made.
    Shadow,
    /// The passes of a frame run.
    Render,
    /// Pixels that differ from their neighbours get more rays.
    Refine,
}

impl Stage {
    /// The stage in a word, for people.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Voxelize => "voxelizing",
            Self::Shadow => "casting shadows",
            Self::Render => "rendering",
            Self::Refine => "refining",
        }
    }
}

/// Progress of a piece of work.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Progress {
    /// The kind of work.
    pub stage: Stage,
    /// Units of it that are done, in a unit of the stage's own.
    pub done: u64,
    /// All units of the work, as far as their number is known.
    pub total: u64,
}
