//! The frame of a light: x along it, columns of light parallel to x.
//!
//! Light of a point is made parallel by a projective map: across the axis positions are the tangents of their directions to it. Depths stay
//! what they are.

use super::source::Source;
use crate::error::Error;
use glam::{DMat3, DVec2, DVec3, Vec3Swizzles as _};

/// Number of directions around a cone that represent its edge.
const EDGE: u32 = 64;

/// The largest unit depth, over the depth of the mesh's middle.
const FARTHEST: f64 = 1000.0;

/// The frame of a light: its axes and origin, and the unit of lengths across.
#[derive(Debug, Clone, Copy)]
pub(in crate::method) struct Frame {
    /// Axes of the frame in the world, as columns; x along the light.
    pub axes: DMat3,
    /// Origin of the frame in the world: the middle of the mesh, or the light's position.
    pub origin: DVec3,
    /// The depth at which tangents are lengths: voxels are cubes there. `None` where light is parallel.
    pub unit_depth: Option<f64>,
}

impl Frame {
    /// The frame of light on a box from a low to a high corner, with a unit depth of 1.
    ///
    /// # Errors
    /// As [`Source::check`].
    pub(in crate::method) fn new(source: &Source, [low, high]: [DVec3; 2]) -> Result<Self, Error> {
        source.check([low, high], None)?;
        let centre = 0.5 * (low + high);
        let (direction, origin, unit_depth) = match *source {
            Source::Distant(direction) => (direction, centre, None),
            Source::Point(position) | Source::Spot { position, .. } => {
                (towards([low, high], position), position, Some(1.0))
            }
        };
        let across = direction.any_orthonormal_vector();
        let axes = DMat3::from_cols(direction, across, direction.cross(across));
        Ok(Self { axes, origin, unit_depth })
    }

    /// A point of the world: its depth, and its lengths or tangents across.
    pub(in crate::method) fn turned(&self, world: DVec3) -> DVec3 {
        let at = self.axes.transpose() * (world - self.origin);
        if self.unit_depth.is_some() { DVec3::new(at.x, at.y / at.x, at.z / at.x) } else { at }
    }

    /// Factors that turn tangents into lengths.
    pub(super) fn widths(&self) -> DVec3 {
        let width = self.unit_depth.unwrap_or(1.0);
        DVec3::new(1.0, width, width)
    }

    /// Chooses the unit depth for what lies within `bounds`, turned, and gives these with lengths across; of a spot the part that its cone falls on.
    ///
    /// Voxels are cubes in the middle of the mesh, or farther away: where tangents at that depth would be shorter than the mesh is deep, columns
    /// are as many across as voxels along them.
    pub(super) fn scale(&mut self, source: &Source, bounds: [DVec3; 2]) -> [[f64; 3]; 2] {
        let [low, high] = self.lit(source, bounds);
        if self.unit_depth.is_some() {
            let extent = high - low;
            let widest = extent.y.max(extent.z).max(f64::MIN_POSITIVE);
            let middle = 0.5 * (low.x + high.x);
            self.unit_depth = Some((extent.x / widest).clamp(middle, FARTHEST * middle));
        }
        [low, high].map(|corner| (corner * self.widths()).to_array())
    }

    /// The lit part of a box in the light's frame.
    pub(in crate::method) fn lit(&self, source: &Source, [low, high]: [DVec3; 2]) -> [DVec3; 2] {
        let Source::Spot { axis, tangent, .. } = *source else { return [low, high] };
        let (right, up) = axis.any_orthonormal_pair();
        // A polygon around the cone.
        let tangent = tangent / libm::cos(std::f64::consts::PI / f64::from(EDGE));
        let edge = |step: u32| {
            let (sin, cos) = libm::sincos(std::f64::consts::TAU * f64::from(step) / f64::from(EDGE));
            let along = self.axes.transpose() * (axis + (right * cos + up * sin) * tangent);
            (along.x > 1e-3 * along.length()).then(|| DVec2::new(along.y, along.z) / along.x)
        };
        // Part of a wide cone may lie behind the plane through the light.
        let Some(edge) = (0..EDGE).map(edge).collect::<Option<Vec<DVec2>>>() else { return [low, high] };
        let first = edge.iter().copied().fold(DVec2::INFINITY, DVec2::min);
        let last = edge.iter().copied().fold(DVec2::NEG_INFINITY, DVec2::max);
        let (first, last) = (first.max(DVec2::new(low.y, low.z)), last.min(DVec2::new(high.y, high.z)));
        if first.cmplt(last).all() { [first.extend(low.x), last.extend(high.x)].map(|v| v.zxy()) } else { [low, high] }
    }
}

