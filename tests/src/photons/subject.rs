//! A scene whose light is followed both by the sweep and by photons.

use vitrum::backend::CpuBackend;
use vitrum::method::View;
use vitrum::method::sweep::{LightGrid, Planes, Sweep};
use vitrum::scene::Transport;

use super::{Field, blocks, irradiance, misplaced};
use crate::Failure;
use crate::case::Case;
use crate::closed_forms::light_on_planes;

/// Texels along each side of the blocks over which light is compared: the sweep and a count of photons blur differently.
const BLOCK: usize = 4;

/// A scene, and the sweep's light on three of its planes, carried on texels and as sheets: a third, two thirds and all of the way from
/// the volume's middle to the last plane.
pub struct Subject {
    case: Case,
    grid: LightGrid,
    planes: Planes,
    at: [u32; 3],
    texels: Vec<Vec<f64>>,
    sheets: Vec<Vec<f64>>,
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
    /// A built-in scene as a picture of `edge` × `edge` pixels with volumes of `resolution` voxels, its light crisp.
    ///
    /// # Errors
    /// If there is no such scene, or the backend fails.
    pub fn new(scene: &str, edge: u32, resolution: u32) -> Result<Self, Failure> {
        let case = Case::builtin(scene, edge, Some(resolution), &["light.0.angular_radius=0", "light.0.elevation=20"])?;
        let (_, texels) = light(&case, Transport::Texels)?;
        let (sweep, sheets) = light(&case, Transport::Sheets)?;
        let (grid, planes) = (sweep.light_grid, sweep.planes);
        Ok(Self { case, grid, planes, at: at(&planes), texels, sheets })
    }

    /// The texels of a plane.
    #[must_use]
    pub fn texels(&self) -> u32 {
        self.grid.size[0] * self.grid.size[1]
    }

    /// The photons' light on the three planes, with `across` × `across` of them for each texel.
    #[must_use]
    pub fn photons(&self, across: u32) -> Vec<Vec<f64>> {
        let volume = self.case.volume();
        let view = View::new(&self.case.scene, volume);
        let field = Field::new(volume, &self.case.scene, &view);
        irradiance(&field, &self.grid, &self.planes, &self.at, across)
    }

    /// The sweep's light against photons, plane by plane.
    #[must_use]
    pub fn sweep_against(&self, carried: Transport, photons: &[Vec<f64>]) -> Vec<Compared> {
        let light = match carried {
            Transport::Texels => &self.texels,
            Transport::Sheets => &self.sheets,
        };
        self.compare(photons, light)
    }

    /// Light on the three planes against a reference, plane by plane.
    #[must_use]
    pub fn compare(&self, reference: &[Vec<f64>], found: &[Vec<f64>]) -> Vec<Compared> {
        let of = |light: &[f64]| blocks(light, self.grid.size, BLOCK);
        let flux = |light: &[f64]| light.iter().sum::<f64>();
        let compared = |(reference, found): (&Vec<f64>, &Vec<f64>)| Compared {
            misplaced: misplaced(&of(reference), &of(found)),
            flux: flux(found) / flux(reference),
        };
        reference.iter().zip(found).map(compared).collect()
    }
}

/// A third, two thirds and all of the way from the volume's middle to the last plane.
fn at(planes: &Planes) -> [u32; 3] {
    let middle = planes.behind / 2;
    [1, 2, 3].map(|third| middle + (planes.count - 1 - middle) * third / 3)
}

/// The sweep's light on the three planes over that on the first.
fn light(case: &Case, carried: Transport) -> Result<(Sweep, Vec<Vec<f64>>), Failure> {
    let mut scene = case.scene.clone();
    scene.sweep.light = carried;
    let mut backend = CpuBackend::new(None)?;
    let mut sweep = Sweep::prepare(&scene, &case.assets, case.request, &mut backend)?;
    let at = at(&sweep.planes);
    let (mut unoccluded, mut light) = (1.0, Vec::new());
    light_on_planes(
        &mut sweep,
        &mut backend,
        |plane| plane == 0 || at.contains(&plane),
        |plane, red| {
            if plane == 0 {
                unoccluded = f64::from(red[0]);
            } else {
                light.push(red.iter().map(|&e| f64::from(e) / unoccluded).collect());
            }
        },
    );
    Ok((sweep, light))
}
