//! The points in time of a file, as its readers tell them.

/// The points in time that a file has, for programs that go through them.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Moments {
    /// The number of points; 1 for a file without time.
    pub count: u64,
    /// The number of the point that was read, counted from 0.
    pub chosen: u64,
    /// The moment of each point in seconds, ascending, where the file states them.
    pub seconds: Option<Vec<f64>>,
}
