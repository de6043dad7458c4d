//! The passes that draw beams into the picture.

use super::list::{List, pitch};
use super::lit::Lit;
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

/// Lists the passes that draw the beams of lattices.
pub(super) fn draw(
    list: &mut List,
    lights: &[&Lit],
    picture: &Picture<'_>,
    materials: &Buffer,
    scratch: &mut Scratch,
    backend: &mut dyn Backend,
) -> Result<(), BackendError> {
    let size_of_picture = list.block.picture;
    let (width, height) = (size_of_picture.width, size_of_picture.height);
    let levels = list.block.sums.levels;
    let nodes = list.block.medium.nodes;
    let pixels = width * height;
    let texels = |lit: &Lit| lit.lattice.count * lit.lattice.count;
    let kind = if nodes > 0 { medium::VARYING } else { medium::HOMOGENEOUS };
    let coarse = [size(size_of_picture, 1).width, rows_before(size_of_picture, levels + 1)];
    let mut zeros = |label: (&'static str, usize), words: u64| scratch.zeros(label, words.max(1) * 4, backend);
    let near = zeros(("depths", 0), pitch(coarse, depths::SIZE))?;
    let around = zeros(("depths around", 0), pitch(coarse, around::SIZE))?;
    // Optical depths at nodes: of viewing rays, then of the beams of each lattice, round by round.
    let depths = |pieces: u32| pitch([pieces, nodes], optical_depth::SIZE);
    let of_views = depths(pixels);
    let of_rounds = |lit: &Lit| depths(texels(lit)) * u64::from(lit.limits.last + 1);
    let largest = lights.iter().map(|lit| depths(texels(lit))).fold(of_views, u64::max);
    let parts = zeros(("optical depths of parts", 0), largest)?;
    let all = of_views + lights.iter().map(|lit| of_rounds(lit)).sum::<u64>();
    let optical_depths = zeros(("optical depths", 0), all)?;
    if levels > 0 {
        list.add(&kernels::beams_find_depths, coarse, (0, 0), &[picture.sights, &near], 0);
        list.add(&kernels::beams_look_around, coarse, (0, 0), &[&near, &around], 0);
    }
    if nodes > 0 {
        list.add(&kernels::beams_integrate_view, [pixels, nodes], (0, 0), &[picture.sights, materials, &parts], 0);
        list.add(&kernels::beams_add_depths, [pixels, nodes], (0, 0), &[&parts, &optical_depths], 0);
    }
    let mut depth_start = of_views;
    for (number, lit) in lights.iter().enumerate() {
        let (beams, lattice) = (texels(lit), [lit.lattice.count; 2]);
        let rounds = lit.limits.last + 1;
        let of_round = pitch(lattice, projection::SIZE);
        let projections = zeros(("projections of beams", number), of_round * u64::from(rounds))?;
        lit.describe(list);
        list.block.limits.projection_pitch = of_round as u32;
        list.block.limits.depth_start = depth_start as u32;
        list.block.limits.depth_pitch = depths(beams) as u32;
        for round in 0..rounds {
            // Lines of a march have another weight than airlight: what bodies take out of that stays in beams.
            let (is_shadow, marches) = (round == 0, lit.limits.estimator == estimator::MARCH);
            list.block.limits.estimator = if marches && is_shadow { estimator::BEAMS } else { lit.limits.estimator };
            let projected = [&lit.beams, &projections];
            let start = of_round * u64::from(round);
            list.add(&kernels::beams_project_beam, lattice, (0, round), &projected, start);
            if nodes > 0 {
                let integrated = [&lit.beams, materials, &parts];
                list.add(&kernels::beams_integrate_beam, [beams, nodes], (0, round), &integrated, 0);
                let start = depth_start + depths(beams) * u64::from(round);
                list.add(&kernels::beams_add_depths, [beams, nodes], (0, round), &[&parts, &optical_depths], start);
            }
            let sums = if is_shadow { picture.shadows } else { picture.caustics };
            let mode = if marches && !is_shadow { medium::MARCHED } else { kind };
            for (axis, length) in [(axis::ACROSS, width), (axis::DOWNWARDS, height)] {
                list.block.limits.axis = axis;
                let drawn = [&lit.beams, &projections, picture.sights, &around, materials, &optical_depths, sums];
                list.add(&kernels::beams_scatter_beam, [beams, length.div_ceil(BLOCK)], (mode, round), &drawn, 0);
            }
        }
        depth_start += of_rounds(lit);
    }
    Ok(())
}
