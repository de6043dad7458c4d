//! The place of values and levels in the window.

use super::axis::Axis;
use super::spots::Spot;
use eframe::egui::{Pos2, Rect, pos2};

/// Room at the sides, so that points at the ends are seen whole.
pub const MARGIN: f32 = 7.0;

/// The part of the window in which a function is drawn.
#[derive(Clone, Copy)]
pub struct Area {
    pub rect: Rect,
    pub axis: Axis,
    pub limits: [f32; 2],
    /// The power of the share of the height at which a level stands; 1 is linear.
    pub power: f32,
}

impl Area {
    pub fn x(self, value: f32) -> f32 {
        // Far beyond the ends the painter would overflow.
        self.rect.left() + self.axis.share(value).clamp(-10.0, 10.0) * self.rect.width()
    }

    pub fn value(self, x: f32) -> f32 {
        self.axis.value(((x - self.rect.left()) / self.rect.width()).clamp(0.0, 1.0))
    }

    pub fn place(self, value: f32, level: f32) -> Pos2 {
        let [low, high] = self.limits;
        let share = libm::powf(((level - low) / (high - low)).clamp(0.0, 1.0), self.power);
        pos2(self.x(value), self.rect.bottom() - share * self.rect.height())
    }

    pub fn level(self, y: f32) -> f32 {
        let [low, high] = self.limits;
        let share = ((self.rect.bottom() - y) / self.rect.height()).clamp(0.0, 1.0);
        low + (high - low) * libm::powf(share, 1.0 / self.power)
    }

    /// The places of a curve through `spots`, to both sides of the area.
    pub fn curve(self, spots: &[Spot]) -> Vec<Pos2> {
        let pieces = if self.power == 1.0 { 1 } else { 24 };
        let mut places = Vec::new();
        let [low, high] = self.axis.range;
        places.extend(spots.first().map(|spot| self.place(low.min(spot.value), spot.level[0])));
        for pair in spots.windows(2) {
            let mixed = |step: usize| {
                let t = step as f32 / pieces as f32;
                let mix = |from: f32, to: f32| from + (to - from) * t;
                self.place(mix(pair[0].value, pair[1].value), mix(pair[0].level[0], pair[1].level[0]))
            };
            places.extend((0..=pieces).map(mixed));
        }
        places.extend(spots.last().map(|spot| self.place(high.max(spot.value), spot.level[0])));
        places
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use eframe::egui::vec2;

    #[test]
    fn places_and_points_are_each_others_inverse() {
        for power in [1.0, 1.0 / 3.0] {
            let rect = Rect::from_min_size(pos2(10.0, 20.0), vec2(200.0, 100.0));
            let area = Area { rect, axis: Axis::over([-50.0, 150.0]), limits: [0.0, 1.0], power };
            let at = area.place(100.0, 0.25);
            assert!((area.value(at.x) - 100.0).abs() < 1e-3 && (area.level(at.y) - 0.25).abs() < 1e-5);
            assert_eq!(area.place(-50.0, 0.0), rect.left_bottom());
            assert_eq!(area.place(150.0, 1.0), rect.right_top());
        }
    }
}
