//! Light in the cells of the medium ([`super::cells`]) that has not been scattered: of the source where nothing is in its way, and of beams.

use super::bend::mean;
use super::cells::{directed, middle};
use super::density::density_at;
use super::medium::{depth_from, transmittance};
use crate::abi::beams::{BeamsUniforms, CELLS};
use crate::abi::light::kind;
use crate::abi::record::{cell, deposit};
use crate::field::sums::sum;
use crate::math::{affine, dot, max, sqrt, xyz};
use crate::optics::light_source::arriving;
use spirv_std::glam::Vec3;

/// Points of a cell along each axis at which the light is computed.
const POINTS: u32 = 3;
/// Distance from a point source at which the irradiance is the mean over a ball around it, over the radius of the ball: 1 / √3.
const NEAR: f32 = 0.577_350_26;
/// Radius of the ball whose volume is the one of a cube of edge 1.
const RADIUS: f32 = 0.620_350_5;

/// The cell in column `x`; `y` counts rows and layers.
#[inline(always)]
pub fn invoke(
    x: u32,
    y: u32,
    u: &BeamsUniforms,
    _mode: u32,
    sums: &[u32],
    pictures: &[f32],
    materials: &[f32],
) -> [f32; cell::SIZE] {
    let (j, k) = (y % CELLS, y / CELLS);
    let centre = middle(u, x, j, k);
    let part = xyz(u.cells.edge) * (1.0 / POINTS as f32);
    let nearest = NEAR * RADIUS * ((part.x + part.y) + part.z) * (1.0 / 3.0);
    let mut fluence = Vec3::new(0.0, 0.0, 0.0);
    let mut flow = Vec3::new(0.0, 0.0, 0.0);
    let mut in_front = 0.0;
    let mut point = 0;
    while point < POINTS * POINTS * POINTS {
        let (column, row, layer) = (point % POINTS, point / POINTS % POINTS, point / (POINTS * POINTS));
        let offset = Vec3::new(column as i32 as f32 - 1.0, row as i32 as f32 - 1.0, layer as i32 as f32 - 1.0);
        let position = centre + offset * part;
        // Behind the ground and the wall there is neither light nor medium.
        let ground = affine(u.receivers.ground.plane, position);
        let wall = affine(u.receivers.wall.plane, position);
        if (ground >= 0.0) & (wall >= 0.0) {
            let way = position - xyz(u.light.position);
            let distance = max(sqrt(dot(way, way)), 1e-6);
            let moved = xyz(u.light.position) + way * (max(distance, nearest) / distance);
            let at = if u.light.kind == kind::DISTANT { position } else { moved };
            let light = arriving(&u.light, pictures, at);
            let depth = depth_from(&u.medium, materials, &u.light, position, light.direction);
            let arrives = light.radiance * transmittance(&u.medium, depth);
            fluence += arrives;
            flow += light.direction * mean(arrives);
            in_front += 1.0;
        }
        point += 1;
    }
    let share = 1.0 / (POINTS * POINTS * POINTS) as f32;
    let edge = u.cells.edge;
    let inverse = 1.0 / (u.cells.scale * ((edge.x * edge.y) * edge.z));
    let at = ((y * CELLS + x) as usize * deposit::SIZE) as i32;
    let light = Vec3::new(sum(sums, at), sum(sums, at + 2), sum(sums, at + 4));
    let along = Vec3::new(sum(sums, at + 6), sum(sums, at + 8), sum(sums, at + 10));
    let density = if u.medium.nodes == 0 { 1.0 } else { density_at(&u.medium, materials, centre) };
    directed(fluence * share + light * inverse, flow * share + along * inverse, density * (in_front * share)).store()
}
