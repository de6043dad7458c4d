//! The light that refracted cells of the wavefront bring to the samples of a plane.
//!
//! Cells whose nodes are where unrefracted light is bring nothing here: [`super::collect_light`] finds their light in their place.

use crate::abi::record::{Node, node_status as status};
use crate::abi::sweep::SweepUniforms;
use crate::abi::wavefront::Wavefront;
use crate::field::sums::Sums;
use crate::math::{floor_to_int, length, max, min, select, select_vector};
use crate::sweep::light::bricks::place;
use crate::sweep::light::quad::{Corner, Target, scatter};
use crate::sweep::light::wavefront::{
    coordinates, fluence_of_flux, is_cell_straight, node, point_at, unrefracted_direction,
};
use spirv_std::glam::{Vec2, Vec3};

/// Farther than any sample.
const FAR: f32 = 65536.0;

/// A corner of a cell on the plane, and the depth from where its light last bent.
#[inline(always)]
fn corner(u: &SweepUniforms, node: &Node) -> (Corner, f32) {
    let w = &u.wavefront;
    let at = point_at(node, u.step.ahead);
    let cells = coordinates(w, at);
    let straight = unrefracted_direction(w, at);
    let unit = node.direction * (1.0 / max(length(node.direction), 1e-20));
    // Behind a receiver there is no light.
    let ended = node.status == status::LANDED;
    let fluence = node.flux * fluence_of_flux(w, node.direction, at);
    // How far it is from where the light last bent, if anything has bent it.
    let way = (u.step.ahead - node.position.z) * select(node.bent != 0.0, 1.0, 0.0);
    let corner = Corner {
        at: Vec2::new(cells.x - w.first_sample, cells.y - w.first_sample),
        flux: select_vector(ended, Vec3::new(0.0, 0.0, 0.0), fluence),
        aside: Vec2::new(unit.x - straight.x, unit.y - straight.y),
        turned: node.status == status::TURNED,
    };
    (corner, way)
}

/// Whether something may look at samples between two places: surely if they are far apart.
#[inline(always)]
fn is_looked_at(w: &Wavefront, bricks: &[u32], low: Vec2, high: Vec2) -> bool {
    let whole = |x: f32| floor_to_int(x + 0.5, -FAR, FAR);
    let (left, right, below, above) = (whole(low.x), whole(high.x), whole(low.y), whole(high.y));
    let near = (right - left <= 8) & (above - below <= 8);
    let any = (place(w, bricks, left, below) >= 0)
        | (place(w, bricks, right, below) >= 0)
        | (place(w, bricks, left, above) >= 0)
        | (place(w, bricks, right, above) >= 0);
    any | !near
}

/// Scatters cell (x, y).
#[inline(always)]
pub fn invoke<S: Sums + ?Sized>(
    x: u32,
    y: u32,
    u: &SweepUniforms,
    _mode: u32,
    nodes: &[f32],
    bricks: &[u32],
    sums: &mut S,
) {
    let w = &u.wavefront;
    if !is_cell_straight(w, nodes, x, y) {
        let a = corner(u, &node(w, nodes, x, y));
        let b = corner(u, &node(w, nodes, x + 1, y));
        let c = corner(u, &node(w, nodes, x, y + 1));
        let d = corner(u, &node(w, nodes, x + 1, y + 1));
        let low = Vec2::new(
            min(min(a.0.at.x, b.0.at.x), min(c.0.at.x, d.0.at.x)),
            min(min(a.0.at.y, b.0.at.y), min(c.0.at.y, d.0.at.y)),
        );
        let high = Vec2::new(
            max(max(a.0.at.x, b.0.at.x), max(c.0.at.x, d.0.at.x)),
            max(max(a.0.at.y, b.0.at.y), max(c.0.at.y, d.0.at.y)),
        );
        let way = max(max(a.1, b.1), max(c.1, d.1));
        let blur = w.softness * way * w.inverse_cell;
        if is_looked_at(w, bricks, low, high) {
            let target = Target { columns: (w.bricks.x * 8) as i32, rows: (w.bricks.y * 8) as i32 };
            scatter::<S, false>(u, bricks, sums, target, (&a.0, &b.0, &c.0, &d.0), blur);
        }
    }
}
