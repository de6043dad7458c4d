//! The frame of a wavefront: its axes, its planes and the grid of its cells.

use super::point::Source;
use crate::error::Error;
use crate::method::sweep::crop::corners;
use crate::method::sweep::planes::Planes;
use crate::method::view::{Bounds, View};
use crate::scene::Scene;
use crate::subject::Volumes;
use glam::{DMat3, DVec2, DVec3};
use vitrum_kernels::sweep::light::matter::NEARER;

/// The fewest cells along the longer side of the grid that a small volume gets.
pub(super) const FEWEST: f64 = 160.0;
/// The most cells along the longer side of the grid that a large volume gets.
pub(super) const MOST: f64 = 320.0;

/// The largest optical depth of particles from plane to plane with which light is kept on each second plane alone.
const FAINT: f64 = 0.25;
/// Planes from one on which light is kept to the next. Where surfaces alone look at the light, their highlights show how bright it is, and no edge of a
/// shadow; and in faint matter light falls slowly. `densest` is the largest optical depth of particles from plane to plane.
fn stride(densest: f64) -> u32 {
    match densest {
        0.0 => 4,
        faint if faint < FAINT => 2,
        _ => 1,
    }
}

/// Steps of bent light over two planes' distance, where light is not kept on each plane. With two, a ball lens loses 1.9 % of its light at its rim; with
/// three 0.9 %.
const STEPS_OF_BENT: u32 = 3;

/// The frame of a wavefront: z is the direction in which light from far away travels, or light along the middle of that from a point.
#[derive(Debug, Clone, Copy)]
pub(in crate::method::sweep) struct Frame {
    /// The frame as a view along the light.
    pub(in crate::method::sweep) view: View,
    /// The planes over which the wavefront is carried.
    pub(in crate::method::sweep) planes: Planes,
    /// The point from which light comes, if it does not come from far away.
    pub(super) source: Option<Source>,
    /// The corner of the grid of cells; of light from a point a tangent.
    pub(in crate::method::sweep) corner: DVec2,
    /// Edge of a cell, world units; of light from a point a tangent.
    pub(in crate::method::sweep) cell: f64,
    /// Cells across and up.
    pub(in crate::method::sweep) cells: [u32; 2],
    /// Planes from one on which light is kept to the next.
    pub(in crate::method::sweep) stride: u32,
    /// Whether particles throw shadows.
    pub(in crate::method::sweep) has_particles: bool,
}

impl Frame {
    /// The frame of light from far away that travels along `towards`, a unit vector of the view frame `view`.
    ///
    /// # Errors
    /// As [`Planes::new`].
    pub(in crate::method::sweep) fn new(
        scene: &Scene,
        view: &View,
        volumes: Volumes<'_>,
        towards: DVec3,
    ) -> Result<Self, Error> {
        let bounds = Bounds::from(volumes.shown);
        let (centre, radius) = bounds.sphere();
        // In single precision, so that one light has one frame, whichever camera has stated its direction.
        let away = (view.axes * towards).as_vec3().as_dvec3().normalize();
        let right = away.cross(view.up).try_normalize().unwrap_or_else(|| away.any_orthonormal_vector());
        let axes = DMat3::from_cols(right, right.cross(away), away);
        let eye = centre - away * (4.0 * radius);
        let view = View { eye, axes, orthographic: true, target_depth: 4.0 * radius, ..*view };
        let planes = Planes::within(scene, &view, volumes)?;
        let outline = || corners(scene, volumes).map(|corner| view.point(corner).truncate());
        let low = outline().fold(DVec2::INFINITY, DVec2::min);
        let high = outline().fold(DVec2::NEG_INFINITY, DVec2::max);
        let longer = (high - low).max_element();
        let voxel = f64::from(volumes.shown.finest_spacing());
        let wanted = scene.sweep.light_cells.map_or((longer / voxel).clamp(FEWEST, MOST), f64::from);
        // Light that is the same everywhere needs no cells.
        let wanted = if scene.first_light().shadows { wanted } else { 4.0 };
        Ok(Self { view, planes, source: None, corner: low, cell: 0.0, cells: [0; 2], stride: 1, has_particles: false }
            .with_cells(low, high, longer / wanted))
    }

    /// The frame with cells of edge `cell` between `low` and `high`, and one more on each side, so that the outermost ones stay as they are.
    pub(super) fn with_cells(self, low: DVec2, high: DVec2, cell: f64) -> Self {
        let cells = ((high - low) / cell).ceil().max(DVec2::ONE) + 2.0;
        let corner = (low + high - cells * cell) * 0.5;
        Self { corner, cell, cells: [cells.x as u32, cells.y as u32], ..self }
    }

    /// The frame with cells whose edge is `factor` times as long, for the same region.
    pub(in crate::method::sweep) fn coarser(self, factor: f64) -> Self {
        let size = DVec2::new(f64::from(self.cells[0]) - 2.0, f64::from(self.cells[1]) - 2.0) * self.cell;
        let low = self.corner + self.cell;
        self.with_cells(low, low + size, self.cell * factor)
    }

    /// The frame for particles whose largest optical depth from plane to plane is `densest`. Light is kept on every plane of number 0, `stride`,
    /// 2 `stride` and so on; the last plane is one of them. Light that `bends` takes shorter steps where it is kept on some planes alone.
    pub(in crate::method::sweep) fn for_particles(self, densest: f64, bends: bool) -> Self {
        let apart = stride(densest);
        let stride = if bends { apart * STEPS_OF_BENT / 2 } else { apart };
        let steps = (self.planes.count - 1) * stride;
        let last = steps.div_ceil(apart).next_multiple_of(stride);
        let distance = self.planes.distance * f64::from(apart) / f64::from(stride);
        let planes = Planes { distance, count: last + 1, behind: last, ..self.planes };
        Self { planes, stride, has_particles: densest > 0.0, ..self }
    }

    /// The number of planes on which light is kept.
    pub(super) fn kept(&self) -> u32 {
        (self.planes.count - 1) / self.stride + 1
    }

    /// The most planes on which light is kept that a look-up inside matter goes towards the source, see [`matter`](vitrum_kernels::sweep::light::matter).
    pub(super) fn nearer(&self) -> f64 {
        let last = self.planes.depth(self.planes.count - 1);
        let edge = self.cell * self.source.map_or(1.0, |source| last - source.depth);
        // Two ways, one behind the other.
        2.0 * f64::from(NEARER) * (edge / (self.planes.distance * f64::from(self.stride))).max(1.0)
    }

    /// How far viewing rays look up scalars towards the source, world units, see [`matter`](vitrum_kernels::sweep::light::matter).
    pub(in crate::method::sweep) fn reach(&self) -> f64 {
        self.nearer() * self.planes.distance * f64::from(self.stride)
    }

    /// The coordinates of a point of the world: cells across and up, and planes on which light is kept.
    pub(in crate::method::sweep) fn coordinates(&self, point: DVec3) -> DVec3 {
        let at = self.view.point(point);
        // Nothing has coordinates behind a light's place.
        let spread = self.source.map_or(1.0, |source| (at.z - source.depth).max(1e-9));
        let across = (at.truncate() / spread - self.corner) / self.cell;
        across.extend((at.z - self.planes.first_depth) / (self.planes.distance * f64::from(self.stride)))
    }
}
