//! Triangles as the kernels of voxelization read them.

use super::grid::Grid;
use vitrum_io::Mesh;
use vitrum_kernels::abi::voxelize::brought;

/// Bits of a corner's coordinate: differences of two such numbers are exact floats.
const BITS: i32 = 22;

/// The corners of triangle `index` in voxels.
pub(super) fn corners(mesh: &Mesh, grid: Grid, index: usize) -> [[f64; 3]; 3] {
    mesh.triangles[index].map(|vertex| grid.to_voxels(mesh.positions[vertex as usize]))
}

/// The least integer above log₂ of `extent`, at least 1.
fn magnitude(extent: f64) -> i32 {
    ((extent.to_bits() >> 52) as i32 - 1022).max(1)
}

/// The unit in which numbers below `extent` have [`BITS`] bits.
fn unit(extent: f64) -> f64 {
    f64::from_bits(((1023 + magnitude(extent) - BITS) as u64) << 52)
}

/// `x` rounded to a multiple of `unit`; |x| must be far below 2⁵¹ units, so that the sum's last bit is a unit.
fn round(x: f64, unit: f64) -> f64 {
    let large = 6_755_399_441_055_744.0 * unit;
    (x + large) - large
}

/// Corners for the solid: rounded to a unit that is the same for the whole grid, so that common corners stay common.
pub(in crate::method) fn solid(corners: [[f64; 3]; 3], grid: Grid) -> [[f32; 3]; 3] {
    let longest = grid.dimensions.into_iter().max().unwrap_or(1);
    let unit = unit(f64::from(longest));
    corners.map(|corner| corner.map(|voxels| round(voxels, unit) as f32))
}

/// The attributes of triangle `index`: the vertices' normals and colours where the mesh has them, else the triangle's normal and the
/// material's colour, or white.
pub(super) fn attributes(mesh: &Mesh, index: usize) -> [f32; brought::SIZE] {
    let vertices = mesh.triangles[index].map(|vertex| vertex as usize);
    let material = mesh.triangle_materials.get(index).copied();
    let face = face_normal(vertices.map(|vertex| mesh.positions[vertex].map(f64::from)));
    let base = material.and_then(|material| mesh.materials.get(material as usize)?.base_color).unwrap_or([1.0; 3]);
    let mut record = [0.0; brought::SIZE];
    for (number, vertex) in vertices.into_iter().enumerate() {
        let given = mesh.normals.as_ref().map(|normals| normals[vertex]).filter(|normal| *normal != [0.0; 3]);
        let color = mesh.colors.as_ref().map_or(base, |colors| {
            let [red, green, blue, _] = colors[vertex];
            [red, green, blue]
        });
        let (normals, colors) = (brought::NORMALS + 3 * number, brought::COLORS + 3 * number);
        record[normals..normals + 3].copy_from_slice(&given.unwrap_or(face));
        record[colors..colors + 3].copy_from_slice(&color.map(|channel| channel.clamp(0.0, 1.0)));
    }
    record[brought::MATERIAL] = material.map_or(0.0, |material| (material + 1) as f32);
    record
}

/// Unit normal of a triangle; 0 for a triangle without area.
fn face_normal([a, b, c]: [[f64; 3]; 3]) -> [f32; 3] {
    let [a, b, c] = [a, b, c].map(glam::DVec3::from_array);
    // Scaled first: squares of small lengths would vanish.
    let scale = (b - a).abs().max((c - a).abs()).max_element().max(f64::MIN_POSITIVE);
    let normal = ((b - a) / scale).cross((c - a) / scale);
    normal.normalize_or_zero().as_vec3().to_array()
}

#[cfg(test)]
mod tests {
    use super::{magnitude, round, unit};

    #[test]
    fn numbers_are_rounded_to_units() {
        assert_eq!((unit(2.0), unit(513.0)), (1.0 / f64::from(1 << 20), 1.0 / f64::from(1 << 12)));
        for x in [-3.0, -0.3, 0.0, 1.0 / 3.0, 1023.999] {
            let rounded = round(x, 1.0 / 4096.0);
            assert!((rounded - x).abs() <= 0.5 / 4096.0 && rounded * 4096.0 % 1.0 == 0.0, "{x}: {rounded}");
        }
    }

    #[test]
    fn a_magnitude_is_above_the_logarithm() {
        assert_eq!([0.1, 1.0, 2.0, 3.9, 4.0, 513.0].map(magnitude), [1, 1, 2, 2, 3, 10]);
    }
}
