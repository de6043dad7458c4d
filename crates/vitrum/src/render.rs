//! From a scene to a frame.

use crate::backend::{Backend, BackendError, KernelTime};
use crate::frame::{Frame, Pixel, Rays, Statistics, rgb, rgba, xyz};
use crate::inputs::Inputs;
use crate::method::sweep::{self, Sweep};
use crate::scene::{Method, Scene, SceneError};
use crate::session::Session;
use std::time::Instant;
use vitrum_io::Picture;
use vitrum_kernels::abi::record::{film, status};

/// Why a frame could not be made.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// A file could not be read or written, or is not valid.
    #[error(transparent)]
    Io(#[from] vitrum_io::Error),
    /// A scene file is not valid.
    #[error(transparent)]
    SceneFile(#[from] SceneError),
    /// The scene asks for something impossible.
    #[error("{0}")]
    Scene(String),
    /// The backend failed.
    #[error(transparent)]
    Backend(#[from] BackendError),
}

impl Error {
    /// The program's exit code: 2 for a memory limit that is too low, 3 for inputs, 4 for devices.
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::Io(_) | Self::SceneFile(_) | Self::Scene(_) => 3,
            Self::Backend(error) if error.is_of_use() => 2,
            Self::Backend(_) => 4,
        }
    }

    /// What to do about it, if that is not in the message.
    pub fn help(&self) -> Option<String> {
        match self {
            Self::Backend(error) => error.help().map(str::to_owned),
            Self::Io(_) | Self::SceneFile(_) | Self::Scene(_) => None,
        }
    }

    /// Whether the caller cancelled.
    pub fn is_cancelled(&self) -> bool {
        matches!(self, Self::Backend(BackendError::Cancelled))
    }
}

/// How far a frame is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Progress {
    /// Planes done.
    pub done: u32,
    /// All planes.
    pub total: u32,
}

/// Outputs that cost time of their own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Wanted {
    /// The light on the last plane. Without it, light is carried only where viewing rays can see it, and a frame may end as soon as every
    /// ray has.
    pub light: bool,
}

impl Default for Wanted {
    fn default() -> Self {
        Self { light: true }
    }
}

/// Whether a frame of a scene can be made of its inputs, as far as that can be told without a backend and without work.
///
/// # Errors
/// [`Error::SceneFile`] where a key is out of its range, [`Error::Scene`] where what is seen and lit makes no frame, as when the light
/// shines towards the camera.
pub fn check(scene: &Scene, inputs: &Inputs) -> Result<(), Error> {
    scene.validate()?;
    if let Some(mesh) = inputs.mesh.as_ref().filter(|mesh| mesh.surface_area() == 0.0) {
        let (name, count) = (&mesh.name, mesh.triangles.len());
        return Err(Error::Scene(format!(
            "{name}: none of its {count} triangles has an area; give a mesh that has a surface"
        )));
    }
    match scene.method {
        Method::Sweep => sweep::check(scene, inputs),
        Method::Voxels => Ok(()),
    }
}

/// Renders a scene with all outputs. `progress` is called from time to time and cancels the frame by returning `false`.
///
/// # Errors
/// Those of [`check`]; [`Error::Backend`] where the backend lacks the memory or fails, or `progress` cancels.
pub fn render(
    scene: &Scene,
    inputs: &Inputs,
    backend: &mut dyn Backend,
    progress: &mut dyn FnMut(Progress) -> bool,
) -> Result<Frame, Error> {
    render_wanted(scene, inputs, Wanted::default(), backend, progress)
}

/// Renders a scene with the outputs that are wanted. Each is the same as with all.
///
/// # Errors
/// As [`render`].
pub fn render_wanted(
    scene: &Scene,
    inputs: &Inputs,
    wanted: Wanted,
    backend: &mut dyn Backend,
    progress: &mut dyn FnMut(Progress) -> bool,
) -> Result<Frame, Error> {
    scene.validate()?;
    Session::new(inputs, backend)?.render(scene, wanted, progress)
}

/// What a frame that was run has made.
pub(crate) struct Exposure {
    /// Planar records, see [`film`].
    pub film: Vec<f32>,
    /// Irradiance, if wanted: see [`Sweep::irradiance`].
    pub light: Option<Vec<f32>>,
    /// Time to run it and read it back.
    pub frame_ms: f64,
    /// What of it the kernels took.
    pub kernels: Vec<KernelTime>,
}

/// Runs a prepared frame and reads its outputs; `progress` is told the planes that are done.
pub(crate) fn expose(
    sweep: &Sweep,
    wanted: Wanted,
    backend: &mut dyn Backend,
    progress: &mut dyn FnMut(u32) -> bool,
) -> Result<Exposure, Error> {
    let started = Instant::now();
    backend.take_kernel_times();
    sweep.run(backend, progress)?;
    let film = sweep.film(backend)?;
    let frame_ms = started.elapsed().as_secs_f64() * 1e3;
    let light = if wanted.light { Some(sweep.irradiance(backend)?) } else { None };
    Ok(Exposure { film, light, frame_ms, kernels: backend.take_kernel_times() })
}

/// A frame of what a sweep has made.
pub(crate) fn develop(
    scene: &Scene,
    sweep: &Sweep,
    exposure: &Exposure,
    backend: &mut dyn Backend,
    upload_ms: f64,
) -> Frame {
    let (width, height) = (scene.film.width, scene.film.height);
    let rays = sweep.rays[0] as usize * sweep.rays[1] as usize;
    let turned = exposure.film[film::STATUS * rays..].iter().filter(|&&fate| fate == status::TURNED).count();
    let frame = Frame {
        width,
        height,
        layers: layers(scene, &exposure.film),
        light: exposure.light.as_ref().map(|light| light_picture(sweep, light)),
        statistics: Statistics {
            planes: sweep.planes.count,
            light_texels: sweep.light_grid.size,
            rays_turned: turned as u64,
            frame_ms: vec![exposure.frame_ms],
            upload_ms: Some(upload_ms),
            kernels: exposure.kernels.clone(),
            ..Statistics::of(scene, backend)
        },
    };
    frame.expose(scene.film.exposure)
}

fn layers(scene: &Scene, records: &[f32]) -> Vec<vitrum_io::Layer> {
    let size = [scene.film.width, scene.film.height];
    let rays = Rays { records, size, edge: scene.film.supersampling };
    vec![
        rays.layer("color", Pixel::Mean, rgba(film::COLOR)),
        rays.layer("opacity", Pixel::Mean, [("Y", film::OPACITY)]),
        rays.layer("medium", Pixel::Mean, rgb(film::MEDIUM)),
        rays.layer("depth", Pixel::WeightedBy(film::OPACITY), [("Z", film::DEPTH)]),
        rays.layer("direction", Pixel::Direction, xyz(film::DIRECTION)),
        rays.layer("position", Pixel::Central, xyz(film::POSITION)),
        rays.layer("status", Pixel::Central, [("Y", film::STATUS)]),
    ]
}

/// The light on the last plane; the grid's rows go up, a picture's down.
fn light_picture(sweep: &Sweep, records: &[f32]) -> Picture {
    let [width, height] = sweep.light_grid.size;
    let texels = width as usize * height as usize;
    let pixels = (0..height as usize)
        .rev()
        .flat_map(|row| (0..width as usize).map(move |column| row * width as usize + column))
        .map(|at| [records[at], records[texels + at], records[2 * texels + at]])
        .collect();
    Picture::rgb(width, height, pixels)
}
