//! NumPy arrays from and of numbers in Rust.

use numpy::ndarray::{ArrayViewD, IxDyn};
use numpy::{Element, PyArrayDyn, PyArrayMethods, PyUntypedArrayMethods};
use pyo3::prelude::*;

/// A read-only array over numbers that `owner` keeps, without a copy.
pub fn lent<'py, T: Element>(
    values: &[T],
    shape: &[usize],
    owner: Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyArrayDyn<T>>> {
    let view = ArrayViewD::from_shape(IxDyn(shape), values)
        .map_err(|error| pyo3::exceptions::PyValueError::new_err(error.to_string()))?;
    // SAFETY: the array keeps `owner` alive, which holds the numbers and never changes or moves them: its fields are private to this package, which has no
    // method that does. The array is read-only, so that Python does not change them either.
    let array = unsafe { PyArrayDyn::borrow_from_array(&view, owner) };
    array.readwrite().make_nonwriteable();
    debug_assert_eq!(array.shape(), shape);
    Ok(array)
}

/// An array of its own, of these numbers.
pub fn given<'py, T: Element>(py: Python<'py>, values: Vec<T>, shape: &[usize]) -> PyResult<Bound<'py, PyArrayDyn<T>>> {
    numpy::PyArray1::from_vec(py, values).reshape(IxDyn(shape))
}
