//! Conditions on every value that a reader returns.

use vitrum_io::{Mesh, Volume};

/// A value that was read from a file that may be broken.
pub trait Whole {
    /// Checks that the value takes at most `most` bytes, is finite, and has the sizes that it states.
    ///
    /// # Panics
    ///
    /// Where any of that is not so.
    fn assert_whole(&self, most: u64);
}

impl Whole for Volume {
    fn assert_whole(&self, most: u64) {
        assert!(self.bytes() as u64 <= most);
        assert!(self.range[0] <= self.range[1] && self.range.iter().all(|end| end.is_finite()));
        assert!(self.spacing.iter().all(|spacing| *spacing > 0.0 && spacing.is_finite()));
        assert!(self.origin.iter().chain(self.axes.as_flattened()).all(|value| value.is_finite()));
        assert_eq!(self.histogram(7).iter().sum::<u64>(), self.voxel_count() as u64);
    }
}

impl Whole for Mesh {
    fn assert_whole(&self, most: u64) {
        assert!(self.bytes() as u64 <= most);
        let vertices = self.positions.len();
        assert!(self.triangles.as_flattened().iter().all(|&vertex| (vertex as usize) < vertices));
        assert!(self.positions.as_flattened().iter().all(|coordinate| coordinate.is_finite()));
        assert!(self.normals.as_ref().is_none_or(|normals| normals.len() == vertices));
        assert!(self.colors.as_ref().is_none_or(|colors| colors.len() == vertices));
        assert!(self.triangle_materials.iter().all(|&material| (material as usize) < self.materials.len()));
        assert_eq!(self.triangle_materials.len(), if self.materials.is_empty() { 0 } else { self.triangles.len() });
        let (topology, area, volume) = (self.topology(), self.surface_area(), self.signed_volume());
        assert!(area.is_finite() && area >= 0.0 && volume.is_finite());
        assert!(topology.points <= vertices && topology.boundary_edges <= topology.edges);
        assert!(self.degenerate_triangle_count() <= self.triangles.len());
    }
}
