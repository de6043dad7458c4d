//! A scene whose light is followed both by the sweep and by photons.

use vitrum::backend::CpuBackend;
use vitrum::method::View;
use vitrum::method::sweep::{LightGrid, Planes, Sweep};
use vitrum::scene::Transport;
use vitrum_kernels::glam::DVec3;

use super::{Field, Slopes, blocks, irradiance, misplaced};
use crate::Failure;
use crate::case::Case;
use crate::closed_forms::light_on_planes;

/// Texels along each side of the blocks over which light on texels is compared: the sweep and a count of photons blur differently.
const BLOCK: usize = 4;

/// A scene, and the sweep's light on three of its planes: a third, two thirds and all of the way from the volume's middle to the last plane.
pub struct Subject {
    case: Case,
    view: View,
    grid: LightGrid,
    planes: Planes,
    at: [u32; 3],
    light: Vec<Vec<f64>>,
    /// Texels, or cells, along each side of the blocks over which light is compared.
    block: usize,
}

/// The difference of a plane's light from the photons'.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Compared {
    /// The share of the photons' light that is somewhere else.
    pub misplaced: f64,
    /// The plane's flux, over the flux of the photons.
    pub flux: f64,
}

impl Subject {
    /// A built-in scene as a picture of `edge` × `edge` pixels with volumes of `resolution` voxels, its light crisp and `carried` from plane to plane.
    /// It has no receivers: light of the sweep ends there, photons do not.
    ///
    /// # Errors
    /// If there is no such scene, or the backend fails.
    pub fn new(scene: &str, edge: u32, resolution: u32, carried: Transport) -> Result<Self, Failure> {
        let settings = ["light.0.angular_radius=0", "light.0.elevation=20"];
        let mut case = Case::builtin(scene, edge, Some(resolution), &settings)?;
        (case.scene.ground, case.scene.wall) = (None, None);
        case.scene.sweep.light = carried;
        // Two cells for a texel, as the default has for small volumes, and blocks of twice as many: they are as large.
        case.scene.sweep.light_cells = Some(2 * edge);
        let block = if carried == Transport::Forward { 2 * BLOCK } else { BLOCK };
        let mut backend = CpuBackend::new(None)?;
        let sweep = Sweep::prepare(&case.scene, &case.assets, case.request, &mut backend)?;
        let planes = sweep.light_planes();
        let forward = sweep.light_view();
        // A wavefront travels along the axis of its own frame.
        let direction = forward.map_or(sweep.light_grid.direction, |_| DVec3::Z);
        let grid = LightGrid { direction, ..sweep.light_grid };
        let view = forward.unwrap_or_else(|| View::new(&case.scene, case.volume()));
        let at = at(&planes, last(&case, &planes, forward.is_some())?);
        let light = light(&sweep, &mut backend, at);
        Ok(Self { case, view, grid, planes, at, light, block })
    }

    /// The texels of a plane, or the cells of a wavefront.
    #[must_use]
    pub fn texels(&self) -> u32 {
        self.grid.size[0] * self.grid.size[1]
    }

    /// The photons' light on the three planes, with `across` × `across` of them for each texel, in a medium of such slopes.
    #[must_use]
    pub fn photons(&self, across: u32, slopes: Slopes) -> Vec<Vec<f64>> {
        let field = Field::new(self.case.volume(), &self.case.scene, &self.view, slopes);
        irradiance(&field, &self.grid, &self.planes, &self.at, across)
    }

    /// The sweep's light against photons, plane by plane.
    #[must_use]
    pub fn sweep_against(&self, photons: &[Vec<f64>]) -> Vec<Compared> {
        self.compare(photons, &self.light)
    }

    /// Light on the three planes against a reference, plane by plane.
    #[must_use]
    pub fn compare(&self, reference: &[Vec<f64>], found: &[Vec<f64>]) -> Vec<Compared> {
        let of = |light: &[f64]| blocks(light, self.grid.size, self.block);
        let flux = |light: &[f64]| light.iter().sum::<f64>();
        let compared = |(reference, found): (&Vec<f64>, &Vec<f64>)| Compared {
            misplaced: misplaced(&of(reference), &of(found)),
            flux: flux(found) / flux(reference),
        };
        reference.iter().zip(found).map(compared).collect()
    }
}

/// The last plane that is looked at. A wavefront's planes end behind the volume; from there on its light is known as far as one likes, and is looked at
/// as far as light on texels goes.
fn last(case: &Case, planes: &Planes, forward: bool) -> Result<u32, Failure> {
    let last = planes.count - 1;
    if !forward {
        return Ok(last);
    }
    let mut scene = case.scene.clone();
    scene.sweep.light = Transport::Texels;
    let on_texels = Sweep::prepare(&scene, &case.assets, case.request, &mut CpuBackend::new(None)?)?;
    let behind = |planes: &Planes, plane: u32| planes.depth(plane) - planes.volume_depths.iter().sum::<f64>() * 0.5;
    let wanted = behind(&on_texels.planes, on_texels.planes.count - 1) / on_texels.light_grid.direction.z;
    Ok((last..).find(|&plane| behind(planes, plane) >= wanted).unwrap_or(last))
}

/// A third, two thirds and all of the way from the volume's middle to plane `last`.
fn at(planes: &Planes, last: u32) -> [u32; 3] {
    let middle = planes.behind / 2;
    [1, 2, 3].map(|third| middle + (last - middle) * third / 3)
}

/// The sweep's light on the three planes over that on the first.
fn light(sweep: &Sweep, backend: &mut CpuBackend, at: [u32; 3]) -> Vec<Vec<f64>> {
    let (mut unoccluded, mut light) = (1.0, Vec::new());
    light_on_planes(
        sweep,
        backend,
        |plane| plane == 0 || at.contains(&plane),
        |plane, red| {
            if plane == 0 {
                unoccluded = f64::from(red[0]);
            } else {
                light.push(red.iter().map(|&e| f64::from(e) / unoccluded).collect());
            }
        },
    );
    light
}