/// The unit direction from a point outside of a box that has all of the box in front of it, in the narrower cone: that to the middle of the box, or
/// that to its nearest point.
fn towards([low, high]: [DVec3; 2], from: DVec3) -> DVec3 {
    let corner = |bits: u32| {
        let end = |axis: u32| if bits >> axis & 1 == 1 { high } else { low };
        DVec3::new(end(0).x, end(1).y, end(2).z)
    };
    let widest =
        |direction: DVec3| (0..8).map(|bits| direction.dot((corner(bits) - from).normalize())).fold(1.0, f64::min);
    let [middle, nearest] = [0.5 * (low + high), from.clamp(low, high)].map(|point| (point - from).normalize());
    if widest(middle) > widest(nearest) { middle } else { nearest }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BOX: [DVec3; 2] = [DVec3::new(-1.0, -2.0, -0.5), DVec3::new(1.0, 2.0, 0.5)];

    fn corners() -> impl Iterator<Item = DVec3> {
        let end = |bits: u32, axis: u32| BOX[(bits >> axis & 1) as usize];
        (0..8).map(move |bits| DVec3::new(end(bits, 0).x, end(bits, 1).y, end(bits, 2).z))
    }

    #[test]
    fn all_of_the_box_is_in_front_of_a_light_outside_of_it() {
        for position in [DVec3::new(1.1, 1.9, 0.45), DVec3::new(0.0, 0.0, 0.6), DVec3::new(-9.0, 3.0, 40.0)] {
            let frame = Frame::new(&Source::Point(position), BOX).expect("it is outside");
            assert!(corners().all(|corner| frame.turned(corner).x > 0.0), "{position}");
        }
        for position in [DVec3::ZERO, DVec3::new(1.01, 0.0, 0.0), DVec3::new(0.9, 1.9, 0.5)] {
            assert!(Frame::new(&Source::Point(position), BOX).is_err(), "{position}");
        }
        Frame::new(&Source::Distant(DVec3::X), BOX).expect("a distant light is nowhere");
    }

    #[test]
    fn lines_from_the_light_are_parallel_to_x() {
        let light = DVec3::new(3.0, -1.0, 2.0);
        let frame = Frame::new(&Source::Point(light), BOX).expect("it is outside");
        let way = DVec3::new(-2.0, 0.7, -1.4);
        let [near, far] = [1.0, 3.0].map(|distance| frame.turned(light + way * distance));
        assert!(
            (near.y - far.y).abs() < 1e-12 && (near.z - far.z).abs() < 1e-12 && (far.x - 3.0 * near.x).abs() < 1e-12
        );
    }

    #[test]
    fn a_narrow_cone_takes_a_part_of_the_box() {
        let spot = |tangent: f64| {
            let source = Source::Spot { position: DVec3::Z * 4.0, axis: -DVec3::Z, tangent };
            let mut frame = Frame::new(&source, BOX).expect("it is outside");
            let empty = [DVec3::INFINITY, DVec3::NEG_INFINITY];
            let bounds =
                corners().map(|at| frame.turned(at)).fold(empty, |[low, high], at| [low.min(at), high.max(at)]);
            let [low, high] = frame.scale(&source, bounds);
            let unit = frame.unit_depth.expect("it is a point's");
            [(high[1] - low[1]) / unit, (high[2] - low[2]) / unit]
        };
        for across in spot(0.1) {
            assert!((0.2..0.201).contains(&across), "{across}");
        }
        // The whole box: at a depth of 3.5 it is 2 and 4 wide.
        let mut whole = spot(5.0);
        whole.sort_by(f64::total_cmp);
        assert!((whole[0] - 2.0 / 3.5).abs() < 1e-12 && (whole[1] - 4.0 / 3.5).abs() < 1e-12, "{whole:?}");
    }
}
