//! A scene whose light is followed both by the sweep and by photons.

use vitrum::backend::CpuBackend;
use vitrum::method::sweep::{LightGrid, Planes, Sweep, View};

use super::{Field, blocks, irradiance, misplaced};
use crate::Failure;
use crate::case::Case;

/// Texels along each side of the blocks over which light is compared: the sweep and a count of photons blur differently.
const BLOCK: usize = 4;

/// A scene, and the sweep's light on three of its planes: a third, two thirds and all of the way from the volume's middle to the last
/// plane.
pub struct Subject {
    case: Case,
    grid: LightGrid,
    planes: Planes,
    at: [u32; 3],
    light: Vec<Vec<f64>>,
}

/// What a plane's light is against the photons'.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Compared {
    /// The share of the photons' light that is somewhere else.
    pub misplaced: f64,
    /// The flux over that of the photons.
    pub flux: f64,
}

impl Subject {
    /// A built-in scene as a picture of `edge` × `edge` pixels with volumes of `resolution` voxels, its light crisp.
    ///
    /// # Errors
    /// If there is no such scene, or the backend fails.
    pub fn new(scene: &str, edge: u32, resolution: u32) -> Result<Self, Failure> {
        let case = Case::builtin(scene, edge, Some(resolution), &["light.softness=0", "light.elevation=20"])?;
        let mut backend = CpuBackend::new(None)?;
        let mut sweep = Sweep::prepare(&case.scene, &case.inputs, &mut backend)?;
        let (grid, planes) = (sweep.light_grid, sweep.planes);
        let middle = planes.behind / 2;
        let at = [1, 2, 3].map(|third| middle + (planes.count - 1 - middle) * third / 3);
        let texels = (grid.size[0] * grid.size[1]) as usize;
        let (mut plane, mut unoccluded, mut light) = (0, 0.0f64, Vec::new());
        for pass in std::mem::take(&mut sweep.passes.passes) {
            let concentrates = pass.kernel.declaration.name == "sweep_concentrate_light";
            sweep.passes.passes.push(pass);
            if concentrates {
                if plane == 0 || at.contains(&plane) {
                    sweep.run(&mut backend, &mut |_| true)?;
                    sweep.passes.passes.clear();
                    let red = sweep.irradiance(&mut backend)?[..texels].to_vec();
                    unoccluded = if plane == 0 { f64::from(red[0]) } else { unoccluded };
                    light.push(red.iter().map(|&e| f64::from(e) / unoccluded).collect());
                }
                plane += 1;
            }
        }
        sweep.free(&mut backend);
        light.remove(0);
        Ok(Self { case, grid, planes, at, light })
    }

    /// The texels of a plane.
    #[must_use]
    pub fn texels(&self) -> u32 {
        self.grid.size[0] * self.grid.size[1]
    }

    /// The photons' light on the three planes, with `across` × `across` of them for each texel.
    #[must_use]
    pub fn photons(&self, across: u32) -> Vec<Vec<f64>> {
        let volume = &self.case.inputs.volume;
        let view = View::new(&self.case.scene, volume);
        let field = Field::new(volume, &self.case.scene.transfer, &view);
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
        let of = |light: &[f64]| blocks(light, self.grid.size, BLOCK);
        let flux = |light: &[f64]| light.iter().sum::<f64>();
        let compared = |(reference, found): (&Vec<f64>, &Vec<f64>)| Compared {
            misplaced: misplaced(&of(reference), &of(found)),
            flux: flux(found) / flux(reference),
        };
        reference.iter().zip(found).map(compared).collect()
    }
}
