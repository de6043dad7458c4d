//! Search for a body between the diffuse surface at the end of a viewing ray's piece and the source: what clear bodies and mirrors let through
//! or throw there comes by beams.

use super::see::{level_of, piece_of};
use super::shade::{SAME, ending, is_diffuse};
use crate::abi::beams::{BeamsUniforms, flag};
use crate::abi::light::kind;
use crate::abi::record::{Path, Pencil, Search, pencil, search};
use crate::abi::voxels::STEPS;
use crate::field::access::read;
use crate::kernel::record;
use crate::math::{dot, length, select, xyz};
use crate::optics::receiver::FAR;
use crate::voxels::tree;

pub use crate::voxels::ray::level;

/// The level of work: whether the search is under way.
#[inline(always)]
pub fn level(
    x: u32,
    y: u32,
    u: &BeamsUniforms,
    _mode: u32,
    before: [f32; search::SIZE],
    pencils: &[f32],
    nodes: &[f32],
    corners: &[f32],
    _looks: &[f32],
    materials: &[f32],
) -> u32 {
    let search = Search::load(&before);
    let count = (u.dispatch.width * u.dispatch.height) as i32;
    let target = read(pencils, pencil::TRIANGLE as i32 * count + (y * u.dispatch.width + x) as i32) as i32;
    let done =
        (search.piece == u.limits.round as i32 + 1) & ((search.node >= tree::count(nodes)) | (search.hidden > 0.0));
    let seeks = !done & is_diffuse(target, corners, materials) & (u.flags & flag::SHADOWS != 0);
    if seeks { level_of(x, y, u, pencils) } else { level::ENDED }
}

/// The search after some nodes.
#[inline(always)]
pub fn invoke<const LEVEL: u32>(
    x: u32,
    y: u32,
    u: &BeamsUniforms,
    _mode: u32,
    before: [f32; search::SIZE],
    pencils: &[f32],
    nodes: &[f32],
    corners: &[f32],
    looks: &[f32],
    materials: &[f32],
) -> [f32; search::SIZE] {
    let mut search = Search::load(&before);
    if search.piece != u.limits.round as i32 + 1 {
        search = Search { piece: u.limits.round as i32 + 1, node: 0, hidden: 0.0 };
    }
    let count = u.dispatch.width * u.dispatch.height;
    let pencil = Pencil::load(&record::load::<{ pencil::SIZE }>(pencils, y * u.dispatch.width + x, count));
    let end = ending(u, &pencil, &piece_of(x, y, u, &pencil), corners, looks, materials);
    let distant = u.light.kind == kind::DISTANT;
    let way = xyz(u.light.position) - end.point.position;
    let distance = length(way);
    let towards = if distant { -xyz(u.light.direction) } else { way * (1.0 / distance) };
    // From the side that the light comes to.
    let side = select(dot(end.point.plane, towards) < 0.0, -SAME, SAME);
    let mut ray = Path::straight(end.point.position + end.point.plane * side, towards);
    let reach = select(distant, FAR, distance);
    ray.distance = reach;
    ray.node = search.node;
    let last = tree::count(nodes);
    let mut step = 0;
    while (step < 4 * STEPS) & (ray.node < last) & (search.hidden <= 0.0) {
        step += 1;
        tree::visit(&mut ray, nodes, corners);
        if ray.distance < reach {
            search.hidden = 1.0;
        }
    }
    search.node = ray.node;
    search.store()
}
