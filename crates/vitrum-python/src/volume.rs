//! Volumes: arrays with a place in the world.

use crate::array;
use crate::errors::Failure;
use crate::process;
use crate::work;
use numpy::{PyArrayMethods, PyReadonlyArray3, PyUntypedArrayMethods};
use pyo3::prelude::*;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use vitrum::io::{self, OpenOptions, Orientation, Voxels};

/// Value, name and colour (sRGB) of a label.
type Label = (f32, String, Option<[f64; 3]>);

/// A scalar volume in memory.
#[pyclass(frozen, module = "vitrum_render._native")]
#[derive(Clone)]
pub struct Volume(pub Arc<io::Volume>);

/// x fastest is the last axis fastest: an array (z, y, x) in C order is taken as it lies, with room behind it.
fn values<T: numpy::Element + Copy>(array: &PyReadonlyArray3<'_, T>) -> PyResult<Vec<T>> {
    let count = array.len();
    let mut values = Vec::new();
    // Memory that is not there is Python's MemoryError, as NumPy has it.
    let room = count + 8 / size_of::<T>() + 1;
    values.try_reserve_exact(room).map_err(|error| pyo3::exceptions::PyMemoryError::new_err(error.to_string()))?;
    values.extend_from_slice(array.as_slice()?);
    Ok(values)
}

#[pymethods]
impl Volume {
    /// A volume of a C-contiguous array (z, y, x) of uint8, uint16 or float32: `physical = stored * scale + offset`.
    #[new]
    #[pyo3(signature = (array, name, spacing, scale = 1.0, offset = 0.0))]
    fn new(array: &Bound<'_, PyAny>, name: String, spacing: [f32; 3], scale: f32, offset: f32) -> PyResult<Self> {
        fn shape(array: &Bound<'_, numpy::PyUntypedArray>) -> PyResult<[u32; 3]> {
            let [z, y, x] = [0, 1, 2].map(|axis| u32::try_from(array.shape()[axis]));
            Ok([x?, y?, z?])
        }
        let (voxels, dimensions) = if let Ok(array) = array.extract::<PyReadonlyArray3<'_, u8>>() {
            (Voxels::from(values(&array)?), shape(array.as_untyped())?)
        } else if let Ok(array) = array.extract::<PyReadonlyArray3<'_, u16>>() {
            (Voxels::from(values(&array)?), shape(array.as_untyped())?)
        } else {
            let array = array.extract::<PyReadonlyArray3<'_, f32>>()?;
            (Voxels::from(values(&array)?), shape(array.as_untyped())?)
        };
        let volume = io::Volume::new(name, dimensions, spacing, voxels).map_err(Failure::from)?;
        let volume = if (scale, offset) == (1.0, 0.0) {
            volume
        } else {
            volume.with_value_mapping(scale, offset).map_err(Failure::from)?
        };
        Ok(Self(Arc::new(volume)))
    }

    /// The volume placed in the world: `columns` are the world's steps along the index axes x, y and z.
    fn placed(&self, columns: [[f64; 3]; 3], origin: Option<[f64; 3]>, orientation: &str) -> PyResult<Self> {
        let known = [Orientation::Patient, Orientation::World, Orientation::Unknown];
        let orientation = known.into_iter().find(|known| known.name() == orientation).unwrap_or_default();
        let volume = io::Volume::clone(&self.0).with_placement(columns, origin, orientation).map_err(Failure::from)?;
        Ok(Self(Arc::new(volume)))
    }

    /// The volume with other distances along x, y and z; its middle stays where it is.
    fn with_spacing(&self, spacing: [f32; 3]) -> PyResult<Self> {
        let volume = io::Volume::clone(&self.0).with_spacing(spacing).map_err(Failure::from)?;
        Ok(Self(Arc::new(volume)))
    }

    /// The stored voxels, (z, y, x), read-only and without a copy.
    #[getter]
    fn array<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        let volume = &slf.get().0;
        volume.require_whole("an array").map_err(Failure::from)?;
        let [x, y, z] = volume.dimensions.map(|size| size as usize);
        let shape = [z, y, x];
        let owner = slf.clone().into_any();
        Ok(match &volume.voxels {
            Voxels::U8(voxels) => array::lent(voxels, &shape, owner)?.into_any(),
            Voxels::U16(voxels) => array::lent(voxels, &shape, owner)?.into_any(),
            Voxels::F32(voxels) => array::lent(voxels, &shape, owner)?.into_any(),
        })
    }

    /// Voxels along x, y and z.
    #[getter]
    fn dimensions(&self) -> [u32; 3] {
        self.0.dimensions
    }

    /// The type of the stored voxels, as NumPy names it.
    #[getter]
    fn dtype(&self) -> &'static str {
        match self.0.voxels {
            Voxels::U8(_) => "uint8",
            Voxels::U16(_) => "uint16",
            Voxels::F32(_) => "float32",
        }
    }

    /// Whether the voxels stay in their file.
    #[getter]
    fn is_paged(&self) -> bool {
        self.0.paged.is_some()
    }

    #[getter]
    fn name(&self) -> &str {
        &self.0.name
    }

    /// Scale and offset: `physical = stored * scale + offset`.
    #[getter]
    fn value_mapping(&self) -> [f32; 2] {
        [self.0.value_scale, self.0.value_offset]
    }

    /// Distances between voxels along x, y and z.
    #[getter]
    fn spacing(&self) -> [f32; 3] {
        self.0.spacing
    }

    #[getter]
    fn origin(&self) -> [f32; 3] {
        self.0.origin
    }

    #[getter]
    fn axes(&self) -> [[f32; 3]; 3] {
        self.0.axes
    }

    #[getter]
    fn orientation(&self) -> &'static str {
        self.0.orientation.name()
    }

    /// Least and greatest physical value.
    #[getter]
    fn range(&self) -> [f32; 2] {
        self.0.range
    }

    /// What its reader took for granted.
    #[getter]
    fn notes(&self) -> Vec<String> {
        self.0.source.assumptions.iter().map(ToString::to_string).collect()
    }

    /// Numbers, names and colours (sRGB) of labels; `None` of measurements.
    #[getter]
    fn labels(&self) -> Option<Vec<Label>> {
        let labels = self.0.source.labels()?;
        Some(labels.list.iter().map(|label| (label.value, label.name.clone(), label.color)).collect())
    }

    /// The number of voxels in each of `bins` equal parts of a range.
    #[pyo3(signature = (bins, range = None))]
    fn histogram(&self, py: Python<'_>, bins: usize, range: Option<[f32; 2]>) -> PyResult<Vec<u64>> {
        if !(1..=1 << 20).contains(&bins) {
            return Err(Failure::value(format!("{bins} bins"), "ask for 1 to 1048576").into());
        }
        let range = range.unwrap_or(self.0.range);
        Ok(py.detach(|| self.0.histogram_over(range, bins)))
    }
}

