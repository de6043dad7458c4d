//! Statistics of a frame: sizes, counts, times, memory.

use crate::backend::{Backend, KernelTime};
use crate::method::CameraMatrices;
use crate::scene::Scene;
use serde::Serialize;

/// The fate of the flux of the light rays that come into the box around all bodies, in shares of it whose sum is 1.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize)]
pub struct FluxShares {
    /// Share that left all bodies by refraction or reflection, and the medium.
    pub escaped: f64,
    /// Share that met an opaque surface or a receiver.
    pub received: f64,
    /// Share that clear bodies and mirrors absorbed.
    pub absorbed: f64,
    /// Share that the medium scattered or absorbed.
    pub extinguished: f64,
    /// Share that was not followed: weak parts, and ways beyond the limits.
    pub lost: f64,
}

/// Statistics of a frame. An unknown value is `None`.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct Statistics {
    /// The method, as scenes name it.
    pub method: String,
    /// `cpu` or `gpu`.
    pub backend: String,
    /// The processor or graphics adapter.
    pub adapter: String,
    /// Pixels across.
    pub width: u32,
    /// Pixels down.
    pub height: u32,
    /// The camera: the size of a pixel, and matrices, in world units.
    pub camera: Option<CameraMatrices>,
    /// Voxels along x, y and z that a mesh was turned into.
    pub voxels: Option<[u32; 3]>,
    /// Rows of those voxels that go through holes of the mesh's surface and were left empty.
    pub open_rows: Option<u64>,
    /// Planes swept, of the plane sweep.
    pub planes: Option<u32>,
    /// Texels of the light grid across and up, of the plane sweep.
    pub light_texels: Option<[u32; 2]>,
    /// Pixels that were rendered anew with more rays (`film.refinement`).
    pub refined_pixels: Option<u64>,
    /// Dispatches of kernels.
    pub dispatches: u64,
    /// Rays that turned back or grazed the planes, and could not be followed, of the plane sweep.
    pub rays_terminated: Option<u64>,
    /// Rays that were still inside a mesh after as many surfaces as they may meet, of rays through a mesh.
    pub rays_trapped: Option<u64>,
    /// The flux of the first light's rays that come into the box around all bodies, at the last wavelength, by its fate, of beams.
    pub flux: Option<FluxShares>,
    /// Time of each frame, without uploads, in milliseconds.
    pub frame_ms: Vec<f64>,
    /// Time to build tables and fill buffers, in milliseconds.
    pub upload_ms: Option<f64>,
    /// The time of each kernel in the last frame; empty if the device has no clock.
    pub kernels: Vec<KernelTime>,
    /// The most memory the process had, in bytes.
    pub peak_rss_bytes: Option<u64>,
    /// Bytes of graphics memory in buffers.
    pub gpu_bytes: Option<u64>,
    /// Vitrum's version.
    pub version: String,
}

impl Statistics {
    /// The statistics of a frame that a backend has just finished, while its buffers still exist.
    pub(crate) fn of(scene: &Scene, backend: &mut dyn Backend) -> Self {
        Self {
            method: scene.method.as_str().to_owned(),
            backend: backend.name().to_owned(),
            adapter: backend.adapter(),
            width: scene.film.width,
            height: scene.film.height,
            kernels: backend.take_kernel_times(),
            gpu_bytes: backend.device_bytes(),
            version: env!("CARGO_PKG_VERSION").to_owned(),
            ..Self::default()
        }
    }

    /// With the most memory that the process had so far.
    pub(crate) fn with_peak(self) -> Self {
        Self { peak_rss_bytes: peak_rss_bytes(), ..self }
    }
}

/// The most memory this process had, where the system tells (Linux).
fn peak_rss_bytes() -> Option<u64> {
    let text = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = text.lines().find(|line| line.starts_with("VmHWM:"))?;
    let kibibytes: u64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(kibibytes * 1024)
}
