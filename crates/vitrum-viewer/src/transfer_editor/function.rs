//! The four functions over the scalar, and the points of each.

use super::spots::{Spot, between_neighbours};
use vitrum::scene::{Bounds, ColorPoint, Control, IorPoint, OpacityPoint, TransferFunction, field};

/// A function over the scalar.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Function {
    /// Opacity.
    Opacity,
    /// Index of refraction.
    Ior,
    /// Reflectance of particles.
    Color,
    /// Transmittance of the clear medium.
    Filter,
}

trait Point: Copy {
    fn spot(&self) -> Spot;
    fn moved_to(self, spot: Spot) -> Self;
}

impl Point for OpacityPoint {
    fn spot(&self) -> Spot {
        Spot { value: self.value, level: [self.opacity, 0.0, 0.0] }
    }

    fn moved_to(self, spot: Spot) -> Self {
        Self { value: spot.value, opacity: spot.level[0] }
    }
}

impl Point for IorPoint {
    fn spot(&self) -> Spot {
        Spot { value: self.value, level: [self.ior, 0.0, 0.0] }
    }

    /// What else the point says, such as its dispersion, stays.
    fn moved_to(self, spot: Spot) -> Self {
        Self { value: spot.value, ior: spot.level[0], ..self }
    }
}

impl Point for ColorPoint {
    fn spot(&self) -> Spot {
        Spot { value: self.value, level: self.color }
    }

    fn moved_to(self, spot: Spot) -> Self {
        Self { value: spot.value, color: spot.level }
    }
}

/// Does the same to the list of points of a function, whatever their type.
macro_rules! with_points {
    ($function:expr, [$($reference:tt)+] $transfer:ident, $points:ident, $body:expr) => {
        match $function {
            Function::Opacity => {
                let $points = $($reference)+ $transfer.opacity;
                $body
            }
            Function::Ior => {
                let $points = $($reference)+ $transfer.ior;
                $body
            }
            Function::Color => {
                let $points = $($reference)+ $transfer.color;
                $body
            }
            Function::Filter => {
                let $points = $($reference)+ $transfer.filter;
                $body
            }
        }
    };
}

impl Function {
    /// Every function.
    pub const ALL: [Self; 4] = [Self::Opacity, Self::Ior, Self::Color, Self::Filter];

    /// Its name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Opacity => "opacity",
            Self::Ior => "index of refraction",
            Self::Color => "colour",
            Self::Filter => "filter",
        }
    }

    /// Whether its values are colours.
    #[must_use]
    pub fn is_of_color(self) -> bool {
        matches!(self, Self::Color | Self::Filter)
    }

    /// The key of the scene that holds what the function is at a point.
    fn key(self) -> &'static str {
        match self {
            Self::Opacity => "transfer.opacity.0.opacity",
            Self::Ior => "transfer.ior.0.ior",
            Self::Color => "transfer.color.0.color",
            Self::Filter => "transfer.filter.0.color",
        }
    }

    /// What the function means, as the scene's documentation has it.
    #[must_use]
    pub fn meaning(self) -> &'static str {
        field(self.key()).map_or("", |field| field.meaning.as_str())
    }

    /// The least and the greatest level, as the scene's schema has them.
    #[must_use]
    pub fn limits(self) -> [f32; 2] {
        match field(self.key()).map(|field| &field.control) {
            Some(Control::Number(Bounds { least, most, .. }) | Control::Color(Bounds { least, most, .. })) => {
                [*least, *most]
            }
            _ => [0.0, 1.0],
        }
    }

    /// A level within the limits.
    #[must_use]
    pub fn limited(self, level: [f32; 3]) -> [f32; 3] {
        let [least, most] = self.limits();
        let [first, ..] = level;
        if self.is_of_color() {
            level.map(|component| component.clamp(least, most))
        } else {
            [first.clamp(least, most), 0.0, 0.0]
        }
    }

    /// Its points, in ascending order of their values.
    #[must_use]
    pub fn spots(self, transfer: &TransferFunction) -> Vec<Spot> {
        with_points!(self, [&] transfer, points, points.iter().map(Point::spot).collect())
    }

    /// Replaces its points.
    pub fn set_spots(self, transfer: &mut TransferFunction, spots: &[Spot]) {
        match self {
            Self::Opacity => {
                let made = |spot: &Spot| OpacityPoint { value: spot.value, opacity: spot.level[0] };
                transfer.opacity = spots.iter().map(made).collect();
            }
            Self::Ior => {
                transfer.ior = spots.iter().map(|spot| IorPoint::new(spot.value, spot.level[0])).collect();
            }
            Self::Color => transfer.color = colors(spots),
            Self::Filter => transfer.filter = colors(spots),
        }
    }

    /// Adds a point, which takes what it says besides from the nearest one; its index. Where one has the value, that one is moved.
    pub fn add(self, transfer: &mut TransferFunction, spot: Spot) -> usize {
        let spot = Spot { level: self.limited(spot.level), ..spot };
        if self.spots(transfer).is_empty() {
            self.set_spots(transfer, &[spot]);
            return 0;
        }
        with_points!(self, [&mut] transfer, points, insert(points, spot))
    }

    /// Moves a point, but not past its neighbours, at whose value it makes a step; where it is then.
    pub fn move_to(self, transfer: &mut TransferFunction, index: usize, spot: Spot) -> Option<Spot> {
        let value = between_neighbours(&self.spots(transfer), index, spot.value)?;
        let spot = Spot { value, level: self.limited(spot.level) };
        with_points!(self, [&mut] transfer, points, {
            let point = points.get_mut(index)?;
            *point = point.moved_to(spot);
        });
        Some(spot)
    }

    /// Removes a point, if it is there.
    pub fn remove(self, transfer: &mut TransferFunction, index: usize) -> bool {
        with_points!(self, [&mut] transfer, points, {
            let is_there = index < points.len();
            if is_there {
                points.remove(index);
            }
            is_there
        })
    }
}

