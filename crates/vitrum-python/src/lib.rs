//! The native part of the Python package `vitrum-render`: data, scenes, sessions and pictures as Python classes.
//!
//! The classes are thin: arguments are checked and made comfortable in Python (`python/vitrum_render`), work is done by the package `vitrum`. Work runs without the
//! interpreter's lock, on threads that belong to this process alone.

#![allow(clippy::needless_pass_by_value, reason = "Python hands arguments over by value")]

mod array;
mod compare;
mod compose;
mod errors;
mod frame;
mod mesh;
mod process;
mod program;
mod scene;
mod session;
mod tables;
mod volume;
mod voxelize;
mod work;

/// The native part of `vitrum_render`.
#[pyo3::pymodule]
mod _native {
    #[pymodule_export]
    use crate::compare::diff;
    #[pymodule_export]
    use crate::compose::{Composed, compose, load};
    #[pymodule_export]
    use crate::frame::Frame;
    #[pymodule_export]
    use crate::mesh::Mesh;
    #[pymodule_export]
    use crate::program::main;
    #[pymodule_export]
    use crate::scene::Scene;
    #[pymodule_export]
    use crate::session::Session;
    #[pymodule_export]
    use crate::tables::{colormaps, devices, keys, outputs, presets, scenes, schema, version};
    #[pymodule_export]
    use crate::volume::{Volume, open};
    #[pymodule_export]
    use crate::voxelize::voxelize;
}
