//! Light that the medium scatters more than once: the table of what its cells exchange, and the passes.

use super::list::List;
use super::lit::Lit;
use super::uniforms::{flux_of_texel, units_in_one};
use crate::backend::{Backend, BackendError, Buffer};
use crate::method::cache::Scratch;
use vitrum_kernels::abi::beams::{BeamsUniforms, CELLS, Cells, Medium, target};
use vitrum_kernels::abi::record::{cell, deposit};
use vitrum_kernels::beams::cells::COUNT;
use vitrum_kernels::kernel::kernels;

/// Distance of two cells along each axis, in cells, up to which 1 / r² varies much over them.
const NEAR: u32 = 2;
/// Half the number of differences of two points along each axis, of near cells.
const POINTS: u32 = 8;
/// Units of a sum of light in the light of one texel over the length of a cell: small enough for the faint ends of beams.
const UNITS: f64 = 1_048_576.0;

fn components(v: vitrum_kernels::abi::vector::Vec3) -> [f64; 3] {
    [v.x, v.y, v.z].map(f64::from)
}

/// The cells of a frame's medium. `mean_cosine` belongs to the phase function; the table begins at float `first` of the materials.
pub(super) fn cells(block: &BeamsUniforms, mean_cosine: f64, first: u32) -> Cells {
    let edge = edges(&block.medium);
    let usual = flux_of_texel(block) * edge.iter().sum::<f64>() / 3.0;
    let scale = units_in_one(UNITS, usual);
    let edge = edge.map(|edge| edge as f32).into();
    Cells { edge, scale, mean_cosine: mean_cosine as f32, first }
}

/// Edges of a cell, in voxels.
fn edges(medium: &Medium) -> [f64; 3] {
    let [low, high] = [medium.low, medium.high].map(components);
    std::array::from_fn(|axis| (high[axis] - low[axis]) / f64::from(CELLS))
}

/// Weights, and differences of the coordinates of two points over the edge of a cell: of points that are evenly distributed over two cells `apart` along an axis,
/// differences are distributed as a triangle. Near cells take `2 · POINTS` of them, or times `finer`; others the three of Gauss's rule for a triangle.
fn differences(apart: u32, near: bool, finer: u32) -> Vec<[f64; 2]> {
    let apart = f64::from(apart);
    if !near {
        let (weight, away) = (5.0 / 24.0, 0.4f64.sqrt());
        return vec![[weight, apart - away], [1.0 - 2.0 * weight, apart], [weight, apart + away]];
    }
    let points = POINTS * finer;
    (0..2 * points)
        .map(|point| {
            let difference = (f64::from(point) + 0.5) / f64::from(points) - 1.0;
            [(1.0 - difference.abs()) / f64::from(points), apart + difference]
        })
        .collect()
}

/// What two cells exchange: the means over both of e^(−σ_t r) / r² for each channel, and the mean of r / r² by it over the channels.
fn exchanged(apart: [u32; 3], edge: [f64; 3], extinction: [f64; 3], finer: u32) -> [f64; 4] {
    let near = apart.iter().all(|&apart| apart <= NEAR);
    let [along_x, along_y, along_z] = apart.map(|apart| differences(apart, near, finer));
    let mut sums = [0.0; 4];
    for [x_weight, x] in &along_x {
        for [y_weight, y] in &along_y {
            for [z_weight, z] in &along_z {
                let way = [x * edge[0], y * edge[1], z * edge[2]];
                let squared = way[0] * way[0] + way[1] * way[1] + way[2] * way[2];
                let distance = squared.sqrt();
                let weight = x_weight * y_weight * z_weight / squared;
                for channel in 0..3 {
                    let share = weight * libm::exp(-extinction[channel] * distance);
                    sums[channel] += share;
                    sums[3] += share * distance / 3.0;
                }
            }
        }
    }
    sums
}

/// The table of what cells exchange where the density is 1, by their distances along the axes, x fastest: the volume of a cell times the mean over two
/// cells of e^(−σ_t r) / r², in voxels, for each channel, and the mean distance r by that weight, the mean of the channels.
pub(super) fn table(medium: &Medium) -> Vec<f32> {
    let edge = edges(medium);
    let extinction = components(medium.extinction);
    let volume = edge[0] * edge[1] * edge[2];
    let count = COUNT as usize;
    let mut table = vec![0.0; 4 * count];
    for number in 0..COUNT {
        let apart = [number % CELLS, number / CELLS % CELLS, number / (CELLS * CELLS)];
        let mut sums = exchanged(apart, edge, extinction, 1);
        if number == 0 {
            // Within a cell the error is that of 1 / r² around 0, in proportion to the distance of points.
            let finer = exchanged(apart, edge, extinction, 2);
            sums = std::array::from_fn(|component| 2.0 * finer[component] - sums[component]);
        }
        let [r, g, b, lengths] = sums;
        let mean = (r + g + b) / 3.0;
        let distance = if mean > 0.0 { lengths / mean } else { 0.0 };
        for (component, value) in [r * volume, g * volume, b * volume, distance].into_iter().enumerate() {
            table[component * count + number as usize] = value as f32;
        }
    }
    table
}

