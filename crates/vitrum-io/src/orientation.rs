//! Orientation of a volume in the world.

/// Kind of a volume's world, as far as its file says it.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Orientation {
    /// A patient: world x points to the right, y to anterior and z to superior (RAS+).
    Patient,
    /// A world that is no patient's, or one that the volume was turned in; it is right-handed.
    World,
    /// The file does not say the grid's orientation: z was taken for up and y for the front, and left and right may be exchanged.
    #[default]
    Unknown,
}

impl Orientation {
    /// Name of the orientation: `patient`, `world` or `unknown`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Patient => "patient",
            Self::World => "world",
            Self::Unknown => "unknown",
        }
    }
}
