//! Cells of the medium's box, between which light that is scattered more than once is exchanged (the zone method: Hottel and Sarofim 1967).
//!
//! The light that arrives at a cell is described by its fluence and by how far it comes from one direction: its mean direction, and the length of
//! the mean of its unit directions. The light that the cell scatters has the phase function of Henyey and Greenstein around the mean direction, whose
//! mean cosine is the product of that length and of the medium's mean cosine: this is exact for light from one direction in such a medium, and
//! keeps the first moment of any other.

use crate::abi::beams::{BeamsUniforms, CELLS};
use crate::abi::record::{Cell, cell};
use crate::field::access::read;
use crate::math::{clamp, floor_to_int, length, max, min, sqrt, xyz};
use spirv_std::glam::Vec3;

/// The number of cells.
pub const COUNT: u32 = CELLS * CELLS * CELLS;

/// The middle of the cell in column `i`, row `j` and layer `k`, in voxels.
#[inline(always)]
pub fn middle(u: &BeamsUniforms, i: u32, j: u32, k: u32) -> Vec3 {
    let at = Vec3::new(i as f32 + 0.5, j as f32 + 0.5, k as f32 + 0.5);
    xyz(u.medium.low) + at * xyz(u.cells.edge)
}

/// The number of the cell that holds a position, which is limited to the medium's box.
#[inline(always)]
pub fn number_at(u: &BeamsUniforms, position: Vec3) -> i32 {
    let (low, edge) = (xyz(u.medium.low), xyz(u.cells.edge));
    let last = (CELLS - 1) as f32;
    let i = floor_to_int((position.x - low.x) / edge.x, 0.0, last);
    let j = floor_to_int((position.y - low.y) / edge.y, 0.0, last);
    let k = floor_to_int((position.z - low.z) / edge.z, 0.0, last);
    (k * CELLS as i32 + j) * CELLS as i32 + i
}

/// A cell with the fluence `fluence` and the sum of the light's directions, each by its fluence, `flow`.
#[inline(always)]
pub fn directed(fluence: Vec3, flow: Vec3, density: f32) -> Cell {
    let fluence = Vec3::new(max(fluence.x, 0.0), max(fluence.y, 0.0), max(fluence.z, 0.0));
    let whole = ((fluence.x + fluence.y) + fluence.z) * (1.0 / 3.0);
    let along = length(flow);
    Cell {
        fluence,
        direction: flow * (1.0 / max(along, 1e-30)),
        directed: min(along / max(whole, 1e-30), 1.0),
        density,
    }
}

/// The record of cell number `number`.
#[inline(always)]
pub fn cell_of(cells: &[f32], number: i32) -> Cell {
    let component = |component: usize| read(cells, component as i32 * COUNT as i32 + number);
    let vector = |at: usize| Vec3::new(component(at), component(at + 1), component(at + 2));
    Cell {
        fluence: vector(cell::FLUENCE),
        direction: vector(cell::DIRECTION),
        directed: component(cell::DIRECTED),
        density: component(cell::DENSITY),
    }
}

/// The fluence at a position, interpolated between the middles of cells.
#[inline(always)]
pub fn fluence_at(u: &BeamsUniforms, cells: &[f32], position: Vec3) -> Vec3 {
    let (low, edge) = (xyz(u.medium.low), xyz(u.cells.edge));
    let last = (CELLS - 1) as f32;
    let x = clamp((position.x - low.x) / edge.x - 0.5, 0.0, last);
    let y = clamp((position.y - low.y) / edge.y - 0.5, 0.0, last);
    let z = clamp((position.z - low.z) / edge.z - 0.5, 0.0, last);
    let (i, j, k) =
        (floor_to_int(x, 0.0, last - 1.0), floor_to_int(y, 0.0, last - 1.0), floor_to_int(z, 0.0, last - 1.0));
    let (fx, fy, fz) = (x - i as f32, y - j as f32, z - k as f32);
    let (row, layer) = (CELLS as i32, (CELLS * CELLS) as i32);
    let first = k * layer + j * row + i;
    let at = |number: i32| {
        let component = |channel: i32| read(cells, (cell::FLUENCE as i32 + channel) * COUNT as i32 + number);
        Vec3::new(component(0), component(1), component(2))
    };
    let along = |number: i32| at(number) * (1.0 - fx) + at(number + 1) * fx;
    let front = along(first) * (1.0 - fy) + along(first + row) * fy;
    let back = along(first + layer) * (1.0 - fy) + along(first + layer + row) * fy;
    front * (1.0 - fz) + back * fz
}

/// Henyey and Greenstein's phase function of mean cosine `g` over the isotropic one.
#[inline(always)]
pub fn henyey_greenstein(g: f32, cosine: f32) -> f32 {
    let base = max(1.0 + g * g - 2.0 * g * cosine, 1e-9);
    (1.0 - g * g) / (base * sqrt(base))
}
