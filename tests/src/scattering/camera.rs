//! A pinhole camera.

use vitrum_kernels::glam::{DMat3, DVec3};

/// A pinhole camera whose picture is upright along z.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Camera {
    eye: DVec3,
    /// Unit vectors to the right, up and ahead.
    axes: DMat3,
    /// The edge of a pixel at a distance of 1 ahead.
    edge: f64,
    size: [usize; 2],
}

impl Camera {
    /// A camera at `eye` that looks at `target`, not straight up or down; its picture is `field_of_view` degrees high
    /// and has square pixels, `size` across and down.
    #[must_use]
    pub fn new(eye: DVec3, target: DVec3, field_of_view: f64, size: [usize; 2]) -> Self {
        let ahead = (target - eye).normalize();
        let right = ahead.cross(DVec3::Z).normalize();
        let edge = 2.0 * (0.5 * field_of_view).to_radians().tan() / size[1] as f64;
        Self { eye, axes: DMat3::from_cols(right, right.cross(ahead), ahead), edge, size }
    }

    /// The pinhole.
    #[must_use]
    pub fn eye(&self) -> DVec3 {
        self.eye
    }

    /// The number of pixels.
    #[must_use]
    pub fn pixels(&self) -> usize {
        self.size[0] * self.size[1]
    }

    /// The unit direction of the viewing ray through a point of the picture, in pixels to the right and down from its
    /// upper left corner.
    #[must_use]
    pub fn direction(&self, across: f64, down: f64) -> DVec3 {
        let [half_width, half_height] = self.half_size();
        (self.axes * DVec3::new(across * self.edge - half_width, half_height - down * self.edge, 1.0)).normalize()
    }

    /// The pixel, row by row from the top, that shows a point, and the mean radiance over it of a source of 1 W/sr
    /// there, in 1 / world unit², with nothing in between. A source's light of I / d² at the eye is radiance in a solid
    /// angle of A cos³ θ, for a pixel of area A at a distance of 1 ahead.
    #[must_use]
    pub fn sees(&self, point: DVec3) -> Option<(usize, f64)> {
        let seen = self.axes.transpose() * (point - self.eye);
        let [half_width, half_height] = self.half_size();
        let across = ((seen.x / seen.z + half_width) / self.edge).floor();
        let down = ((half_height - seen.y / seen.z) / self.edge).floor();
        let [width, height] = self.size.map(|pixels| pixels as f64);
        let inside = seen.z > 0.0 && (0.0..width).contains(&across) && (0.0..height).contains(&down);
        let area = self.edge * self.edge;
        inside.then(|| {
            (down as usize * self.size[0] + across as usize, seen.length() / (seen.z * seen.z * seen.z * area))
        })
    }

    /// The part of a ray between two distances that the picture shows.
    #[must_use]
    pub fn shows(&self, from: DVec3, towards: DVec3, [mut first, mut last]: [f64; 2]) -> Option<[f64; 2]> {
        let [from, towards] = [from - self.eye, towards].map(|vector| self.axes.transpose() * vector);
        let [half_width, half_height] = self.half_size();
        // The planes through the picture's edges.
        for (axis, half) in [(0, half_width), (1, half_height)] {
            for side in [-1.0, 1.0] {
                let [start, slope] = [from, towards].map(|vector| half * vector.z + side * vector[axis]);
                if slope > 0.0 {
                    first = first.max(-start / slope);
                } else if slope < 0.0 {
                    last = last.min(-start / slope);
                } else if start < 0.0 {
                    return None;
                }
            }
        }
        (first < last).then_some([first, last])
    }

    /// Half the picture's width and height at a distance of 1 ahead.
    fn half_size(&self) -> [f64; 2] {
        self.size.map(|pixels| 0.5 * self.edge * pixels as f64)
    }
}
