//! The grid around a mesh.

use super::settings::Settings;
use crate::error::Error;
use crate::unrenderable::Unrenderable;
use glam::DVec3;
use vitrum_io::Mesh;

/// The most voxels along a mesh's longest edge.
pub const MOST_VOXELS: u32 = 8192;

/// The most empty voxels around a mesh.
pub const MOST_PADDING: u32 = 1024;

/// Clearance between the mesh and the grid's border or the padding, over the longest edge. Voxels are closed: without it, every mesh
/// would meet the voxels beyond.
const CLEARANCE: f64 = 1.0 / 65536.0;

/// A grid of cubic voxels, axis-aligned in the world.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grid {
    /// Voxels along x, y and z.
    pub dimensions: [u32; 3],
    /// The low corner of voxel (0, 0, 0), in the mesh's units.
    pub origin: [f64; 3],
    /// A voxel's edge, in the mesh's units.
    pub voxel_size: f64,
}

impl Grid {
    /// The grid around a mesh: `resolution` voxels along the longest edge of its bounds, as many as needed along the others, the mesh
    /// in the middle, and `padding` voxels around.
    ///
    /// # Errors
    /// Where the resolution is 0 or above [`MOST_VOXELS`], the padding above [`MOST_PADDING`], and where the mesh is a point.
    pub fn around(mesh: &Mesh, settings: &Settings) -> Result<Self, Error> {
        Self::around_box(&mesh.name, mesh.bounds().map(|corner| corner.map(f64::from)), settings)
    }

    /// The grid around a box from `low` to `high`, as [`Self::around`]; `name` is the name for messages.
    pub(in crate::method) fn around_box(
        name: &str,
        [low, high]: [[f64; 3]; 2],
        settings: &Settings,
    ) -> Result<Self, Error> {
        let Settings { resolution, padding, .. } = *settings;
        if !(1..=MOST_VOXELS).contains(&resolution) || padding > MOST_PADDING {
            let (most_voxels, most_padding) = (MOST_VOXELS, MOST_PADDING);
            return Err(Unrenderable::VoxelCount { resolution, padding, most_voxels, most_padding }.into());
        }
        let extent: [f64; 3] = std::array::from_fn(|axis| high[axis] - low[axis]);
        let longest = extent.into_iter().fold(0.0, f64::max);
        let voxel_size = longest / (f64::from(resolution) * (1.0 - 2.0 * CLEARANCE));
        // Neither too small for the world's floats nor for the quotients.
        if voxel_size < f64::from(f32::MIN_POSITIVE) {
            return Err(Unrenderable::NoExtent { name: name.to_owned() }.into());
        }
        let inner = extent.map(|extent| ((extent / voxel_size).ceil() as u32).clamp(1, resolution));
        let dimensions = inner.map(|voxels| voxels + 2 * padding);
        let origin =
            std::array::from_fn(|axis| 0.5 * (low[axis] + high[axis]) - 0.5 * f64::from(dimensions[axis]) * voxel_size);
        Ok(Self { dimensions, origin, voxel_size })
    }

    /// A point of the world in voxels from the grid's low corner.
    pub(in crate::method) fn at(self, world: DVec3) -> DVec3 {
        (world - DVec3::from_array(self.origin)) / self.voxel_size
    }

    /// A position in voxels from the grid's low corner.
    pub(in crate::method) fn to_voxels(self, position: [f32; 3]) -> [f64; 3] {
        std::array::from_fn(|axis| (f64::from(position[axis]) - self.origin[axis]) / self.voxel_size)
    }

    /// The number of voxels.
    #[must_use]
    pub fn voxels(&self) -> u64 {
        self.dimensions.iter().map(|&count| u64::from(count)).product()
    }
}
