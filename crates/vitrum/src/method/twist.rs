//! Deforms a mesh.

use glam::{DVec2, DVec3};
use rayon::prelude::*;
use vitrum_io::Mesh;

/// The mesh with its top turned by `degrees` against its bottom, evenly from one to the other, about the line along z through the
/// middle of its bounds. It keeps its volume.
pub(crate) fn twisted(mesh: &Mesh, degrees: f32) -> Mesh {
    let mut twisted = mesh.clone();
    let [low, high] = mesh.bounds().map(|corner| glam::Vec3::from_array(corner).as_dvec3());
    let (middle, height) = (0.5 * (low + high), high.z - low.z);
    if height <= 0.0 || degrees == 0.0 {
        return twisted;
    }
    // Radians per unit of height.
    let rate = f64::from(degrees).to_radians() / height;
    let turned = |at: DVec3, vector: DVec3| {
        let (sin, cos) = libm::sincos(rate * at.z);
        DVec2::new(cos, sin).rotate(vector.truncate()).extend(vector.z)
    };
    let from_middle = |position: &[f32; 3]| glam::Vec3::from_array(*position).as_dvec3() - middle;
    if let Some(normals) = &mut twisted.normals {
        normals.par_iter_mut().zip(&mesh.positions).for_each(|(normal, position)| {
            // The Jacobian of the twist is R (1 + w zᵀ), so that normals take R (1 - z wᵀ).
            let at = from_middle(position);
            let n = glam::Vec3::from_array(*normal).as_dvec3();
            let way = DVec3::new(-at.y, at.x, 0.0) * rate;
            *normal = turned(at, n - DVec3::Z * way.dot(n)).normalize_or_zero().as_vec3().to_array();
        });
    }
    twisted.positions.par_iter_mut().for_each(|position| {
        let at = from_middle(position);
        *position = (middle + turned(at, at)).as_vec3().to_array();
    });
    twisted
}

#[cfg(all(test, feature = "builtin"))]
mod tests {
    use super::*;
    use crate::builtin;

    #[test]
    fn ends_turn_against_each_other_and_the_volume_stays() {
        let mesh = builtin::mesh("torus").unwrap();
        let turned = twisted(&mesh, 90.0);
        // Twisting triangles is not quite twisting what they stand for.
        assert!((turned.signed_volume() / mesh.signed_volume() - 1.0).abs() < 5e-3);
        let [low, high] = mesh.bounds();
        for (before, after) in mesh.positions.iter().zip(&turned.positions) {
            let [before, after] = [before, after].map(|p| glam::Vec3::from_array(*p));
            let angle = (90.0 * ((before.z - low[2]) / (high[2] - low[2]) - 0.5)).to_radians();
            let expected =
                glam::Vec2::new(libm::cosf(angle), libm::sinf(angle)).rotate(before.truncate()).extend(before.z);
            assert!((after - expected).length() < 1e-5, "{before} went to {after}");
        }
        assert_eq!(twisted(&mesh, 0.0), mesh);
    }

    #[test]
    fn normals_stay_at_right_angles_to_the_surface() {
        let mut mesh = builtin::mesh("torus").unwrap();
        let corner =
            |mesh: &Mesh, triangle: [u32; 3]| triangle.map(|v| glam::Vec3::from_array(mesh.positions[v as usize]));
        let plane = |[a, b, c]: [glam::Vec3; 3]| (b - a).cross(c - a).normalize();
        // Each triangle alone with its own normal.
        let planes: Vec<_> = mesh.triangles.iter().map(|triangle| plane(corner(&mesh, *triangle))).collect();
        mesh.positions = mesh.triangles.iter().flatten().map(|vertex| mesh.positions[*vertex as usize]).collect();
        mesh.triangles = (0..planes.len() as u32).map(|index| [3 * index, 3 * index + 1, 3 * index + 2]).collect();
        mesh.normals = Some(planes.iter().flat_map(|plane| [plane.to_array(); 3]).collect());
        let turned = twisted(&mesh, 120.0);
        for triangle in &turned.triangles {
            let expected = plane(corner(&turned, *triangle));
            let found = glam::Vec3::from_array(turned.normals.as_ref().unwrap()[triangle[0] as usize]);
            // The triangle's own normal is that of its middle, not of its corner.
            assert!(found.dot(expected) > 0.99, "{found}, {expected}");
        }
    }
}
