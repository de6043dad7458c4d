//! A sheet's nodes from the plane behind to this one: attenuation and refraction as of a light texel ([`super::refract_light`]), but
//! forward, each node from where it is (sweep §4.2, Eqs. 9 and 10).

use crate::abi::format::VoxelFormat;
use crate::abi::record::{SheetNode, sheet};
use crate::abi::sweep::{SweepUniforms, mode};
use crate::field::stencil::{scalar, voxel_coordinates};
use crate::field::tables::attenuation;
use crate::math::{length, select, select_vector};
use crate::optics::composite::layer;
use crate::optics::medium::{medium, share_inside};
use crate::sweep::border::{Crossing, MARGIN, Volumes, cross, is_far_inside, is_inside, meet, share_ahead};
use crate::sweep::clip::keep;
use crate::sweep::empty::step_is_empty;
use crate::sweep::light::look_up::{shift, texel_position};
use crate::sweep::light::sheet::{rows, source};
use crate::sweep::turn::turn;
use spirv_std::glam::Vec3;

/// How much of the kernel an invocation needs.
pub mod level {
    /// The node has turned back.
    pub const ENDED: u32 = 0;
    /// It crosses empty space and stays at its corner, and so would unrefracted light.
    pub const STILL: u32 = 1;
    /// It crosses empty space.
    pub const DRIFT: u32 = 3;
    /// It may be attenuated and bent, far inside the border of the space in which the volume bends.
    pub const FULL: u32 = 7;
    /// Its segment, or the one behind it, may be outside in part.
    pub const BORDER: u32 = 15;
}

/// One plane's step.
struct Drift {
    from: Vec3,
    to: Vec3,
    v: Vec3,
    /// The way over the grid, in texels.
    way: (f32, f32),
    /// The way of unrefracted light, in texels.
    unrefracted: (f32, f32),
}

#[inline(always)]
fn drift(x: u32, y: u32, u: &SweepUniforms, node: &SheetNode, sources: &[f32]) -> Drift {
    let v = node.direction;
    let way = shift(u, v, u.step.distance);
    // Texels' centres are whole numbers, and corners half of one before.
    let across = x as i32 as f32 - 0.5 + node.displacement_x;
    let up = (y % rows(u)) as i32 as f32 - 0.5 + node.displacement_y;
    Drift {
        from: texel_position(u, across, up, u.step.behind),
        to: texel_position(u, across + way.0, up + way.1, u.step.ahead),
        v,
        way,
        unrefracted: shift(u, source(u, sources, y), u.step.distance),
    }
}

/// The level that node (x, y) needs.
#[inline(always)]
pub fn level<V: VoxelFormat>(
    x: u32,
    y: u32,
    u: &SweepUniforms,
    chosen: u32,
    record: [f32; sheet::SIZE],
    _voxels: &[u32],
    _ior_voxels: &[u32],
    occupancy: &[u32],
    _tables: &[u32],
    sources: &[f32],
) -> u32 {
    let node = SheetNode::load(&record);
    let step = drift(x, y, u, &node, sources);
    let still = (step.way.0 == 0.0) & (step.way.1 == 0.0) & (step.unrefracted.0 == 0.0) & (step.unrefracted.1 == 0.0);
    let moving = if still { level::STILL } else { level::DRIFT };
    let crossing = if is_far_inside::<V>(u, chosen, step.from, step.to, MARGIN) { level::FULL } else { level::BORDER };
    let needed = if step_is_empty::<V>(u, occupancy, step.from, step.to) { moving } else { crossing };
    if node.turned == 0.0 { needed } else { level::ENDED }
}

/// Node (x, y) one plane further.
#[inline(always)]
pub fn invoke<V: VoxelFormat, const LEVEL: u32>(
    x: u32,
    y: u32,
    u: &SweepUniforms,
    chosen: u32,
    record: [f32; sheet::SIZE],
    voxels: &[u32],
    ior_voxels: &[u32],
    occupancy: &[u32],
    tables: &[u32],
    sources: &[f32],
) -> [f32; sheet::SIZE] {
    let node = SheetNode::load(&record);
    let Drift { from, to, v, way, unrefracted } = drift(x, y, u, &node, sources);
    let mut out = v;
    let mut left = node.flux;
    let mut turned = false;
    let mut inside = node.inside;
    let (mut across, mut up) = (node.displacement_x + way.0, node.displacement_y + way.1);
    if LEVEL >= level::FULL {
        // A lane that drifts is carried along with its block.
        let skipped = step_is_empty::<V>(u, occupancy, from, to);
        let voxel_from = voxel_coordinates(&u.grid, from);
        let mut crossing = Crossing::none(u, to, v, length(to - from));
        if LEVEL >= level::BORDER {
            if mode::bends(chosen) {
                let meeting = meet::<V>(u, from, to);
                let began_inside = is_inside(&meeting, node.inside != 0.0);
                let volumes = Volumes { voxels, ior_voxels, tables };
                crossing = cross::<V>(u, volumes, (from, to, v), &meeting, began_inside);
            } else {
                crossing.path *= share_inside(&u.grid, voxel_from, voxel_coordinates(&u.grid, to));
            }
        }
        let aside = (crossing.to - to) * select(skipped | !crossing.bent, 0.0, u.light_grid.inverse_texel);
        (across, up) = (across + aside.x, up + aside.y);
        inside = select(skipped, node.inside, select(crossing.inside, 1.0, 0.0));
        let to = crossing.to;
        let voxel_to = voxel_coordinates(&u.grid, to);
        let ior_to = voxel_coordinates(&u.ior_grid, to);
        let grids = (&u.grid, &u.ior_grid);
        let here = medium::<V>(grids, chosen, voxels, ior_voxels, tables, voxel_to, ior_to);
        let front = scalar::<V>(voxels, &u.grid, voxel_from);
        let kept = keep(u, from, to);
        let path = crossing.path * u.step.inverse_reference_length;
        let layer = layer(&attenuation(tables, front, here.scalar), path * kept.particles, path * kept.medium);
        let attenuated = left * (layer.medium * layer.clear);
        left = select_vector(skipped, left, attenuated);
        if mode::bends(chosen) {
            let arriving = crossing.direction;
            let ahead = if LEVEL >= level::BORDER { share_ahead::<V>(u, to, arriving) } else { 0.5 };
            let bends = kept.refraction * select(crossing.inside, 1.0, 0.0);
            let kicked = turn(u, arriving, &here, bends, crossing.sigma, ahead);
            turned = (kicked.turned | crossing.turned) & !skipped;
            out = select_vector(skipped, v, kicked.direction);
        }
    }
    let after = SheetNode {
        displacement_x: across,
        displacement_y: up,
        unrefracted_x: node.unrefracted_x + unrefracted.0,
        unrefracted_y: node.unrefracted_y + unrefracted.1,
        direction: out,
        flux: left,
        turned: select(turned, 1.0, node.turned),
        inside,
    };
    after.store()
}