/// Reads the volume of a file or a folder.
#[pyfunction]
#[pyo3(signature = (path, raw = None, array = None, time = None, seconds = None, up = None, spacing = None, max_bytes = None, paged = false))]
#[expect(clippy::too_many_arguments, reason = "each is a keyword of Python's `open`")]
pub fn open(
    py: Python<'_>,
    path: PathBuf,
    raw: Option<&str>,
    array: Option<String>,
    time: Option<u32>,
    seconds: Option<f64>,
    up: Option<&str>,
    spacing: Option<[f32; 3]>,
    max_bytes: Option<u64>,
    paged: bool,
) -> PyResult<Py<PyAny>> {
    let wrong = |problem: String| Failure::value(problem, "see the documentation of `open`");
    let options = OpenOptions {
        max_bytes,
        paged,
        raw: raw.map(str::parse).transpose().map_err(wrong)?,
        spacing,
        array,
        time,
        seconds,
        up: up.map(str::parse).transpose().map_err(wrong)?,
    };
    let threads = process::threads()?;
    if options.raw.is_none() && is_mesh(&path) {
        let read =
            |_: &mut (dyn FnMut(vitrum::Progress) -> bool + Send)| Ok(threads.run(|| io::open_mesh(&path, &options))?);
        let mesh = work::run(py, None, read)?;
        return Ok(Py::new(py, crate::mesh::Mesh(Arc::new(mesh)))?.into_any());
    }
    let read = |_: &mut (dyn FnMut(vitrum::Progress) -> bool + Send)| Ok(threads.run(|| io::open(&path, &options))?);
    let volume = work::run(py, None, read)?;
    Ok(Py::new(py, Volume(Arc::new(volume)))?.into_any())
}

/// The reader of volumes has the message for a file that cannot be looked at.
fn is_mesh(path: &Path) -> bool {
    io::is_mesh(path).unwrap_or(false)
}
