//! Thin viewing rays: pixels so small that they see a line. Beside the edge of a caustic a usual pixel would see both sides of the edge.

use vitrum::backend::Backend;
use vitrum::method::{Cache, Job};
use vitrum_conformance::Failure;
use vitrum_conformance::case::Case;
use vitrum_kernels::glam::DVec3;

/// Pixels of the picture along each edge: the viewing ray of the one in the middle goes along the camera's axis.
pub const PIXELS: u32 = 3;

/// The width of a pixel, in radians.
const WIDTH: f64 = 1e-4;

/// The field of view where the zoom is 1, in degrees: the narrowest there is.
const FIELD: f64 = 1.0;

/// The distance from the eye to the camera's target. The target is rounded to 10⁻⁷ of its coordinates, the direction to less.
const AHEAD: f64 = 8.0;

/// What a viewing ray sees: radiance, linear RGB.
#[derive(Debug, Clone, Copy)]
pub struct Look {
    pub airlight: [f64; 3],
    pub caustics: [f64; 3],
    pub shadow: [f64; 3],
    pub surfaces: [f64; 3],
    pub multiple: [f64; 3],
}

/// A case on a backend, at which one looks along thin rays.
pub struct Thin<'a> {
    case: Case,
    cache: Cache,
    backend: &'a mut dyn Backend,
}

impl<'a> Thin<'a> {
    pub fn new(mut case: Case, backend: &'a mut dyn Backend) -> Self {
        case.resize(PIXELS);
        let half = f64::from(PIXELS) * 0.5 * WIDTH;
        case.scene.camera.field_of_view = FIELD as f32;
        case.scene.camera.zoom = ((0.5 * FIELD).to_radians().tan() / half) as f32;
        Self { case, cache: Cache::default(), backend }
    }

    /// What the ray from an eye through a point sees.
    pub fn look(&mut self, from: DVec3, through: DVec3) -> Result<Look, Failure> {
        let target = from + (through - from).normalize() * AHEAD;
        self.case.scene.camera.position = Some(from.as_vec3().to_array());
        self.case.scene.camera.target = Some(target.as_vec3().to_array());
        let job = Job { scene: &self.case.scene, assets: &self.case.assets, request: self.case.request };
        let frame = vitrum::frame(&job, &mut self.cache, self.backend, &mut |_| true)?;
        let middle = (PIXELS * PIXELS / 2) as usize;
        let color = |output: &str| {
            ["R", "G", "B"].map(|channel| {
                f64::from(frame.channel(output, channel).expect("frames of beams have the output")[middle])
            })
        };
        Ok(Look {
            airlight: color("airlight"),
            caustics: color("caustics"),
            shadow: color("shadow"),
            surfaces: color("surfaces"),
            multiple: color("multiple"),
        })
    }

    /// Changes a setting for the looks that follow.
    pub fn set(&mut self, setting: &str) -> Result<(), Failure> {
        Ok(self.case.scene.set(setting)?)
    }
}
