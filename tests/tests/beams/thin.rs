//! Thin viewing rays: pixels so small that they see a line. Beside the edge of a caustic a usual pixel would see both sides of the edge.

use super::light::Light;
use vitrum::backend::{Backend, ReadBack as _};
use vitrum::method::beams::Beams;
use vitrum::method::{Cache, Job, Method as _, Tools};
use vitrum_conformance::Failure;
use vitrum_conformance::case::Case;
use vitrum_kernels::abi::record::beam_pixel;
use vitrum_kernels::glam::DVec3;

/// Pixels of the picture along each edge: the viewing ray of the one in the middle goes along the camera's axis.
pub const PIXELS: u32 = 3;

/// The pixel in the middle.
const MIDDLE: usize = (PIXELS * PIXELS / 2) as usize;

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

impl Look {
    /// A look, whose outputs `color` knows by their names and their places in the film's records.
    fn new(color: impl Fn(&str, usize) -> [f64; 3]) -> Self {
        Self {
            airlight: color("airlight", beam_pixel::AIRLIGHT),
            caustics: color("caustics", beam_pixel::CAUSTICS),
            shadow: color("shadow", beam_pixel::SHADOW),
            surfaces: color("surfaces", beam_pixel::SURFACES),
            multiple: color("multiple", beam_pixel::MULTIPLE),
        }
    }

    /// All of it.
    pub fn all(self) -> Vec<f64> {
        [self.airlight, self.caustics, self.shadow, self.surfaces, self.multiple].concat()
    }
}

/// A case on a backend, at which one looks along thin rays.
pub struct Thin<'a> {
    case: Case,
    cache: Cache,
    /// The light of the first look, which all looks see.
    light: Option<Light>,
    backend: &'a mut dyn Backend,
}

impl<'a> Thin<'a> {
    pub fn new(mut case: Case, backend: &'a mut dyn Backend) -> Self {
        case.resize(PIXELS);
        let half = f64::from(PIXELS) * 0.5 * WIDTH;
        case.scene.camera.field_of_view = FIELD as f32;
        case.scene.camera.zoom = ((0.5 * FIELD).to_radians().tan() / half) as f32;
        Self { case, cache: Cache::default(), light: None, backend }
    }

    /// Turns the camera from an eye to a point.
    fn turn(&mut self, from: DVec3, through: DVec3) {
        let target = from + (through - from).normalize() * AHEAD;
        self.case.scene.camera.position = Some(from.as_vec3().to_array());
        self.case.scene.camera.target = Some(target.as_vec3().to_array());
    }

    /// What the ray from an eye through a point sees, by the light that the first look has traced.
    pub fn look(&mut self, from: DVec3, through: DVec3) -> Result<Look, Failure> {
        self.turn(from, through);
        let Case { scene, assets, request, .. } = &self.case;
        assert_eq!(Beams.exposures(scene, assets).len(), 1, "the film would not be the picture");
        let job = Job { scene, assets, request: *request, chosen: None };
        // The light's frame keeps its buffers: the next frame takes others.
        let mut first = Cache::default();
        let cache = if self.light.is_none() { &mut first } else { &mut self.cache };
        let frame = Beams.prepare(&job, cache, &mut Tools { backend: self.backend, progress: &mut |_| true })?;
        let passes = match &self.light {
            Some(light) => light.seen_by(frame.passes()),
            None => frame.passes().clone(),
        };
        assert_eq!(frame.rays(), [PIXELS; 2], "the film would not be the picture");
        self.backend.run(&passes, &mut |_| true)?;
        let film: Vec<f32> = self.backend.read_all(frame.film())?;
        self.light.get_or_insert_with(|| Light::new(frame));
        Ok(Look::new(|_, first| {
            [0, 1, 2].map(|channel| f64::from(film[(first + channel) * (PIXELS * PIXELS) as usize + MIDDLE]))
        }))
    }

    /// As [`Self::look`], by a frame that traces its light itself.
    pub fn look_afresh(&mut self, from: DVec3, through: DVec3) -> Result<Look, Failure> {
        self.turn(from, through);
        let job = Job { scene: &self.case.scene, assets: &self.case.assets, request: self.case.request, chosen: None };
        let frame = vitrum::frame(&job, &mut Cache::default(), self.backend, &mut |_| true)?;
        let channel = |output: &str, name: &str| frame.channel(output, name).expect("frames of beams have the output");
        Ok(Look::new(|output, _| ["R", "G", "B"].map(|name| f64::from(channel(output, name)[MIDDLE]))))
    }

    /// Changes a setting for the looks that follow, whose light is traced anew.
    pub fn set(&mut self, setting: &str) -> Result<(), Failure> {
        self.light = None;
        Ok(self.case.scene.set(setting)?)
    }
}
