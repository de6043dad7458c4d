//! An independent reference for light: photons, followed one by one through the ray equation in double precision.
//!
//! It shares no code with the kernels, nor their idea: it follows light forwards, any number of directions may cross a point,
//! and what lands on a texel is counted.

mod field;
mod subject;
mod trace;

pub use field::{Field, Slopes};
pub use subject::{Compared, Subject};
pub use trace::Photon;

use rayon::prelude::*;
use vitrum::method::sweep::{LightGrid, Planes};
use vitrum_kernels::glam::DVec3;

/// Parts into which the rows of photons are dealt out.
const PARTS: u32 = 64;

/// The red light that falls on the texels of some planes, over that of unoccluded light.
///
/// `across` × `across` photons start in every texel of plane 0, at the centres of a regular subdivision, and are added up in an order
/// that does not depend on the number of threads: no two runs differ.
#[must_use]
pub fn irradiance(field: &Field, grid: &LightGrid, planes: &Planes, at: &[u32], across: u32) -> Vec<Vec<f64>> {
    let [width, height] = grid.size;
    let depths: Vec<f64> = at.iter().map(|&plane| planes.depth(plane)).collect();
    let share = 1.0 / f64::from(across * across);
    let of_rows = |first: u32| {
        let mut light = vec![vec![0.0; (width * height) as usize]; at.len()];
        for row in (first..height * across).step_by(PARTS as usize) {
            for column in 0..width * across {
                let texel = |index: u32| (f64::from(index) + 0.5) / f64::from(across) * grid.texel;
                let photon = Photon {
                    position: DVec3::new(grid.corner.x + texel(column), grid.corner.y + texel(row), planes.depth(0)),
                    direction: grid.direction * field.surroundings(),
                    weight: DVec3::ONE,
                };
                photon.follow(field, &depths, |plane, position, weight| {
                    let shift = grid.shear * (position.z - planes.depth(0));
                    let x = ((position.x - grid.corner.x - shift.x) / grid.texel).floor();
                    let y = ((position.y - grid.corner.y - shift.y) / grid.texel).floor();
                    if x >= 0.0 && y >= 0.0 && x < f64::from(width) && y < f64::from(height) {
                        light[plane][y as usize * width as usize + x as usize] += weight.x * share;
                    }
                });
            }
        }
        light
    };
    let parts: Vec<Vec<Vec<f64>>> = (0..PARTS).into_par_iter().map(of_rows).collect();
    let add =
        |plane: usize| (0..(width * height) as usize).map(|i| parts.iter().map(|part| part[plane][i]).sum()).collect();
    (0..at.len()).map(add).collect()
}

/// The mean over blocks of `edge` × `edge` texels, row by row; incomplete blocks at the ends are left out.
#[must_use]
pub fn blocks(light: &[f64], size: [u32; 2], edge: usize) -> Vec<f64> {
    let [width, height] = size.map(|n| n as usize);
    let block = |x: usize, y: usize| {
        let texels = (0..edge * edge).map(|i| light[(y * edge + i / edge) * width + x * edge + i % edge]);
        texels.sum::<f64>() / (edge * edge) as f64
    };
    (0..height / edge).flat_map(|y| (0..width / edge).map(move |x| (x, y))).map(|(x, y)| block(x, y)).collect()
}

/// The share of the reference's light that is somewhere else: half the sum of differences over the sum.
#[must_use]
pub fn misplaced(reference: &[f64], found: &[f64]) -> f64 {
    let difference: f64 = reference.iter().zip(found).map(|(a, b)| (a - b).abs()).sum();
    0.5 * difference / reference.iter().sum::<f64>()
}
