//! Tables of the papers that methods are made after, taken anew.

pub mod beams;
pub mod stages;
pub mod sweep;
