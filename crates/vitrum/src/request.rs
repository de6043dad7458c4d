//! The outputs that a caller asks for, and the progress that a caller is told.

use crate::method;

/// The outputs of a frame, and the memory that they may take.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct OutputRequest {
    /// The light on the last plane. Without it, light is carried only where viewing rays can see it, and a frame may end as soon as every
    /// ray has.
    pub light: bool,
    /// The outputs of the picture's size. Each takes 4 bytes for each pixel and channel.
    pub layers: Layers,
    /// The most viewing rays at once: a picture of more comes in parts, one after another, with the same bits. Each ray takes some 250 bytes while its part is
    /// rendered. Light on texels (`sweep.light`), and rays through meshes, are not parted.
    pub rays_at_once: u32,
}

/// As many rays as keep a processor busy; their records take a quarter of a gigabyte.
const RAYS_AT_ONCE: u32 = 1 << 20;

/// A set of outputs of the picture's size, by their names.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Layers(u64);

impl Layers {
    /// All of them.
    pub const ALL: Self = Self(u64::MAX);

    /// The colour alone.
    #[must_use]
    pub fn color() -> Self {
        Self(0).with("color")
    }

    /// These and the one of that name; what no method has adds nothing.
    #[must_use]
    pub fn with(self, name: &str) -> Self {
        Self(self.0 | Self::bits(name))
    }

    /// Whether the output of that name is one of them.
    #[must_use]
    pub fn has(self, name: &str) -> bool {
        self.0 & Self::bits(name) != 0
    }

    /// A bit for each output of any method: the first 64 places in their order.
    fn bits(name: &str) -> u64 {
        let places = (0..u64::BITS).zip(method::outputs());
        places.filter(|(_, (_, output))| output.name == name).map(|(place, _)| 1 << place).sum()
    }
}

impl Default for OutputRequest {
    fn default() -> Self {
        Self { light: true, layers: Layers::ALL, rays_at_once: RAYS_AT_ONCE }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_output_can_be_asked_for() {
        assert!(method::outputs().count() <= u64::BITS as usize, "more outputs than a set of them can hold");
        for (_, output) in method::outputs() {
            assert!(Layers::ALL.has(output.name));
            assert!(Layers::color().with(output.name).has(output.name));
            assert_eq!(Layers::color().has(output.name), output.name == "color");
        }
        assert_eq!(Layers::color().with("colour"), Layers::color());
    }
}
