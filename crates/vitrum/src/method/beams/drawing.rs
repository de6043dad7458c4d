//! The passes that draw beams into the picture.

use super::passes::{List, Lit, pitch};
use crate::backend::{Backend, BackendError, Buffer};
use crate::method::cache::Scratch;
use vitrum_kernels::abi::beams::{BLOCK, axis, estimator, medium};
use vitrum_kernels::abi::record::{around, depths, optical_depth, projection};
use vitrum_kernels::beams::pyramid::{rows_before, size};
use vitrum_kernels::kernel::kernels;

/// What viewing rays see, and the sums that beams add to.
pub(super) struct Picture<'a> {
    pub(super) sights: &'a Buffer,
    pub(super) caustics: &'a Buffer,
    pub(super) shadows: &'a Buffer,
}

/// Lists the passes that draw the beams of a lattice.
pub(super) fn draw(
    list: &mut List,
    lit: &Lit,
    picture: &Picture<'_>,
    materials: &Buffer,
    scratch: &mut Scratch,
    backend: &mut dyn Backend,
) -> Result<(), BackendError> {
    let size_of_picture = list.block.picture;
    let (width, height) = (size_of_picture.width, size_of_picture.height);
    let levels = list.block.sums.levels;
    let nodes = list.block.medium.nodes;
    let [beams, pixels] = [lit.lattice.count * lit.lattice.count, width * height];
    let rounds = lit.limits.last + 1;
    let of_caustics = list.block.limits.estimator;
    let kind = if nodes > 0 { medium::VARYING } else { medium::HOMOGENEOUS };
    let coarse = [size(size_of_picture, 1).width, rows_before(size_of_picture, levels + 1)];
    let mut zeros = |label: &'static str, words: u64| scratch.zeros(label, words.max(1) * 4, backend);
    let near = zeros("depths", pitch(coarse, depths::SIZE))?;
    let around = zeros("depths around", pitch(coarse, around::SIZE))?;
    let of_round = pitch([lit.lattice.count; 2], projection::SIZE);
    let projections = zeros("projections of beams", of_round * u64::from(rounds))?;
    // Optical depths at nodes: of viewing rays, then of beams, round by round.
    let [of_views, of_beams] = [pixels, beams].map(|pieces| pitch([pieces, nodes], optical_depth::SIZE));
    let parts = zeros("optical depths of parts", of_views.max(of_beams))?;
    let optical_depths = zeros("optical depths", of_views + of_beams * u64::from(rounds))?;
    list.block.limits.projection_pitch = of_round as u32;
    list.block.limits.depth_start = of_views as u32;
    list.block.limits.depth_pitch = of_beams as u32;
    if levels > 0 {
        list.add(&kernels::beams_find_depths, coarse, (0, 0), &[picture.sights, &near], 0);
        list.add(&kernels::beams_look_around, coarse, (0, 0), &[&near, &around], 0);
    }
    if nodes > 0 {
        list.add(&kernels::beams_integrate_view, [pixels, nodes], (0, 0), &[picture.sights, materials, &parts], 0);
        list.add(&kernels::beams_add_depths, [pixels, nodes], (0, 0), &[&parts, &optical_depths], 0);
    }
    for round in 0..rounds {
        // Lines of a march have another weight than airlight: what bodies take out of that stays in beams.
        let marches = of_caustics == estimator::MARCH && round > 0;
        let of_shadow = if of_caustics == estimator::MARCH { estimator::BEAMS } else { of_caustics };
        list.block.limits.estimator = if round == 0 { of_shadow } else { of_caustics };
        let projected = [&lit.beams, &projections];
        let start = of_round * u64::from(round);
        list.add(&kernels::beams_project_beam, [lit.lattice.count; 2], (0, round), &projected, start);
        if nodes > 0 {
            list.add(&kernels::beams_integrate_beam, [beams, nodes], (0, round), &[&lit.beams, materials, &parts], 0);
            let start = of_views + of_beams * u64::from(round);
            list.add(&kernels::beams_add_depths, [beams, nodes], (0, round), &[&parts, &optical_depths], start);
        }
        let sums = if round == 0 { picture.shadows } else { picture.caustics };
        let mode = if marches { medium::MARCHED } else { kind };
        for (axis, length) in [(axis::ACROSS, width), (axis::DOWNWARDS, height)] {
            list.block.limits.axis = axis;
            let drawn = [&lit.beams, &projections, picture.sights, &around, materials, &optical_depths, sums];
            list.add(&kernels::beams_scatter_beam, [beams, length.div_ceil(BLOCK)], (mode, round), &drawn, 0);
        }
    }
    Ok(())
}
