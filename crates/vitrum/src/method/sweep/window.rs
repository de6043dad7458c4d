//! Windows of light texels: the texels of a plane whose light can still reach a viewing ray.
//!
//! Where there are no receivers, rays read light inside the volumes alone. The hull of the bricks that are not empty is convex: light that
//! has left it does not come back, and light that has not entered it yet is unoccluded. So only the texels on the hull's slice are carried on
//! to each plane. A texel outside keeps the light of the plane on which it left the slice, or unoccluded light if it never was on one. That
//! takes texels that move as unrefracted light does ([`LightGrid::follows_light`]); light would enter others behind the slice.

use super::hull::{extent, hull};
use super::light::LightGrid;
use super::planes::Planes;
use glam::{DVec2, DVec3};
use vitrum_kernels::kernel::Window;

/// Texels around a slice, besides the ones that the soft-shadow filter reads: for interpolation, differences of neighbours, and light
/// that leaves the slice or comes from beside it.
const MARGIN: f64 = 4.0;

/// The region of the light that viewing rays can read: the outlines of a convex body, texels against depth.
pub(super) struct VisibleLight {
    /// The outline over columns: points (depth, column).
    across: Vec<DVec2>,
    /// The outline over rows: points (depth, row).
    up: Vec<DVec2>,
}

impl LightGrid {
    /// The region of the light that viewing rays can read when they read it inside the convex hull of `points` alone (view frame).
    pub(super) fn visible_light(&self, points: impl Iterator<Item = DVec3>, planes: &Planes) -> VisibleLight {
        let texel = |point: DVec3| {
            (point.truncate() - self.shear * (point.z - planes.depth(0)) - self.corner) / self.texel - DVec2::splat(0.5)
        };
        let (across, up) = points
            .map(|point| {
                let texel = texel(point);
                (DVec2::new(point.z, texel.x), DVec2::new(point.z, texel.y))
            })
            .unzip();
        // Texels depend on points linearly: the outline of the hull is the hull of the outline.
        VisibleLight { across: hull(across), up: hull(up) }
    }

    /// The texels that are carried on to plane `plane`, if viewing rays read light in the region `visible` alone and the softness filter looks
    /// `filter` texels far.
    pub(super) fn window(&self, visible: &VisibleLight, planes: &Planes, plane: u32, filter: f64) -> Window {
        let [width, height] = self.size;
        // The first one fills the buffers.
        if plane <= 1 {
            return Window::whole(width, height);
        }
        let depths = [planes.depth(plane - 1), planes.depth(plane)];
        let Some((columns, rows)) = extent(&visible.across, depths).zip(extent(&visible.up, depths)) else {
            return Window::empty();
        };
        let margin = filter.ceil() + MARGIN;
        // Casts cut off below 0.
        let from = |low: f64, end: u32| ((low - margin).floor() as u32).min(end);
        let to = |high: f64, size: u32| ((high + margin).ceil() as u32).saturating_add(1).min(size);
        let end = [to(columns[1], width), to(rows[1], height)];
        let first = [from(columns[0], end[0]), from(rows[0], end[1])];
        Window::around(first, end, width)
    }
}
