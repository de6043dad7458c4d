//! Metadata of a picture's file.

use super::Frame;
use crate::scene::{Scene, SceneError};

impl Frame {
    /// Entries for the picture's file, from which it can be rendered again: the program, the scene of the frame, the backend, the camera.
    ///
    /// # Errors
    /// Those of [`Scene::to_toml`].
    pub fn metadata(&self, scene: &Scene) -> Result<Vec<(String, String)>, SceneError> {
        let statistics = &self.statistics;
        let camera = statistics.camera.as_ref();
        let text = |value: Option<serde_json::Value>| value.unwrap_or_default().to_string();
        let entries = [
            ("Software", format!("vitrum {}", statistics.version)),
            ("vitrum.scene", scene.to_toml()?),
            ("vitrum.backend", statistics.backend.clone()),
            ("vitrum.adapter", statistics.adapter.clone()),
            ("vitrum.pixel_size", text(camera.map(|camera| camera.pixel_size.into()))),
            ("vitrum.view", text(camera.map(|camera| serde_json::json!(camera.view)))),
            ("vitrum.projection", text(camera.map(|camera| serde_json::json!(camera.projection)))),
        ];
        Ok(entries.map(|(key, value)| (key.to_owned(), value)).into())
    }
}
