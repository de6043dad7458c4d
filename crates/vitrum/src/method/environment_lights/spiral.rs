//! Directions as dense as an environment asks for.

use super::cells::{COLUMNS, Cell, ROWS, direction};
use glam::DVec3;
use std::f64::consts::PI;

/// The golden ratio less 1: turns from one point of a spiral to the next, up to whole ones.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// Points of a spiral from the zenith to the nadir, as dense as the root of the luminance of `cells`: each stands for the same share of
/// its integral.
///
/// Of points that quantize a plane with the least mean square, the density is the root of that of what is quantized (Gersho 1979).
pub(super) fn spiral(cells: &[Cell], count: u32) -> Vec<DVec3> {
    // The root of the mean luminance, times the solid angle.
    let densities: Vec<f64> = cells.iter().map(|cell| (cell.luminance * cell.solid_angle).sqrt()).collect();
    let rows: Vec<f64> = densities.chunks(COLUMNS).map(|row| row.iter().sum()).collect();
    (0..count)
        .map(|index| {
            let y = inverse(&rows, (f64::from(index) + 0.5) / f64::from(count));
            let row = (y as usize).min(ROWS - 1);
            let x = inverse(&densities[row * COLUMNS..][..COLUMNS], (f64::from(index) * GOLDEN).fract());
            direction(even(y), ROWS, x, COLUMNS)
        })
        .collect()
}

/// Where a share of the sum of `densities` lies before: an index and, behind the point, the share of its density.
fn inverse(densities: &[f64], share: f64) -> f64 {
    let mut left = share * densities.iter().sum::<f64>();
    for (index, &density) in densities.iter().enumerate() {
        if left < density {
            return index as f64 + left / density;
        }
        left -= density;
    }
    // Rounding alone leads here.
    densities.iter().rposition(|&density| density > 0.0).unwrap_or(0) as f64 + 0.5
}

/// The latitude, in rows, up to which the part of its row's area that `y` has behind the point lies.
fn even(y: f64) -> f64 {
    let row = y.floor();
    let edge = |row: f64| libm::cos(PI * row / ROWS as f64);
    let z = edge(row) + (edge(row + 1.0) - edge(row)) * (y - row);
    libm::acos(z) * ROWS as f64 / PI
}
