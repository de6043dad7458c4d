//! Rays that are aimed at the edges and corners of a closed surface meet it where they enter it, and where they leave it.

use vitrum_conformance::refraction::ball;
use vitrum_kernels::abi::voxels::corner;
use vitrum_kernels::glam::{DVec3, Vec3};
use vitrum_kernels::optics::receiver::FAR;
use vitrum_kernels::voxels::contact::plane;
use vitrum_kernels::voxels::triangle::{intersect, shear};

/// The ball of triangles with a radius of 100 voxels in a grid of 256, as kernels read it.
fn corners() -> Vec<f32> {
    let mesh = ball(24);
    let at = |vertex: u32| (Vec3::from_array(mesh.positions[vertex as usize]) * 100.0 + Vec3::splat(128.3)).to_array();
    let mut floats = Vec::new();
    for triangle in &mesh.triangles {
        floats.extend(triangle.iter().flat_map(|&vertex| at(vertex)));
        floats.resize(floats.len() + corner::SIZE - 9, 0.0);
    }
    floats
}

#[test]
fn rays_at_edges_and_corners_enter_and_leave() {
    let corners = corners();
    let count = (corners.len() / corner::SIZE) as i32;
    let point = |triangle: i32, number: usize| {
        Vec3::from_slice(&corners[triangle as usize * corner::SIZE + 3 * number..][..3]).as_dvec3()
    };
    let middle = DVec3::splat(f64::from(128.3f32));
    let (mut aimed, mut on_edges) = (0, 0);
    for triangle in (0..count).step_by(7) {
        let [a, b] = [0, 1].map(|number| point(triangle, number));
        for (number, target) in [a, 0.5 * (a + b), 0.3 * a + 0.7 * b].into_iter().enumerate() {
            // From outside, by turns along an axis and across all of them.
            let outwards = (target - middle).normalize();
            let across = if number == 1 { outwards.any_orthonormal_vector() } else { DVec3::new(0.3, -0.5, 0.4) };
            let eye = target + 150.0 * (outwards + 0.6 * across).normalize();
            let direction = (target - eye).normalize();
            let from = eye.as_vec3();
            let ray = shear(from, (target - from.as_dvec3()).normalize().as_vec3());
            let (mut enters, mut leaves) = (0, 0);
            for triangle in 0..count {
                let hit = intersect(&ray, &corners, triangle);
                if hit.distance >= FAR {
                    continue;
                }
                on_edges += usize::from(hit.weights.min_element() * hit.weights.max_element() == 0.0);
                if plane(triangle, &corners).as_dvec3().dot(direction) < 0.0 {
                    enters += 1;
                } else {
                    leaves += 1;
                }
            }
            aimed += 1;
            assert!(enters > 0 && leaves > 0, "{target}: enters {enters} triangles, leaves {leaves}");
        }
    }
    assert!(aimed > 900 && on_edges > 0, "{aimed} rays, {on_edges} exactly on an edge");
}
