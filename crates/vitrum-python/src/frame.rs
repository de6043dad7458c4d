//! Finished pictures.

use crate::array;
use crate::errors::Failure;
use crate::scene::Scene;
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use std::path::PathBuf;
use vitrum::io::{self, Picture, PictureFormat, WriteOptions, encode_picture, write_picture_with};
use vitrum::scene;
use vitrum_annotations::{Overlay, file_picture, layers_of, screen_picture};

/// A finished picture, its scene, and the annotations over it.
#[pyclass(frozen, module = "vitrum_render._native")]
pub struct Frame {
    pub frame: vitrum::Frame,
    pub scene: scene::Scene,
    pub overlay: Option<Overlay>,
}

/// The channels of a layer, a pixel's side by side.
fn interleaved<'py>(py: Python<'py>, picture: &Picture) -> PyResult<Bound<'py, PyAny>> {
    let channels = picture.layers.first().map_or(&[][..], |layer| &layer.channels);
    let (width, height) = (picture.width as usize, picture.height as usize);
    let mut values = Vec::with_capacity(width * height * channels.len());
    for pixel in 0..width * height {
        values.extend(channels.iter().map(|channel| channel.data[pixel]));
    }
    let shape = [height, width, channels.len()];
    let shape = if channels.len() == 1 { &shape[..2] } else { &shape };
    Ok(array::given(py, values, shape)?.into_any())
}

impl Frame {
    /// The picture for a screen, with straight alpha and annotations.
    fn on_screen(&self, opaque: bool) -> Result<Picture, Failure> {
        let color = vitrum::Frame {
            layers: self.frame.layers.iter().take(1).cloned().collect(),
            light: None,
            ..self.frame.clone()
        };
        Ok(screen_picture(color, self.overlay.as_ref(), opaque)?)
    }
}

#[pymethods]
impl Frame {
    #[getter]
    fn size(&self) -> (u32, u32) {
        (self.frame.width, self.frame.height)
    }

    /// Names of the outputs that it has.
    #[getter]
    fn outputs(&self) -> Vec<&str> {
        let layers = self.frame.layers.iter().map(|layer| layer.name.as_str());
        layers.chain(self.frame.light.as_ref().map(|_| "light")).collect()
    }

    /// An output: float32, (height, width) or (height, width, channels).
    fn output<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Option<Bound<'py, PyAny>>> {
        self.frame.aov(name).map(|picture| interleaved(py, &picture)).transpose()
    }

    /// Names of an output's channels.
    fn channels(&self, name: &str) -> Option<Vec<String>> {
        let picture = self.frame.aov(name)?;
        let channels = picture.layers.into_iter().next()?.channels;
        Some(channels.into_iter().map(|channel| channel.name).collect())
    }

    /// Red, green, blue and a straight alpha with the annotations, as 8-bit sRGB: uint8, (height, width, 4).
    fn to_srgb8<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let picture = py.detach(|| self.on_screen(false))?;
        let code = |value: f32| (value.clamp(0.0, 1.0) * 255.0 + 0.5) as u8;
        let channels = picture.layers.first().map_or(&[][..], |layer| &layer.channels);
        let (width, height) = (picture.width as usize, picture.height as usize);
        let mut bytes = Vec::with_capacity(width * height * channels.len());
        for pixel in 0..width * height {
            bytes.extend(channels.iter().map(|channel| {
                let value = channel.data[pixel];
                code(if channel.name == "A" { value } else { io::linear_to_srgb(value) })
            }));
        }
        Ok(array::given(py, bytes, &[height, width, channels.len()])?.into_any())
    }

    /// The bytes of a file of that format, such as `png` or `jpg`.
    fn encode<'py>(&self, py: Python<'py>, format: &str) -> PyResult<Bound<'py, PyBytes>> {
        let bytes = py.detach(|| -> Result<Vec<u8>, Failure> {
            let file = PathBuf::from(format!("picture.{format}"));
            let format = PictureFormat::of_path(&file)?;
            let picture = file_picture(self.frame.clone(), self.overlay.as_ref(), &file)?;
            Ok(encode_picture(&picture, format, &[], &WriteOptions::default())?)
        })?;
        Ok(PyBytes::new(py, &bytes))
    }

    /// Writes the picture, in the format of the file's extension, with the scene as metadata.
    #[pyo3(signature = (path, bits = 8))]
    fn save(&self, py: Python<'_>, path: PathBuf, bits: u8) -> PyResult<()> {
        if !matches!(bits, 8 | 16) {
            return Err(Failure::value(format!("bits={bits}"), "8 or 16").into());
        }
        py.detach(|| -> Result<(), Failure> {
            let metadata = self.frame.metadata(&self.scene)?;
            let kept = layers_of(&path);
            let layers = self.frame.layers.iter().filter(|layer| kept.has(&layer.name)).cloned().collect();
            let frame = vitrum::Frame { layers, light: None, ..self.frame.clone() };
            let picture = file_picture(frame, self.overlay.as_ref(), &path)?;
            let options = WriteOptions { png_bits: bits, ..WriteOptions::default() };
            Ok(write_picture_with(&path, &picture, &metadata, &options)?)
        })?;
        Ok(())
    }

    /// Sizes, counts and times, as JSON.
    fn statistics(&self) -> String {
        serde_json::to_string(&self.frame.statistics).unwrap_or_default()
    }

    /// The annotations as an SVG document; `None` where the scene has none.
    fn annotations(&self) -> Option<&str> {
        self.overlay.as_ref().map(Overlay::svg)
    }

    #[getter]
    fn scene(&self) -> Scene {
        Scene(self.scene.clone())
    }
}
