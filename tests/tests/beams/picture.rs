//! The picture of a clear ball in fog: coarse lattices of light against single scattering.

use super::ball::in_fog;
use super::picture_table::{BLOCKS, LEFT, UNIT};
use super::{LAMP, on_both, red, rms};
use vitrum::backend::Backend;
use vitrum::method::View;
use vitrum_conformance::case::Case;
use vitrum_conformance::closed_forms::table::{self, ErrorBound};
use vitrum_conformance::shadow::view;
use vitrum_conformance::{Failure, frames};
use vitrum_kernels::glam::DVec3;

/// Pixels of a block along each edge.
const BLOCK: usize = 4;
const EDGE: usize = BLOCKS * BLOCK;

/// Rays of light along an edge, the largest error over the brightest block, root mean square over blocks: light is linear over a beam's
/// cross-section, and the error at a caustic is of order 1.5. The table's own is up to 0.15 %.
const LARGEST_RMS: [(u32, f64, ErrorBound); 2] =
    [(32, 0.006, table::BEAMS_PICTURE_32), (64, 0.003, table::BEAMS_PICTURE_64)];

/// The largest error of the sum over blocks: flux is conserved but for the sampling of the lattice's texels at the outline.
const LARGEST_MEAN: f64 = 0.005;

/// Distances from the ball's outline, in radii, from which on a block is seen clear of it: half a pixel is 0.025.
const CLEAR: f64 = 0.03;

/// The table's picture, with as many pixels.
pub fn picture(rays: u32) -> Result<Case, Failure> {
    let mut case = in_fog(LAMP, 0.0, 0.0, rays)?;
    case.resize(EDGE as u32);
    for setting in
        ["camera.position=[0,-9,0.5]", "camera.target=[0,0,-0.3]", "camera.field_of_view=40", "beams.pyramid=true"]
    {
        case.scene.set(setting)?;
    }
    Ok(case)
}

/// The distance from the ball's middle at which the viewing ray through a point of the picture passes, in pixels from its upper left corner.
fn passes(view: &View, [column, row]: [usize; 2]) -> f64 {
    let [across, down] = [column, row].map(|at| at as f64 / EDGE as f64 * 2.0 - 1.0);
    let [half_width, half_height] = view.half_size;
    let towards: DVec3 =
        view.axes.z_axis + view.axes.x_axis * (across * half_width) - view.axes.y_axis * (down * half_height);
    view.eye.cross(towards.normalize()).length()
}

/// Whether the ball's outline is within a block, or near it.
fn has_outline(view: &View, [column, row]: [usize; 2]) -> bool {
    let points = (0..=BLOCK).flat_map(|j| (0..=BLOCK).map(move |i| [column * BLOCK + i, row * BLOCK + j]));
    let (nearest, farthest) = points
        .map(|point| passes(view, point))
        .fold((f64::INFINITY, 0.0), |(low, high), at| (f64::min(low, at), f64::max(high, at)));
    nearest < 1.0 + CLEAR && farthest > 1.0 - CLEAR
}

/// The mean of a block.
fn mean(pixels: &[f64], [column, row]: [usize; 2]) -> f64 {
    let rows = (row * BLOCK..(row + 1) * BLOCK).map(|row| &pixels[row * EDGE..(row + 1) * EDGE]);
    let sum: f64 = rows.flat_map(|row| &row[column * BLOCK..(column + 1) * BLOCK]).sum();
    sum / (BLOCK * BLOCK) as f64
}

/// The error over the brightest block, root mean square over the blocks that are clear of the outline, and the error of their sum.
pub fn errors(case: &Case, backend: &mut dyn Backend) -> Result<[f64; 2], Failure> {
    let left = |[column, row]: [usize; 2]| f64::from(LEFT[row][column.min(BLOCKS - 1 - column)]) * UNIT;
    let brightest = LEFT.as_flattened().iter().copied().map(f64::from).fold(0.0, f64::max) * UNIT;
    let view = view(case);
    let all = (0..BLOCKS).flat_map(|row| (0..BLOCKS).map(move |column| [column, row]));
    let blocks: Vec<_> = all.filter(|block| !has_outline(&view, *block)).collect();
    assert!(blocks.len() > BLOCKS * BLOCKS * 9 / 10, "{} blocks", blocks.len());
    let found = red(&frames::render(case, backend)?, "caustics");
    let error = rms(blocks.iter().map(|&block| mean(&found, block) - left(block))) / brightest;
    let sum = |of: &dyn Fn([usize; 2]) -> f64| blocks.iter().map(|block| of(*block)).sum::<f64>();
    Ok([error, sum(&|block| mean(&found, block)) / sum(&left) - 1.0])
}

#[test]
fn the_picture_of_a_ball_is_that_of_single_scattering() -> Result<(), Failure> {
    for (rays, largest, line) in LARGEST_RMS {
        let case = picture(rays)?;
        on_both(|backend| {
            let [error, whole] = errors(&case, backend)?;
            println!("{rays} rays: {error:.2e}, the mean {whole:.2e} ({})", backend.name());
            assert!(error <= largest, "{rays} rays: off by {error:.2e} of the brightest block");
            line.hold(error, backend);
            assert!(whole.abs() <= LARGEST_MEAN, "{rays} rays: the sum is off by {whole:.2e}");
            Ok(())
        })?;
    }
    Ok(())
}
