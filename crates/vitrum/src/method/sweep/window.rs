//! Which texels of a plane's light can reach a viewing ray.
//!
//! Rays look at light inside the volumes alone, if there are no receivers. The hull around what is not empty there is convex: light that
//! has left it does not come back, and until light enters it, it is unoccluded. So on each plane only texels on the hull's slice have
//! to be carried on. Outside, light keeps what it was when its texel left the slice: unoccluded where it never was on one. That takes
//! texels that move as unrefracted light does ([`LightGrid::follows_light`]): over others, which a slice has left behind, light comes in.

use super::light::LightGrid;
use super::planes::Planes;
use glam::{DVec2, DVec3};
use vitrum_kernels::kernel::{LANES, Window};

/// Texels around a slice, besides those that the softness filter looks at: interpolation, differences of neighbours, and light that is on
/// its way out and comes from beside the slice.
const MARGIN: f64 = 4.0;

/// The points between two depths that are farthest out of the convex hull of `points`: on lines between two of them.
fn slice(points: &[DVec3], [near, far]: [f64; 2]) -> impl Iterator<Item = DVec3> {
    let pairs = (0..points.len()).flat_map(|last| (0..last).map(move |first| (first, last)));
    pairs.flat_map(move |(from, to)| {
        let (from, to) = (points[from], points[to]);
        let [enters, leaves] = if to.z == from.z {
            [0.0, 1.0]
        } else {
            let [a, b] = [near, far].map(|depth| (depth - from.z) / (to.z - from.z));
            [a.min(b).max(0.0), a.max(b).min(1.0)]
        };
        let outside = from.z.max(to.z) < near || from.z.min(to.z) > far || enters > leaves;
        let ends = if outside { [None, None] } else { [Some(enters), Some(leaves)] };
        ends.into_iter().flatten().map(move |at| from.lerp(to, at))
    })
}

impl LightGrid {
    /// The texels that are carried on to plane `plane`, if light is looked at in the convex hull of `points` and the softness filter looks
    /// `filter` texels far.
    pub(super) fn window(&self, points: &[DVec3], planes: &Planes, plane: u32, filter: f64) -> Window {
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
        for point in slice(points, depths) {
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

    fn straight_at(depth: f64) -> [DVec3; 8] {
        corners(DVec3::new(0.0, 0.0, depth), 0.0)
    }

    fn extent(points: impl Iterator<Item = DVec3>) -> [f64; 4] {
        points.fold([f64::INFINITY, f64::NEG_INFINITY, f64::INFINITY, f64::NEG_INFINITY], |[a, b, c, d], point| {
            [a.min(point.x), b.max(point.x), c.min(point.y), d.max(point.y)]
        })
    }

    #[test]
    fn slices_of_a_hull_are_its_cross_sections() {
        // A cube on its edge: as wide as the way behind its first edge, twice.
        let cube = corners(DVec3::new(0.0, 0.0, 5.0), std::f64::consts::FRAC_PI_4);
        let half = std::f64::consts::SQRT_2;
        for (near, far, width) in [(4.0, 4.25, half - 0.75), (4.9, 5.1, half), (5.5, 5.75, half - 0.5)] {
            let [left, right, below, above] = extent(slice(&cube, [near, far]));
            assert!((left + width).abs() < 1e-9 && (right - width).abs() < 1e-9, "{near} to {far}: {left} to {right}");
            assert!((below + 1.0).abs() < 1e-9 && (above - 1.0).abs() < 1e-9);
        }
        assert_eq!(slice(&cube, [2.0, 3.0]).count(), 0);
        // Between two of them, the way from one to the other.
        let two = [straight_at(2.0), straight_at(8.0)].concat();
        assert_eq!(extent(slice(&two, [5.0, 5.5])), [-1.0, 1.0, -1.0, 1.0]);
        // One that stands straight is cut all the same, also by planes that touch it.
        let straight = straight_at(5.0);
        for depths in [[4.5, 4.6], [3.5, 4.0], [6.0, 7.0]] {
            assert_eq!(extent(slice(&straight, depths)), [-1.0, 1.0, -1.0, 1.0], "{depths:?}");
        }
    }
}
