//! What there is to choose from: presets, maps of colours, devices, keys, outputs, built-in scenes.

use pyo3::prelude::*;
use vitrum::scene::{Scene, describe_keys};
use vitrum::{backend, builtin, method, preset};

/// A name and a description.
type Row = (&'static str, &'static str);

/// The presets of volumes, then those of meshes.
#[pyfunction]
pub fn presets() -> Vec<Row> {
    preset::names().iter().chain(preset::mesh_names()).copied().collect()
}

/// Maps of colours.
#[pyfunction]
pub fn colormaps() -> Vec<Row> {
    preset::colormap_names().to_vec()
}

/// Built-in scenes.
#[pyfunction]
pub fn scenes() -> Vec<Row> {
    builtin::names().to_vec()
}

/// The devices that can render, as JSON.
#[pyfunction]
pub fn devices(py: Python<'_>) -> String {
    let devices = py.detach(backend::devices);
    serde_json::to_string(&devices).unwrap_or_default()
}

/// Scene keys: path, unit, range, default, meaning.
#[pyfunction]
pub fn keys() -> Vec<[String; 5]> {
    describe_keys().into_iter().map(|key| [key.path, key.unit, key.range, key.default, key.meaning]).collect()
}

/// The outputs of all methods: name and description.
#[pyfunction]
pub fn outputs() -> Vec<Row> {
    let mut rows: Vec<Row> = Vec::new();
    for (_, output) in method::outputs() {
        if rows.iter().all(|(name, _)| *name != output.name) {
            rows.push((output.name, output.description));
        }
    }
    rows
}

/// The JSON schema of scenes.
#[pyfunction]
pub fn schema() -> String {
    Scene::json_schema()
}

/// Vitrum's version.
#[pyfunction]
pub fn version() -> &'static str {
    env!("CARGO_PKG_VERSION")
}