fn colors(spots: &[Spot]) -> Vec<ColorPoint> {
    spots.iter().map(|spot| ColorPoint { value: spot.value, color: spot.level }).collect()
}

fn insert<P: Point>(points: &mut Vec<P>, spot: Spot) -> usize {
    let index = points.partition_point(|point| point.spot().value < spot.value);
    match points.get_mut(index) {
        Some(point) if point.spot().value == spot.value => *point = point.moved_to(spot),
        _ => {
            let distance = |point: &P| (point.spot().value - spot.value).abs();
            let neighbours = [index.checked_sub(1), Some(index)].into_iter().flatten();
            let nearest = neighbours
                .filter_map(|index| points.get(index).copied())
                .min_by(|one, other| distance(one).total_cmp(&distance(other)));
            if let Some(nearest) = nearest {
                points.insert(index, nearest.moved_to(spot));
            }
        }
    }
    index
}

#[cfg(test)]
mod tests {
    use super::super::spots::at;
    use super::*;

    fn ramp() -> TransferFunction {
        let mut transfer = TransferFunction::default();
        let spot = |value, level| Spot { value, level: [level, 0.0, 0.0] };
        Function::Opacity.set_spots(&mut transfer, &[spot(0.0, 0.0), spot(10.0, 0.5), spot(20.0, 1.0)]);
        transfer
    }

    #[test]
    fn limits_are_those_of_the_scene() {
        assert_eq!(Function::ALL.map(Function::limits), [[0.0, 1.0], [0.2, 5.0], [0.0, 1.0], [0.0, 1.0]]);
        assert!(Function::ALL.iter().all(|function| !function.meaning().is_empty()));
    }

    #[test]
    fn points_keep_their_order_and_their_range() {
        let mut transfer = ramp();
        let moved = Function::Opacity.move_to(&mut transfer, 1, Spot { value: 99.0, level: [3.0, 0.0, 0.0] });
        assert_eq!(moved, Some(Spot { value: 20.0, level: [1.0, 0.0, 0.0] }));
        // A third point does not come to the value of a step.
        let index = Function::Opacity.add(&mut transfer, Spot { value: 5.0, level: [-1.0, 0.0, 0.0] });
        assert_eq!((index, transfer.opacity[1].opacity), (1, 0.0));
        let moved = Function::Opacity.move_to(&mut transfer, 1, Spot { value: 50.0, level: [0.2, 0.0, 0.0] });
        assert!(moved.is_some_and(|spot| spot.value < 20.0));
        assert_eq!(Function::Opacity.move_to(&mut transfer, 7, Spot { value: 0.0, level: [0.0; 3] }), None);
        assert!(transfer.opacity.is_sorted_by(|a, b| a.value <= b.value));
        let moved = Function::Opacity.move_to(&mut transfer, 0, Spot { value: f32::NAN, level: [0.0; 3] });
        assert_eq!(moved.map(|spot| spot.value), Some(0.0));
    }

    #[test]
    fn a_point_at_a_value_that_has_one_moves_it() {
        let mut transfer = ramp();
        assert_eq!(Function::Opacity.add(&mut transfer, Spot { value: 10.0, level: [0.7, 0.0, 0.0] }), 1);
        assert_eq!((transfer.opacity.len(), transfer.opacity[1].opacity), (3, 0.7));
        assert!(Function::Opacity.remove(&mut transfer, 1) && !Function::Opacity.remove(&mut transfer, 2));
    }

    #[test]
    fn dispersion_stays_with_its_point() {
        let ior = vec![IorPoint { abbe: Some(30.0), ..IorPoint::new(5.0, 1.5) }];
        let mut transfer = TransferFunction { ior, ..TransferFunction::default() };
        Function::Ior.move_to(&mut transfer, 0, Spot { value: 6.0, level: [9.0, 0.0, 0.0] });
        Function::Ior.add(&mut transfer, Spot { value: 8.0, level: [1.2, 0.0, 0.0] });
        assert_eq!([transfer.ior[0].abbe, transfer.ior[1].abbe], [Some(30.0); 2]);
        assert_eq!((transfer.ior[0].value, transfer.ior[0].ior), (6.0, 5.0));
    }

    #[test]
    fn functions_are_linear_between_points_and_constant_beyond() {
        let spots = Function::Opacity.spots(&ramp());
        for (value, level) in [(-5.0, 0.0), (5.0, 0.25), (10.0, 0.5), (19.0, 0.95), (99.0, 1.0)] {
            assert!(at(&spots, value).is_some_and(|found| (found[0] - level).abs() < 1e-6), "{value}");
        }
        assert_eq!(at(&[], 1.0), None);
    }
}
