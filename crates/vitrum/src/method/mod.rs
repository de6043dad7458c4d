//! Methods: the ways in which a scene becomes a picture.
//!
//! A [`Method`] turns a scene and its assets into a [`PreparedFrame`]: buffers on a backend, and a list of passes. [`ALL`] lists the
//! methods; the renderer, the outputs, the statistics, the program's help and the conformance suite go through that list.

pub mod beams;
mod brick_distances;
pub(crate) mod cache;
mod environment_lights;
mod lights;
mod sources;
pub mod spectrum;
mod surface;
pub mod sweep;
mod twist;
pub(crate) mod view;
pub mod voxelize;
pub mod voxels;

pub use cache::Cache;
pub use view::{Bounds, CameraMatrices, View};

use crate::assets::Assets;
use crate::backend::{Backend, BackendError, Buffer, Pass, PassList};
use crate::error::Error;
use crate::film::{Output, Statistics};
use crate::request::{OutputRequest, Progress};
use crate::scene::{MethodName, Scene};
use vitrum_io::Picture;
use vitrum_kernels::sweep::place::word;

/// Every method.
pub static ALL: [&dyn Method; 3] = [&sweep::PlaneSweep, &voxels::MeshRays, &beams::Beams];

/// A way in which a scene becomes a picture.
pub trait Method: Sync {
    /// The name of the method in scenes: a value of the key `method`.
    fn name(&self) -> MethodName;

    /// The outputs of the method's frames, `color` first, with their components in film records.
    fn outputs(&self) -> &'static [Output];

    /// Checks that a frame of a scene can be made of these assets, as far as that is decided without a backend and without work.
    ///
    /// # Errors
    /// [`Error::Unrenderable`] where the method cannot show the assets, or the scene's values together make no frame.
    fn check(&self, scene: &Scene, assets: &Assets) -> Result<(), Error>;

    /// The exposures whose weighted sum is the frame: at least one; those of the part [`Part::Whole`] come first.
    fn exposures(&self, scene: &Scene, assets: &Assets) -> Vec<Exposure> {
        lights::exposures(scene, assets.environment.as_deref())
    }

    /// Whether single pixels can be rendered anew with more rays ([`ChosenRays::Refined`]).
    fn refines(&self) -> bool {
        false
    }

    /// Whether a picture of a scene can be rendered in parts ([`ChosenRays::Tile`]), one after another, without doing anything twice.
    fn divides(&self, _scene: &Scene) -> bool {
        false
    }

    /// Whether ray number `ray` of planar records took much longer than a usual one.
    fn is_costly(&self, _records: &[f32], _ray: usize) -> bool {
        false
    }

    /// Allocates the buffers of an exposure and lists its passes. Data that the next frame reads again stays in `cache`.
    ///
    /// # Errors
    /// Those of [`Self::check`]; [`Error::Backend`] where the backend lacks the memory or fails, or `progress` cancels.
    fn prepare(&self, job: &Job<'_>, cache: &mut Cache, tools: &mut Tools<'_>)
    -> Result<Box<dyn PreparedFrame>, Error>;
}

/// The method of a name.
#[must_use]
pub fn of(name: MethodName) -> &'static dyn Method {
    match name {
        MethodName::Sweep => &sweep::PlaneSweep,
        MethodName::Voxels => &voxels::MeshRays,
        MethodName::Beams => &beams::Beams,
    }
}

/// Every output of any method, in the order of [`ALL`], with the methods whose frames have it.
pub fn outputs() -> impl Iterator<Item = (&'static dyn Method, &'static Output)> {
    ALL.into_iter().flat_map(|method| method.outputs().iter().map(move |output| (method, output)))
}

/// The part of a frame that is rendered by itself: one of the scenes whose weighted sum the picture is.
#[derive(Debug, Clone)]
pub struct Exposure {
    /// The scene of this exposure.
    pub scene: Scene,
    /// Weights of the exposure in the sum: linear red, green and blue.
    pub weights: [f32; 3],
    /// Distance of the exposure's rays from the reference rays, whose values outputs without a mean, such as depth, show: the exposure
    /// of the least distance supplies them.
    pub distance: f64,
    /// The outputs to which the exposure adds.
    pub part: Part,
}

/// The outputs that an exposure adds to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// All outputs.
    Whole,
    /// Radiance alone: the exposure has the light of a further source, and everything else is in another exposure.
    Light,
}

impl Exposure {
    /// The exposure of a scene that is the whole frame.
    #[must_use]
    pub fn whole(scene: Scene) -> Self {
        Self { scene, weights: [1.0; 3], distance: 0.0, part: Part::Whole }
    }
}

/// The description of an exposure that is to be prepared.
#[derive(Clone, Copy)]
pub struct Job<'a> {
    /// The exposure's scene.
    pub scene: &'a Scene,
    /// The data that the scene shows.
    pub assets: &'a Assets,
    /// The requested outputs.
    pub request: OutputRequest,
    /// The rays that are rendered; `None` for all that the scene says.
    pub chosen: Option<ChosenRays<'a>>,
}

