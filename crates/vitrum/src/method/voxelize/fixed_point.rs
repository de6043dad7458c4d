//! FixedPoint-point positions, as the kernels of the surface read them.

use super::grid::Grid;

/// The most units of a voxel, log₂ (see [`FixedPoint`]).
const MOST_UNITS: u32 = 20;

/// FixedPoint-point positions: integers whose unit is the edge of a voxel over a power of two, the largest that leaves room for the grid's
/// longest edge.
pub(super) struct FixedPoint {
    /// log₂ of the units of a voxel.
    pub units: u32,
    origin: [f64; 3],
    /// Units in the mesh's unit of length.
    scale: f64,
}

impl FixedPoint {
    pub fn new(grid: Grid) -> Self {
        // With what the kernels add to a triangle's extent.
        let longest = grid.dimensions.into_iter().max().unwrap_or(1) + 6;
        let units = longest.leading_zeros().saturating_sub(1).min(MOST_UNITS);
        Self { units, origin: grid.origin, scale: f64::from(1u32 << units) / grid.voxel_size }
    }

    /// A position in units from the grid's low corner.
    pub fn position(&self, position: [f32; 3]) -> [i32; 3] {
        // The last bit of a float that is so large is a unit: the sum rounds, and its lower half is a number in two's complement.
        const LARGE: f64 = 6_755_399_441_055_744.0;
        let units = |axis: usize| (f64::from(position[axis]) - self.origin[axis]) * self.scale;
        [0, 1, 2].map(|axis| (units(axis) + LARGE).to_bits() as u32 as i32)
    }
}

#[cfg(test)]
mod tests {
    use super::{FixedPoint, Grid, MOST_UNITS};

    #[test]
    fn positions_are_rounded_to_units_and_fit() {
        for (edge, units) in [(3, MOST_UNITS), (258, MOST_UNITS), (2041, MOST_UNITS), (2042, 19), (10_240, 17)] {
            let grid = Grid { dimensions: [1, edge, 2], origin: [-1.0; 3], voxel_size: 0.5 };
            let fixed = FixedPoint::new(grid);
            assert_eq!(fixed.units, units, "{edge}");
            let voxel = 1 << units;
            // The far end, and a position between two units.
            let end = 0.5 * edge as f32 - 1.0;
            let between = -1.0 + 0.5 * 0.75 / voxel as f32;
            assert_eq!(fixed.position([-1.0, end, between]), [0, edge as i32 * voxel, 1], "{edge}");
        }
    }
}
