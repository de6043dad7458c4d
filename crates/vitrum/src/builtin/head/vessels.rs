//! The larger arteries and veins as smooth tubes.

use super::super::grid::Grid;
use super::super::shapes::{coverage, smooth_curve, tube};
use glam::Vec3;

/// Points along a vessel of the left half, from its root, and its radii at both ends, in world units.
type Vessel = (&'static [[f32; 3]], [f32; 2]);

/// The share of each voxel of the left half (x ≥ 0) that belongs to a vessel, 0 to 255.
pub(super) fn paint(grid: &Grid) -> Vec<u8> {
    let [width, height, depth] = grid.dimensions().map(|size| size as usize);
    let mut shares = vec![0; width * height * depth];
    for (points, radii) in VESSELS {
        let through: Vec<Vec3> = points.iter().copied().map(Vec3::from_array).collect();
        let curve = smooth_curve(&through);
        let last = (curve.len() - 1) as f32;
        let end = |index: usize| {
            let share = index as f32 / last;
            (curve[index], radii[0] + (radii[1] - radii[0]) * share)
        };
        for index in 1..curve.len() {
            paint_tube(grid, [end(index - 1), end(index)], &mut shares);
        }
    }
    shares
}

fn paint_tube(grid: &Grid, ends: [(Vec3, f32); 2], shares: &mut [u8]) {
    let edge = 3.0 * grid.spacing();
    let size = grid.dimensions();
    let reach = Vec3::splat(ends[0].1.max(ends[1].1) + edge);
    let first = grid.position([0; 3]);
    // The casts saturate: what lies outside the grid is cut off.
    let low = (ends[0].0.min(ends[1].0) - reach - first) / grid.spacing();
    let high = (ends[0].0.max(ends[1].0) + reach - first) / grid.spacing();
    let range = |axis: usize| low[axis] as u32..(high[axis] as u32 + 1).min(size[axis]);
    for z in range(2) {
        for y in range(1) {
            for x in range(0) {
                let share = coverage(tube(grid.position([x, y, z]), ends[0], ends[1]), edge);
                let stored = &mut shares[(x + size[0] * (y + size[1] * z)) as usize];
                *stored = (*stored).max((share * 255.0 + 0.5) as u8);
            }
        }
    }
}

#[rustfmt::skip]
const VESSELS: &[Vessel] = &[
    // Common and internal carotid artery, middle cerebral artery and its branches.
    (&[[0.17, 0.02, -1.05], [0.18, 0.01, -0.75], [0.17, 0.02, -0.55], [0.14, -0.02, -0.32], [0.15, 0.03, -0.12],
       [0.10, 0.08, -0.02], [0.09, 0.12, 0.08], [0.17, 0.12, 0.13], [0.26, 0.06, 0.20]], [0.042, 0.026]),
    (&[[0.26, 0.06, 0.20], [0.31, -0.02, 0.32], [0.33, -0.16, 0.42], [0.29, -0.30, 0.50]], [0.024, 0.014]),
    (&[[0.26, 0.06, 0.20], [0.31, 0.08, 0.30], [0.31, 0.12, 0.45], [0.26, 0.14, 0.60]], [0.024, 0.014]),
    (&[[0.31, -0.02, 0.32], [0.34, -0.04, 0.44], [0.30, -0.03, 0.60]], [0.020, 0.013]),
    // Anterior cerebral artery, over the corpus callosum.
    (&[[0.09, 0.12, 0.08], [0.035, 0.17, 0.12], [0.03, 0.29, 0.26], [0.025, 0.30, 0.46], [0.025, 0.14, 0.62],
       [0.025, -0.10, 0.66], [0.025, -0.30, 0.58]], [0.022, 0.013]),
    // Vertebral and basilar artery, posterior cerebral artery.
    (&[[0.15, -0.22, -1.05], [0.15, -0.20, -0.60], [0.15, -0.22, -0.28], [0.10, -0.28, -0.20], [0.02, -0.06, -0.08]],
     [0.026, 0.024]),
    (&[[0.0, -0.04, -0.10], [0.0, 0.02, 0.02], [0.0, 0.02, 0.12], [0.08, -0.04, 0.16], [0.13, -0.20, 0.20],
       [0.09, -0.40, 0.28]], [0.026, 0.014]),
    // External carotid and superficial temporal artery.
    (&[[0.17, 0.02, -0.55], [0.24, 0.02, -0.42], [0.33, -0.02, -0.22], [0.375, 0.02, 0.02], [0.415, 0.06, 0.18],
       [0.430, 0.10, 0.34], [0.39, 0.24, 0.48], [0.32, 0.34, 0.58]], [0.030, 0.012]),
    (&[[0.415, 0.06, 0.18], [0.437, 0.02, 0.34], [0.435, -0.08, 0.48], [0.395, -0.17, 0.63], [0.32, -0.22, 0.76]],
     [0.018, 0.011]),
    // Facial artery.
    (&[[0.19, 0.02, -0.50], [0.26, 0.14, -0.44], [0.27, 0.26, -0.40], [0.22, 0.38, -0.28], [0.14, 0.47, -0.14],
       [0.085, 0.50, 0.00]], [0.022, 0.011]),
    // Superior sagittal and transverse sinus, internal jugular vein.
    (&[[0.0, 0.40, 0.46], [0.0, 0.28, 0.69], [0.0, 0.06, 0.82], [0.0, -0.22, 0.80], [0.0, -0.44, 0.62],
       [0.0, -0.54, 0.40], [0.03, -0.54, 0.22], [0.18, -0.48, 0.14], [0.31, -0.30, 0.08], [0.29, -0.14, -0.04],
       [0.22, -0.08, -0.18], [0.25, -0.06, -0.45], [0.27, -0.04, -0.75], [0.25, 0.00, -1.05]], [0.024, 0.046]),
    // External jugular vein.
    (&[[0.36, -0.06, -0.22], [0.35, -0.10, -0.45], [0.335, -0.08, -0.75], [0.33, -0.04, -1.05]], [0.020, 0.028]),
];