/// Some of the rays of a picture.
#[derive(Debug, Clone, Copy)]
pub enum ChosenRays<'a> {
    /// Those of some pixels, more of them than the scene says.
    Refined(RefinedPixels<'a>),
    /// Those of a part of the picture.
    Tile(RayTile),
}

/// A rectangle of a picture's rays.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct RayTile {
    /// The column and the row of its first ray.
    pub first: [u32; 2],
    /// Rays across and down.
    pub size: [u32; 2],
}

impl RayTile {
    /// The places of its rays on the picture, row by row, each by [`word`].
    #[must_use]
    pub fn words(self) -> Vec<u32> {
        let Self { first, size } = self;
        let row = |y: u32| (0..size[0]).map(move |x| word(first[0] + x, first[1] + y));
        (0..size[1]).flat_map(row).collect()
    }
}

/// The pixels of a picture that are rendered anew with more rays.
#[derive(Debug, Clone, Copy)]
pub struct RefinedPixels<'a> {
    /// The pixels, by [`word`], side by side in rows of [`Self::COLUMNS`] that are all full.
    pub pixels: &'a [u32],
    /// Rays along each side of a pixel.
    pub edge: u32,
}

impl RefinedPixels<'_> {
    /// Pixels in a row: rays then fill the tiles in which they run together.
    pub const COLUMNS: u32 = 64;

    /// Pixels across and down, as they lie side by side.
    #[must_use]
    pub fn size(&self) -> [u32; 2] {
        [Self::COLUMNS, self.pixels.len() as u32 / Self::COLUMNS]
    }

    /// Rays across and down.
    #[must_use]
    pub fn rays(&self) -> [u32; 2] {
        self.size().map(|pixels| pixels * self.edge)
    }
}

/// The backend that a frame is prepared on, and the caller's progress function.
pub struct Tools<'a> {
    /// The backend.
    pub backend: &'a mut dyn Backend,
    /// Receives the progress of the preparation, and cancels it by returning `false`.
    pub progress: &'a mut (dyn FnMut(Progress) -> bool + Send),
}

/// An exposure that is ready to run: buffers on a backend and a list of passes. Its buffers are freed when it is dropped.
pub trait PreparedFrame {
    /// The passes, in order.
    fn passes(&self) -> &PassList;

    /// Viewing rays across and down.
    fn rays(&self) -> [u32; 2];

    /// The film: planar records, one for each viewing ray, with the components that the method's outputs name.
    fn film(&self) -> &Buffer;

    /// Runs the passes. `progress` receives the number of finished passes and the number of all, and cancels by returning `false`.
    ///
    /// # Errors
    /// As [`Backend::run`].
    fn run(
        &self,
        backend: &mut dyn Backend,
        progress: &mut (dyn FnMut(u64, u64) -> bool + Send),
    ) -> Result<(), BackendError> {
        let total = self.passes().passes.len() as u64;
        backend.run(self.passes(), &mut |done| progress(done as u64, total))?;
        self.arrive();
        Ok(())
    }

    /// Is called when all passes have run to their end.
    fn arrive(&self) {}

    /// The light on the last plane, in texels of its own, row 0 on top; `None` for a method that carries no light from plane to plane.
    ///
    /// # Errors
    /// As [`Backend::read`].
    fn light(&self, _backend: &mut dyn Backend) -> Result<Option<Picture>, BackendError> {
        Ok(None)
    }

    /// The plane that a pass leads to, where the method sweeps planes.
    fn plane(&self, _pass: &Pass) -> Option<u32> {
        None
    }

    /// Adds what the finished records of some rays tell to the statistics.
    fn count(&self, _film: &[f32], _statistics: &mut Statistics) {}

    /// Fills in the statistics that are the method's own; buffers are as the passes have left them.
    ///
    /// # Errors
    /// As [`Backend::read`].
    fn statistics(&self, backend: &mut dyn Backend, statistics: &mut Statistics) -> Result<(), BackendError>;
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn every_name_has_one_method() {
        let names: BTreeSet<&str> = ALL.iter().map(|method| method.name().as_str()).collect();
        assert_eq!(names.len(), ALL.len());
        for name in MethodName::ALL {
            assert_eq!(of(name).name(), name);
        }
    }

    #[test]
    fn every_component_of_a_record_is_shown_once() {
        for method in ALL {
            let name = method.name().as_str();
            let channels = method.outputs().iter().flat_map(|output| output.channels.iter().map(|channel| channel.1));
            let components: Vec<usize> = channels.collect();
            let different: BTreeSet<usize> = components.iter().copied().collect();
            assert_eq!(different.len(), components.len(), "{name}: a component is shown twice");
            assert_eq!(different.last(), Some(&(components.len() - 1)), "{name}: a component is not shown");
            assert_eq!(method.outputs()[0].name, "color", "{name}");
        }
    }
}
