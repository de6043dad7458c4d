//! Light that the medium scatters more than once: the table of what its cells exchange, and the passes.

use super::passes::{List, Lit};
use crate::backend::{Backend, BackendError, Buffer};
use crate::method::cache::Scratch;
use vitrum_kernels::abi::beams::{BeamsUniforms, CELLS, Cells, Medium, target};
use vitrum_kernels::abi::record::{cell, deposit};
use vitrum_kernels::beams::cells::COUNT;
use vitrum_kernels::kernel::kernels;

/// Cells along an axis within which pairs are integrated over.
const NEAR: u32 = 2;
/// Points of a pair along each axis, an even number: none is where the distance is 0.
const POINTS: u32 = 16;
/// Units of a sum of light in the light of one texel over the length of a cell: small enough for the faint ends of beams.
const UNITS: f64 = 1_048_576.0;

fn components(v: vitrum_kernels::abi::vector::Vec3) -> [f64; 3] {
    [v.x, v.y, v.z].map(f64::from)
}

/// The cells of a frame's medium. `mean_cosine` belongs to the phase function; the table begins at float `first` of the materials.
pub(super) fn cells(block: &BeamsUniforms, mean_cosine: f64, first: u32) -> Cells {
    let edge = edges(&block.medium);
    let color = block.light.color;
    let strongest = f64::from(color.x.max(color.y).max(color.z));
    let texel = f64::from(block.lattice.step_across) * f64::from(block.lattice.step_upwards);
    let usual = strongest * texel * edge.iter().sum::<f64>() / 3.0;
    let scale = if usual > 0.0 { (UNITS / usual).min(1e30) as f32 } else { 1.0 };
    let edge = edge.map(|edge| edge as f32).into();
    Cells { edge, scale, mean_cosine: mean_cosine as f32, first }
}

/// Edges of a cell, in voxels.
fn edges(medium: &Medium) -> [f64; 3] {
    let [low, high] = [medium.low, medium.high].map(components);
    std::array::from_fn(|axis| (high[axis] - low[axis]) / f64::from(CELLS))
}

/// Calls `each` with the weights and the differences of coordinates, over the edge of a cell, of pairs of points of cells that are `apart` along an axis.
fn pairs(apart: u32, points: u32) -> impl Iterator<Item = (f64, f64)> + Clone {
    // Differences of two evenly distributed coordinates are distributed as a triangle.
    let whole: f64 = (0..2 * points).map(|point| 1.0 - difference(point, points).abs()).sum();
    (0..2 * points).map(move |point| {
        let by = difference(point, points);
        ((1.0 - by.abs()) / whole, f64::from(apart) + by)
    })
}

/// The difference of point number `point` of two times `points`, from −1 to 1.
fn difference(point: u32, points: u32) -> f64 {
    (f64::from(point) + 0.5) / f64::from(points) - 1.0
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
        let near = apart.iter().all(|&apart| apart <= NEAR);
        let mut sums = [0.0; 3];
        let (mut lengths, mut weights) = (0.0, 0.0);
        let mut add = |weight: f64, way: [f64; 3]| {
            let squared: f64 = (0..3).map(|axis| way[axis] * way[axis] * edge[axis] * edge[axis]).sum();
            let distance = squared.sqrt();
            for (sum, extinction) in sums.iter_mut().zip(extinction) {
                let share = weight * libm::exp(-extinction * distance) / squared;
                *sum += share;
                lengths += share * distance;
                weights += share;
            }
        };
        if near {
            for (x_weight, x) in pairs(apart[0], POINTS) {
                for (y_weight, y) in pairs(apart[1], POINTS) {
                    for (z_weight, z) in pairs(apart[2], POINTS) {
                        add(x_weight * y_weight * z_weight, [x, y, z]);
                    }
                }
            }
        } else {
            add(1.0, apart.map(f64::from));
        }
        for (channel, sum) in sums.into_iter().enumerate() {
            table[channel * count + number as usize] = (sum * volume) as f32;
        }
        table[3 * count + number as usize] = if weights > 0.0 { (lengths / weights) as f32 } else { 0.0 };
    }
    table
}

/// Lists the passes in which the medium's cells exchange light, `orders` − 1 times, and gives the buffer of the cells' light towards the eye.
pub(super) fn list(
    list: &mut List,
    lit: Option<&Lit>,
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
    if let Some(lit) = lit {
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
