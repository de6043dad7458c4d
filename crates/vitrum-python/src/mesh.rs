//! Triangle meshes.

use crate::array;
use crate::errors::Failure;
use numpy::PyReadonlyArray2;
use pyo3::prelude::*;
use std::sync::Arc;
use vitrum::io;

/// A triangle mesh in memory.
#[pyclass(frozen, module = "vitrum_render._native")]
#[derive(Clone)]
pub struct Mesh(pub Arc<io::Mesh>);

/// The rows of an array of `N` columns.
fn rows<T: numpy::Element + Copy, const N: usize>(array: &PyReadonlyArray2<'_, T>) -> PyResult<Vec<[T; N]>> {
    Ok(array.as_slice()?.as_chunks().0.to_vec())
}

#[pymethods]
impl Mesh {
    /// A mesh of C-contiguous positions (float32, n × 3) and triangles (uint32, m × 3).
    #[new]
    fn new(
        name: String,
        positions: PyReadonlyArray2<'_, f32>,
        triangles: PyReadonlyArray2<'_, u32>,
        colors: Option<PyReadonlyArray2<'_, f32>>,
    ) -> PyResult<Self> {
        let mut mesh = io::Mesh::new(name, rows(&positions)?, rows(&triangles)?).map_err(Failure::from)?;
        mesh.colors = colors.map(|colors| rows(&colors)).transpose()?;
        Ok(Self(Arc::new(mesh)))
    }

    #[getter]
    fn name(&self) -> &str {
        &self.0.name
    }

    /// Vertices, n × 3, read-only and without a copy.
    #[getter]
    fn positions<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        let positions = &slf.get().0.positions;
        let owner = slf.clone().into_any();
        Ok(array::lent(positions.as_flattened(), &[positions.len(), 3], owner)?.into_any())
    }

    /// Triangles, m × 3, read-only and without a copy.
    #[getter]
    fn triangles<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        let triangles = &slf.get().0.triangles;
        let owner = slf.clone().into_any();
        Ok(array::lent(triangles.as_flattened(), &[triangles.len(), 3], owner)?.into_any())
    }

    /// Corners of the smallest box around the vertices.
    #[getter]
    fn bounds(&self) -> [[f32; 3]; 2] {
        self.0.bounds()
    }

    /// Names of the materials.
    #[getter]
    fn materials(&self) -> Vec<String> {
        self.0.materials.iter().map(|material| material.name.clone()).collect()
    }

    /// What its reader took for granted.
    #[getter]
    fn notes(&self) -> Vec<String> {
        self.0.source.assumptions.iter().map(ToString::to_string).collect()
    }
}
