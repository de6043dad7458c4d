//! Scenes, whose comfortable face is `vitrum_render/scene.py`.

use crate::errors::Failure;
use pyo3::prelude::*;
use std::path::PathBuf;
use vitrum::scene;

/// A scene.
#[pyclass(module = "vitrum_render._native")]
#[derive(Clone)]
pub struct Scene(pub scene::Scene);

#[pymethods]
impl Scene {
    /// The scene of a scene file's text, which `name` stands for in messages; the defaults without one.
    #[new]
    #[pyo3(signature = (toml = None, name = "scene"))]
    fn new(toml: Option<&str>, name: &str) -> PyResult<Self> {
        let Some(toml) = toml else { return Ok(Self(scene::Scene::default())) };
        Ok(Self(scene::Scene::from_toml(toml, name).map_err(Failure::from)?))
    }

    /// The scene of [`Self::to_json`], whose keys may be in the making.
    #[staticmethod]
    fn of_json(text: &str) -> PyResult<Self> {
        let failed = |error: serde_json::Error| Failure::value(error.to_string(), "give the text of a scene in JSON");
        Ok(Self(serde_json::from_str(text).map_err(failed)?))
    }

    /// The scene with paths that start at no folder, where relative ones started at this.
    fn free_of(&self, folder: PathBuf) -> Self {
        let mut scene = self.0.clone();
        scene.free_of(&folder);
        Self(scene)
    }

    /// Sets a key, by `KEY=VALUE` in the language of `--set`.
    fn set(&mut self, assignment: &str) -> PyResult<()> {
        Ok(self.0.set(assignment).map_err(Failure::from)?)
    }

    /// Fails where keys contradict each other.
    fn check(&self) -> PyResult<()> {
        Ok(self.0.check_settings().map_err(Failure::from)?)
    }

    /// The text of a scene file.
    fn to_toml(&self) -> PyResult<String> {
        Ok(self.0.to_toml().map_err(Failure::from)?)
    }

    /// Every key that has a value, as JSON.
    fn to_json(&self) -> PyResult<String> {
        let failed =
            |error: serde_json::Error| Failure::value(error.to_string(), "use file names that are valid Unicode");
        Ok(serde_json::to_string(&self.0).map_err(failed)?)
    }

    fn copy(&self) -> Self {
        self.clone()
    }

    fn __eq__(&self, other: &Self) -> bool {
        self.0 == other.0
    }
}
