//! Normals at the corners of triangles, for meshes without normals.

use glam::DVec3;
use rayon::prelude::*;
use vitrum_io::Mesh;

/// Cosine of 45°: two triangles that meet at a larger angle have a visible edge between them.
const CREASE: f64 = std::f64::consts::FRAC_1_SQRT_2;

/// The unit normals of a triangle's corners: the mesh's own; else, where they are to be `smooth`, the mean of the triangles around the
/// corner that lean less than [`CREASE`] against this one, weighted by their angles there; else the triangle's.
pub(super) fn of_corners(mesh: &Mesh, smooth: bool) -> Vec<[[f32; 3]; 3]> {
    let position = |vertex: u32| glam::Vec3::from_array(mesh.positions[vertex as usize]).as_dvec3();
    let plane = |[a, b, c]: [u32; 3]| {
        let [a, b, c] = [a, b, c].map(position);
        (b - a).cross(c - a).normalize_or_zero()
    };
    let planes: Vec<DVec3> = mesh.triangles.par_iter().map(|triangle| plane(*triangle)).collect();
    let around = if smooth && mesh.normals.is_none() { around(mesh) } else { Around::default() };
    let angle = |triangle: &[u32; 3], corner: usize| {
        let [a, b, c] = [0, 1, 2].map(|k| position(triangle[(corner + k) % 3]));
        let (along, other) = (b - a, c - a);
        let cosine = along.dot(other) / (along.length_squared() * other.length_squared()).sqrt();
        libm::acos(cosine.clamp(-1.0, 1.0))
    };
    let of_triangle = |(index, triangle): (usize, &[u32; 3])| {
        std::array::from_fn(|corner| {
            let vertex = triangle[corner] as usize;
            let own = mesh.normals.as_ref().map_or([0.0; 3], |normals| normals[vertex]);
            if own != [0.0; 3] {
                return own;
            }
            let sum: DVec3 = around
                .of(vertex)
                .iter()
                .map(|&(other, corner)| (other as usize, corner as usize))
                .filter(|&(other, _)| planes[other].dot(planes[index]) > CREASE)
                .map(|(other, corner)| planes[other] * angle(&mesh.triangles[other], corner))
                .filter(|weighted| weighted.is_finite())
                .sum();
            sum.try_normalize().unwrap_or(planes[index]).as_vec3().to_array()
        })
    };
    mesh.triangles.par_iter().enumerate().map(of_triangle).collect()
}

/// The triangles around each vertex, each with the number of its corner there.
#[derive(Default)]
struct Around {
    begins: Vec<usize>,
    corners: Vec<(u32, u8)>,
}

impl Around {
    fn of(&self, vertex: usize) -> &[(u32, u8)] {
        self.begins.get(vertex..=vertex + 1).map_or(&[], |ends| &self.corners[ends[0]..ends[1]])
    }
}

fn around(mesh: &Mesh) -> Around {
    let mut begins = vec![0; mesh.positions.len() + 1];
    for &vertex in mesh.triangles.as_flattened() {
        begins[vertex as usize + 1] += 1;
    }
    for vertex in 0..mesh.positions.len() {
        begins[vertex + 1] += begins[vertex];
    }
    let mut next = begins.clone();
    let mut corners = vec![(0, 0); mesh.triangles.len() * 3];
    for (index, triangle) in (0..).zip(&mesh.triangles) {
        for (corner, &vertex) in (0..).zip(triangle) {
            corners[next[vertex as usize]] = (index, corner);
            next[vertex as usize] += 1;
        }
    }
    Around { begins, corners }
}
