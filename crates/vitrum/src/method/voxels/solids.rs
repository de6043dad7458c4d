//! Bodies as smoothed distance fields on a grid.

use super::bodies::Body;
use super::{distances, fields};
use crate::error::Error;
use crate::method::Tools;
use crate::method::voxelize::{FillRule, Grid, Settings, voxelize_in};

pub(in crate::method) use super::distances::BAND;

/// The smoothed distance fields of a mesh's bodies.
pub(in crate::method) struct Solids {
    /// The fields, one body after the other: for each voxel the smoothed distance to the surface, from 0, [`BAND`] voxels or more
    /// outside, to 65535, as many inside.
    pub(in crate::method) fields: Vec<u16>,
    /// Rows of voxels that go through holes of the surface, over all bodies; they are left empty.
    pub(in crate::method) open_rows: u64,
}

impl Solids {
    /// Fills the bodies and computes the distances of voxels to their surfaces.
    ///
    /// # Errors
    /// If the backend fails or lacks the memory.
    pub(in crate::method) fn new(bodies: &[Body], grid: Grid, tools: &mut Tools<'_>) -> Result<Self, Error> {
        let settings = Settings { surface: false, solid: Some(FillRule::Nonzero), ..Settings::new(1) };
        let mut solids = Self { fields: Vec::new(), open_rows: 0 };
        for body in bodies {
            let solid = voxelize_in(grid, &body.mesh, &settings, tools)?.solid;
            let solid = solid.expect("a solid was asked for");
            solids.open_rows += solid.open_rows;
            let field = distances::distances(body, grid, &solid.coverage);
            solids.fields.extend(fields::smooth(&field, grid.dimensions.map(|voxels| voxels as usize)));
        }
        Ok(solids)
    }
}
