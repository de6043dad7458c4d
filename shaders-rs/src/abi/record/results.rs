//! The record of the probe.

record! {
    /// Results of [`crate::probe::apply_function`] for an index; those that a function does not have are 0.
    probe: Results {
        /// The first result.
        first: f32,
        /// The second result.
        second: f32,
        /// The third result.
        third: f32,
        /// The fourth result.
        fourth: f32,
    }

    /// Arguments.
    pub const ARGUMENTS: usize = 8;
}
