//! The choices of whoever opens a file, by name.

/// A field of [`OpenOptions`](crate::OpenOptions) by which a file is read otherwise. Errors and assumptions name it, so that a program
/// can tell its user which of its own controls sets it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Setting {
    /// [`OpenOptions::raw`](crate::OpenOptions::raw): the layout of voxels without a header.
    Raw,
    /// [`OpenOptions::array`](crate::OpenOptions::array): the array, or the channel, of several.
    Array,
    /// [`OpenOptions::time`](crate::OpenOptions::time): the point in time of several.
    Time,
    /// [`OpenOptions::spacing`](crate::OpenOptions::spacing): the distances of voxels.
    Spacing,
    /// [`OpenOptions::up`](crate::OpenOptions::up): the direction that points up.
    Up,
}
