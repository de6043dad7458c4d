//! The grid of a shadow map.

use super::casters::{Caster, Turned};
use super::{Cast, passes};
use crate::error::Error;
use crate::method::voxelize::{Grid, Settings};

/// Voxels around the mesh: columns beside it are lit.
const PADDING: u32 = 1;
/// The fewest and the most voxels along the longest edge where the picture decides.
const FEWEST: u32 = 256;
const MOST: u32 = 512;
/// Voxels for each pixel along the longer side of the picture, most of which the mesh fills.
const PER_PIXEL: f64 = 0.75;
/// The most words of a buffer with a map whose resolution the picture decides: what every backend has (128 MiB), so that all of them make the same map.
const MOST_WORDS: u64 = 1 << 25;
/// The fewest voxels where the buffer decides.
const LEAST: u32 = 16;

/// The grid along the light around the part of the mesh that is lit.
///
/// # Errors
/// As [`Grid::around`].
pub(super) fn grid(cast: &Cast, turned: &Turned) -> Result<Grid, Error> {
    let around = |resolution: u32| {
        let settings = Settings { padding: PADDING, ..Settings::new(resolution) };
        Grid::around_box("the mesh", turned.bounds, &settings)
    };
    let mut grid = match cast.resolution {
        Some(resolution) => around(resolution)?,
        None => {
            let channels = if cast.casters.iter().any(Caster::is_colored) { 3 } else { 1 };
            let mut resolution = ((f64::from(cast.pixels) * PER_PIXEL) as u32).clamp(FEWEST, MOST);
            let mut grid = around(resolution)?;
            let of_opaque = if cast.before > 0 && cast.opaque().is_some() { 1 } else { 0 };
            let words =
                |grid| u64::from(cast.before) + passes::words(grid, channels) + of_opaque * passes::words(grid, 1);
            while words(grid) > MOST_WORDS && resolution > LEAST {
                resolution = (resolution * 7 / 8).max(LEAST);
                grid = around(resolution)?;
            }
            grid
        }
    };
    if turned.frame.unit_depth.is_some() {
        // The padding in front must not reach the light.
        let front = 0.5 * turned.bounds[0][0];
        grid.origin[0] = grid.origin[0].max(front);
    }
    Ok(grid)
}
