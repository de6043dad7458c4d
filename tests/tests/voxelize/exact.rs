//! Whether a triangle meets a box, in float64 by the separating axes of Akenine-Möller, voxel by voxel.

use vitrum::method::voxelize::Grid;
use vitrum_kernels::glam::DVec3;

/// Whether a triangle and the closed box around `centre`, `half` to each side, have a point in common, as far as float64 tells.
pub fn meets(centre: DVec3, half: f64, triangle: [DVec3; 3]) -> bool {
    let [a, b, c] = triangle.map(|corner| corner - centre);
    let edges = [b - a, c - b, a - c];
    let apart = |axis: DVec3| {
        let reach = half * (axis.x.abs() + axis.y.abs() + axis.z.abs());
        let along = [a, b, c].map(|corner| axis.dot(corner));
        let low = along.into_iter().fold(f64::INFINITY, f64::min);
        let high = along.into_iter().fold(f64::NEG_INFINITY, f64::max);
        low > reach || high < -reach
    };
    let faces = [DVec3::X, DVec3::Y, DVec3::Z];
    let crosses = faces.into_iter().flat_map(|face| edges.map(|edge| face.cross(edge)));
    !faces.into_iter().chain([edges[0].cross(edges[1])]).chain(crosses).any(apart)
}

/// A triangle in voxels from the grid's low corner.
pub fn in_voxels(grid: &Grid, corners: [[f32; 3]; 3]) -> [DVec3; 3] {
    let low = DVec3::from_array(grid.origin);
    corners.map(|corner| (DVec3::from_array(corner.map(f64::from)) - low) / grid.voxel_size)
}

/// Calls `found` with each voxel near a triangle and whether it meets the triangle if it is enlarged by `margin`.
pub fn near(grid: &Grid, triangle: [DVec3; 3], margin: f64, mut found: impl FnMut([u32; 3], bool)) {
    let low = triangle[0].min(triangle[1]).min(triangle[2]) - 1.5;
    let high = triangle[0].max(triangle[1]).max(triangle[2]) + 1.5;
    let [nx, ny, nz] = grid.dimensions;
    let range =
        |low: f64, high: f64, count: u32| (low.floor().max(0.0) as u32)..(high.ceil().max(0.0) as u32).min(count);
    for z in range(low.z, high.z, nz) {
        for y in range(low.y, high.y, ny) {
            for x in range(low.x, high.x, nx) {
                let centre = DVec3::new(f64::from(x) + 0.5, f64::from(y) + 0.5, f64::from(z) + 0.5);
                found([x, y, z], meets(centre, 0.5 + margin, triangle));
            }
        }
    }
}
