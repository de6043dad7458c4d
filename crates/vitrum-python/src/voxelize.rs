//! Meshes as voxels.

use crate::array;
use crate::errors::Failure;
use crate::mesh::Mesh;
use crate::process::choice;
use crate::work;
use pyo3::prelude::*;
use std::sync::Arc;
use vitrum::backend::{self, GpuOptions};
use vitrum::method::Tools;
use vitrum::method::voxelize::{self as voxels, FillRule, Settings};

/// Turns a mesh into voxels: an array (z, y, x) of uint8, the edge of a voxel, the position of the first voxel's centre, and statistics as JSON.
#[pyfunction]
#[pyo3(signature = (mesh, resolution, solid = None, padding = 1, overlap = 0.0, backend = "auto", progress = None))]
#[expect(clippy::too_many_arguments, reason = "each is a keyword of Python's `voxelize`")]
pub fn voxelize<'py>(
    py: Python<'py>,
    mesh: &Mesh,
    resolution: u32,
    solid: Option<&str>,
    padding: u32,
    overlap: f32,
    backend: &str,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<(Bound<'py, PyAny>, f64, [f64; 3], String)> {
    let rule = solid.map(|name| match name {
        "nonzero" => Ok(FillRule::Nonzero),
        "even-odd" => Ok(FillRule::EvenOdd),
        other => Err(Failure::value(format!("there is no rule {other:?}"), "the rules are nonzero and even-odd")),
    });
    let solid = rule.transpose()?;
    let settings = Settings { resolution, padding, overlap, surface: solid.is_none(), attributes: false, solid };
    let (mesh, choice) = (Arc::clone(&mesh.0), choice(backend)?);
    let made = work::run(py, progress, |progress| {
        let mut backend = backend::open(choice, &GpuOptions::default(), Some(0))?;
        let mut tools = Tools { backend: backend.as_mut(), progress };
        Ok(voxels::voxelize(&mesh, &settings, &mut tools)?)
    })?;
    let values = match (made.solid, made.surface) {
        (Some(solid), _) => solid.coverage,
        (None, surface) => surface.map(|mask| mask.dense(255, 0)).unwrap_or_default(),
    };
    let [x, y, z] = made.grid.dimensions.map(|size| size as usize);
    let statistics = serde_json::to_string(&made.statistics).unwrap_or_default();
    let first = made.grid.origin.map(|corner| corner + 0.5 * made.grid.voxel_size);
    Ok((array::given(py, values, &[z, y, x])?.into_any(), made.grid.voxel_size, first, statistics))
}