/// Lists the passes in which the medium's cells exchange light, `orders` − 1 times, and gives the buffer of the cells' light towards the eye.
pub(super) fn list(
    list: &mut List,
    lights: &[&Lit],
    [pictures, materials]: [&Buffer; 2],
    orders: u32,
    scratch: &mut Scratch,
    backend: &mut dyn Backend,
) -> Result<Buffer, BackendError> {
    let cells = [CELLS, CELLS * CELLS];
    let mut zeros = |label: &'static str, components: usize| {
        scratch.zeros(label, u64::from(COUNT) * components as u64 * 4, backend)
    };
    let sums = zeros("light of beams in cells", deposit::SIZE)?;
    let direct = zeros("cells of the medium", cell::SIZE)?;
    let [first, second] = [zeros("light of cells", cell::SIZE)?, zeros("further light of cells", cell::SIZE)?];
    let towards_eye = zeros("light of cells towards the eye", cell::SIZE)?;
    for lit in lights {
        lit.describe(list);
        let beams = [lit.lattice.count * lit.lattice.count, 1];
        for round in 0..=lit.limits.last {
            list.add(&kernels::beams_deposit_beam, beams, (0, round), &[&lit.beams, materials, &sums], 0);
        }
    }
    list.add(&kernels::beams_light_cell, cells, (0, 0), &[&sums, pictures, materials, &direct], 0);
    let (mut from, mut to) = (&first, &second);
    for _ in 2..orders {
        list.add(&kernels::beams_exchange_light, cells, (target::CELLS, 0), &[&direct, from, materials, to], 0);
        (from, to) = (to, from);
    }
    list.add(&kernels::beams_exchange_light, cells, (target::EYE, 0), &[&direct, from, materials, &towards_eye], 0);
    Ok(towards_eye)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    /// The share of light that is met within half the edge of the cube around a point, ∫ σ e^(−σ r) / 4π r² dV, by angle.
    fn met_in_cube(extinction: f64, half: f64) -> f64 {
        const STEPS: u32 = 400;
        let mut escapes = 0.0;
        // One of the six faces, at z = half: its solid angle is ∫ da / r³ · half.
        for (i, j) in (0..STEPS).flat_map(|i| (0..STEPS).map(move |j| (i, j))) {
            let at = |i: u32| ((f64::from(i) + 0.5) / f64::from(STEPS) * 2.0 - 1.0) * half;
            let distance = (at(i) * at(i) + at(j) * at(j) + half * half).sqrt();
            let area = 4.0 * half * half / f64::from(STEPS * STEPS);
            escapes += area * half / (distance * distance * distance) * libm::exp(-extinction * distance);
        }
        1.0 - 6.0 * escapes / (4.0 * PI)
    }

    /// All light that a cell scatters arrives somewhere: the sum over the cells around one, as far as the table reaches, is the share of light that is met
    /// there. The cube around is that of the other cell's middle, and half a cell more blurred by the cell's own size: for dense media it does not matter.
    #[test]
    fn no_light_is_lost_between_cells() {
        // Optical depth of a cell, and the largest error: a thin medium is seen to the end of the table, where cells end within a cell's width.
        for (extinction, bound) in [(0.1, 0.01), (0.35, 0.004), (1.0, 0.003)] {
            let edge = 1.0f32;
            let medium = Medium {
                extinction: [extinction as f32; 3].into(),
                high: [edge * CELLS as f32; 3].into(),
                ..Medium::default()
            };
            let table = table(&medium);
            let reach = CELLS as i32 - 1;
            let mut sum = 0.0;
            for (x, y, z) in (-reach..=reach)
                .flat_map(|x| (-reach..=reach).flat_map(move |y| (-reach..=reach).map(move |z| (x, y, z))))
            {
                let [x, y, z] = [x, y, z].map(i32::unsigned_abs);
                sum += f64::from(table[((z * CELLS + y) * CELLS + x) as usize]);
            }
            let met = sum * extinction / (4.0 * PI);
            let right = met_in_cube(extinction, f64::from(reach) + 0.5);
            println!("{extinction}: {met} of {right}");
            assert!((met / right - 1.0).abs() < bound, "{extinction}: {met} and {right} is right");
        }
    }
}
