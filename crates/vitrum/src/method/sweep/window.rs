//! Which texels of a plane's light can reach a viewing ray.
//!
//! Rays look at light inside the volumes alone, if there are no receivers. A volume's box is convex: light that has left it does not
//! come back, and until light enters it, it is unoccluded. So on each plane only texels on the box's slice have to be carried on. Outside,
//! light keeps what it was when its texel left the slice: unoccluded where it never was on one.

use super::light::LightGrid;
use super::planes::Planes;
use glam::{DVec2, DVec3};
use vitrum_kernels::kernel::{LANES, Window};

/// Texels around a slice, besides those that the softness filter looks at: interpolation, differences of neighbours, and light that is on
/// its way out and comes from beside the slice.
const MARGIN: f64 = 4.0;

/// Pairs of a box's corners that an edge joins; bit n of a corner's number is its end along axis n.
fn edges() -> impl Iterator<Item = (usize, usize)> {
    (0..8usize).flat_map(|corner| (0..3).map(move |axis| (corner, corner | 1 << axis))).filter(|(from, to)| from != to)
}

/// The points of a box between two depths that are farthest out.
fn slice(corners: &[DVec3; 8], [near, far]: [f64; 2]) -> impl Iterator<Item = DVec3> {
    edges().flat_map(move |(from, to)| {
        let (from, to) = (corners[from], corners[to]);
        let along = |depth: f64| if to.z == from.z { 0.0 } else { (depth - from.z) / (to.z - from.z) };
        let [enters, leaves] = {
            let (a, b) = (along(near), along(far));
            if to.z == from.z { [0.0, 1.0] } else { [a.min(b).max(0.0), a.max(b).min(1.0)] }
        };
        let outside = from.z.max(to.z) < near || from.z.min(to.z) > far || enters > leaves;
        let ends = if outside { [None, None] } else { [Some(enters), Some(leaves)] };
        ends.into_iter().flatten().map(move |at| from.lerp(to, at))
    })
}

impl LightGrid {
    /// The texels that are carried on to plane `plane`, of volumes with these corners, if the softness filter looks `filter` texels far.
    pub(super) fn window(&self, boxes: &[[DVec3; 8]], planes: &Planes, plane: u32, filter: f64) -> Window {
        let [width, height] = self.size;
        // The first one fills the buffers.
        if plane <= 1 {
            return Window::whole(width, height);
        }
        let depths = [planes.depth(plane - 1), planes.depth(plane)];
        let texel = |point: DVec3| {
            (point.truncate() - self.shear * (point.z - planes.depth(0)) - self.corner) / self.texel - DVec2::splat(0.5)
        };
        let (mut low, mut high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        for point in boxes.iter().flat_map(|corners| slice(corners, depths)) {
            low = low.min(texel(point));
            high = high.max(texel(point));
        }
        let margin = DVec2::splat(filter.ceil() + MARGIN);
        // Casts cut off, and make 0 of what is not a number.
        let (low, high) = ((low - margin).floor(), (high + margin).ceil() + DVec2::ONE);
        let end = [(high.x as u32).min(width), (high.y as u32).min(height)];
        let first = [(low.x as u32).min(end[0]), (low.y as u32).min(end[1])];
        // Whole blocks, on every backend: what is not run keeps what it was.
        let lanes = LANES as u32;
        Window { first: [first[0] / lanes * lanes, first[1]], end: [end[0].next_multiple_of(lanes).min(width), end[1]] }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn corners(centre: DVec3, turned: f64) -> [DVec3; 8] {
        std::array::from_fn(|corner| {
            let end = |axis: usize| if corner >> axis & 1 == 0 { -1.0 } else { 1.0 };
            centre + glam::DMat3::from_rotation_y(turned) * DVec3::new(end(0), end(1), end(2))
        })
    }

    fn extent(points: impl Iterator<Item = DVec3>) -> [f64; 4] {
        points.fold([f64::INFINITY, f64::NEG_INFINITY, f64::INFINITY, f64::NEG_INFINITY], |[a, b, c, d], point| {
            [a.min(point.x), b.max(point.x), c.min(point.y), d.max(point.y)]
        })
    }

    #[test]
    fn slices_of_a_box_are_its_cross_sections() {
        // A cube on its edge: as wide as the way behind its first edge, twice.
        let cube = corners(DVec3::new(0.0, 0.0, 5.0), std::f64::consts::FRAC_PI_4);
        let half = std::f64::consts::SQRT_2;
        for (near, far, width) in [(4.0, 4.25, half - 0.75), (4.9, 5.1, half), (5.5, 5.75, half - 0.5)] {
            let [left, right, below, above] = extent(slice(&cube, [near, far]));
            assert!((left + width).abs() < 1e-9 && (right - width).abs() < 1e-9, "{near} to {far}: {left} to {right}");
            assert!((below + 1.0).abs() < 1e-9 && (above - 1.0).abs() < 1e-9);
        }
        assert_eq!(slice(&cube, [2.0, 3.0]).count(), 0);
        // One that stands straight is cut all the same, also by planes that touch it.
        let straight = corners(DVec3::new(0.0, 0.0, 5.0), 0.0);
        for depths in [[4.5, 4.6], [3.5, 4.0], [6.0, 7.0]] {
            assert_eq!(extent(slice(&straight, depths)), [-1.0, 1.0, -1.0, 1.0], "{depths:?}");
        }
    }
}
