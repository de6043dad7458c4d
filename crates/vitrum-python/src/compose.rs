//! Scenes composed of data, a preset and settings, and the data that they show.

use crate::errors::Failure;
use crate::mesh::Mesh;
use crate::process;
use crate::scene::Scene;
use crate::volume::Volume;
use crate::work;
use pyo3::prelude::*;
use std::path::PathBuf;
use std::sync::Arc;
use vitrum::composition::{Composition, Quality, Side};
use vitrum::preset::{Adjustments, Surface};
use vitrum::scene::{self, EnvironmentKind, Interpolation, VolumeSource};
use vitrum::{Assets, Subject};

/// A scene, and the data that it shows.
#[pyclass(frozen, module = "vitrum_render._native")]
pub struct Composed {
    scene: scene::Scene,
    /// What a preset took for granted.
    #[pyo3(get)]
    notes: Vec<String>,
    pub data: Data,
}

/// The data that a scene shows, and how it is found.
#[derive(Clone)]
pub struct Data {
    pub assets: Assets,
    /// The keys that name data, of the scene that the assets belong to.
    sources: scene::Scene,
    base: PathBuf,
    /// The volume or the mesh that no file holds.
    memory: Option<Subject>,
    max_bytes: Option<u64>,
}

impl Data {
    /// Reads anew what another scene names, where that differs; whether it did.
    pub fn follow(&mut self, scene: &scene::Scene) -> Result<bool, Failure> {
        let sources = sources(scene);
        if sources == self.sources {
            return Ok(false);
        }
        self.assets = loaded(self.memory.as_ref(), scene, &self.base, self.max_bytes)?;
        self.sources = sources;
        Ok(true)
    }
}

fn loaded(
    memory: Option<&Subject>,
    scene: &scene::Scene,
    base: &std::path::Path,
    max_bytes: Option<u64>,
) -> Result<Assets, Failure> {
    Ok(match memory {
        Some(subject) => Assets::of_memory(subject, scene, base, max_bytes)?,
        None => Assets::load_within(scene, base, max_bytes)?,
    })
}

/// A scene with the keys alone that name or place data.
fn sources(scene: &scene::Scene) -> scene::Scene {
    let mut sources = scene::Scene {
        volume: VolumeSource { interpolation: Interpolation::default(), ..scene.volume.clone() },
        ior_volume: scene.ior_volume.clone(),
        mesh: scene.mesh.clone(),
        light: scene.light.clone(),
        ..scene::Scene::default()
    };
    sources.light = sources.light.into_iter().filter_map(|light| light.texture).map(textured).collect();
    if scene.environment.kind == EnvironmentKind::Map {
        sources.environment.kind = EnvironmentKind::Map;
        sources.environment.file.clone_from(&scene.environment.file);
    }
    sources.medium = scene
        .medium
        .as_ref()
        .and_then(|medium| medium.density.clone())
        .map(|density| scene::Medium { density: Some(density), ..scene::Medium::default() });
    sources
}

fn textured(texture: PathBuf) -> scene::Light {
    scene::Light { texture: Some(texture), ..scene::Light::default() }
}

/// The volume or the mesh of a Python object; `None` for `None`.
pub fn subject(data: Option<&Bound<'_, PyAny>>) -> PyResult<Option<Subject>> {
    let Some(data) = data else { return Ok(None) };
    if let Ok(volume) = data.cast::<Volume>() {
        return Ok(Some(Subject::Volume(Arc::clone(&volume.get().0))));
    }
    Ok(Some(Subject::Mesh(Arc::clone(&data.cast::<Mesh>()?.get().0))))
}

#[pymethods]
impl Composed {
    #[getter]
    fn scene(&self) -> Scene {
        Scene(self.scene.clone())
    }
}

/// Composes a scene of an input's name, or of data in memory.
#[pyfunction]
#[pyo3(signature = (
    input, data = None, preset = None, medium = None, quality = None, transfer = None, threshold = None, window = None, colormap = None,
    isosurfaces = Vec::new(), size = None, view = None, settings = Vec::new(), max_bytes = None
))]
#[expect(clippy::too_many_arguments, reason = "each is a keyword of Python's `render`")]
pub fn compose(
    py: Python<'_>,
    input: String,
    data: Option<&Bound<'_, PyAny>>,
    preset: Option<String>,
    medium: Option<String>,
    quality: Option<&str>,
    transfer: Option<PathBuf>,
    threshold: Option<f32>,
    window: Option<[f32; 2]>,
    colormap: Option<String>,
    isosurfaces: Vec<String>,
    size: Option<[u32; 2]>,
    view: Option<&str>,
    settings: Vec<String>,
    max_bytes: Option<u64>,
) -> PyResult<Composed> {
    let quality = quality.map(|name| match name {
        "draft" => Ok(Quality::Draft),
        "good" => Ok(Quality::Good),
        "best" => Ok(Quality::Best),
        other => {
            Err(Failure::value(format!("there is no quality {other:?}"), "the qualities are draft, good and best"))
        }
    });
    let surface =
        |text: &String| text.parse::<Surface>().map_err(|problem| Failure::value(problem, "see `isosurfaces`"));
    let side = view.map(|name| {
        let known = Side::ALL.into_iter().find(|side| side.name() == name);
        let sides = Side::ALL.map(Side::name).join(", ");
        known.ok_or_else(|| Failure::value(format!("there is no side {name:?}"), format!("the sides are {sides}")))
    });
    let composition = Composition {
        input,
        preset,
        medium,
        quality: quality.transpose()?,
        transfer,
        adjustments: Adjustments {
            threshold,
            window,
            colormap,
            isosurfaces: isosurfaces.iter().map(surface).collect::<Result<_, _>>()?,
            ..Adjustments::default()
        },
        size,
        side: side.transpose()?,
        settings,
        max_bytes,
        ..Composition::default()
    };
    let memory = subject(data)?;
    let threads = process::threads()?;
    let composed = work::run(py, None, |_| {
        let composed = threads.run(|| match &memory {
            Some(subject) => composition.compose_of(subject),
            None => composition.compose(),
        })?;
        // A frame that can never be is told before a device is opened.
        vitrum::check(&composed.scene, &composed.assets)?;
        Ok(composed)
    })?;
    let data =
        Data { sources: sources(&composed.scene), assets: composed.assets, base: composed.base, memory, max_bytes };
    Ok(Composed { scene: composed.scene, notes: composed.notes, data })
}

/// The data of a scene that is complete already: data in memory, or the files that the scene names, whose relative paths start at `base`.
#[pyfunction]
#[pyo3(signature = (scene, data = None, base = PathBuf::new(), max_bytes = None))]
pub fn load(
    py: Python<'_>,
    scene: &Scene,
    data: Option<&Bound<'_, PyAny>>,
    base: PathBuf,
    max_bytes: Option<u64>,
) -> PyResult<Composed> {
    let memory = subject(data)?;
    let threads = process::threads()?;
    let scene = scene.0.clone();
    let assets = work::run(py, None, |_| {
        let assets = threads.run(|| loaded(memory.as_ref(), &scene, &base, max_bytes))?;
        vitrum::check(&scene, &assets)?;
        Ok(assets)
    })?;
    let data = Data { assets, sources: sources(&scene), base, memory, max_bytes };
    Ok(Composed { scene, notes: Vec::new(), data })
}
