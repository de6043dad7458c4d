//! Comparisons of pictures.

use crate::errors::Failure;
use numpy::{PyReadonlyArray3, PyUntypedArrayMethods};
use pyo3::prelude::*;
use vitrum_compare::compare;

/// Differences of two linear pictures (height, width, 3) of float32, as JSON.
#[pyfunction]
pub fn diff(py: Python<'_>, a: PyReadonlyArray3<'_, f32>, b: PyReadonlyArray3<'_, f32>) -> PyResult<String> {
    let size = |shape: &[usize]| (u32::try_from(shape[1]), u32::try_from(shape[0]));
    let (Ok(width), Ok(height)) = size(a.shape()) else {
        return Err(Failure::value("the picture is too large", "compare parts of it").into());
    };
    let pixels =
        |array: &PyReadonlyArray3<'_, f32>| -> PyResult<Vec<[f32; 3]>> { Ok(array.as_slice()?.as_chunks().0.to_vec()) };
    let (a, b) = (pixels(&a)?, pixels(&b)?);
    let compared = py.detach(|| compare(&a, &b, width, height));
    let compared = compared.map_err(|error| Failure::value(error.to_string(), "compare pictures of one size"))?;
    // Infinite values have no word in JSON and are null.
    let json = serde_json::json!({
        "max_abs": compared.max_abs,
        "rmse": compared.rmse,
        "psnr": compared.psnr,
        "mean_flip": compared.mean_flip,
        "peak": compared.peak,
        "worst_pixel": compared.worst_pixel(),
    });
    Ok(json.to_string())
}
