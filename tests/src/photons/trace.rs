//! A photon's way: an adaptive Runge–Kutta solution of the ray equation.

use vitrum_kernels::glam::DVec3;

use super::field::Field;

/// The error of a step, in voxels, above which it is repeated with a smaller one.
const TOLERANCE: f64 = 1e-3;
/// The longest step, in voxels.
const LONGEST: f64 = 1.0;
/// The distance from a face of the box at which a photon goes on behind it, in voxels.
const HAIR: f64 = 1e-6;
/// Steps after which a photon counts as trapped.
const MOST_STEPS: usize = 20_000;

/// A photon: position, optical direction v = η dx/ds, and what absorption has left of it.
#[derive(Debug, Clone, Copy)]
pub struct Photon {
    /// Position in the view frame.
    pub position: DVec3,
    /// Optical direction.
    pub direction: DVec3,
    /// Transmittance of red, green and blue.
    pub weight: DVec3,
}

impl Photon {
    /// Follows the photon through the medium and calls `crosses` with each of the ascending `depths` it crosses forwards, its
    /// position there and its weight. A photon that turns back crosses no more.
    pub fn follow(mut self, field: &Field, depths: &[f64], mut crosses: impl FnMut(usize, DVec3, DVec3)) {
        let mut next = 0;
        let mut step = 0.1 * field.voxel();
        for _ in 0..MOST_STEPS {
            if next == depths.len() || self.direction.z <= 0.0 {
                return;
            }
            let before = self;
            match field.contains(self.position) {
                true => {
                    step = self.advance(field, step);
                    if !field.contains(self.position) {
                        self.leave(field, &before);
                    }
                }
                false => {
                    let Some((enters, _)) = field.crossing(self.position, self.direction) else { break };
                    let face = self.position + self.direction * enters;
                    self.direction = field.refracted(face, self.direction, true);
                    self.position = face + self.direction.normalize() * (HAIR * field.voxel());
                }
            }
            while next < depths.len() && self.position.z >= depths[next] && self.direction.z > 0.0 {
                let t = (depths[next] - before.position.z) / (self.position.z - before.position.z);
                crosses(next, before.position.lerp(self.position, t), before.weight.lerp(self.weight, t));
                next += 1;
            }
        }
        for (index, depth) in depths.iter().enumerate().skip(next) {
            let along = (depth - self.position.z) / self.direction.z;
            if self.direction.z > 0.0 && !field.contains(self.position) {
                crosses(index, self.position + self.direction * along, self.weight);
            }
        }
    }

    /// Moves a photon that has left the box back to the face through which it left, on the way from `before`, and refracts it there.
    fn leave(&mut self, field: &Field, before: &Self) {
        let way = self.position - before.position;
        let share = field.crossing(before.position, way).map_or(1.0, |(_, leaves)| leaves.clamp(0.0, 1.0));
        let face = before.position + way * share;
        self.direction = field.refracted(face, before.direction.lerp(self.direction, share), false);
        self.weight = before.weight.lerp(self.weight, share);
        self.position = face + self.direction.normalize() * (HAIR * field.voxel());
    }

    /// One accepted step of Bogacki & Shampine's pair of orders 3 and 2, over a length of about `step`; the next step's length.
    fn advance(&mut self, field: &Field, mut step: f64) -> f64 {
        let voxel = field.voxel();
        let start = field.acceleration(self.position);
        loop {
            let sigma = step / self.direction.length();
            let (x, v) = (self.position, self.direction);
            let at = |x: DVec3| field.acceleration(x);
            let (k1x, k1v) = (v, start);
            let (k2x, k2v) = (v + k1v * (0.5 * sigma), at(x + k1x * (0.5 * sigma)));
            let (k3x, k3v) = (v + k2v * (0.75 * sigma), at(x + k2x * (0.75 * sigma)));
            let to = x + (k1x * 2.0 + k2x * 3.0 + k3x * 4.0) * (sigma / 9.0);
            let direction = v + (k1v * 2.0 + k2v * 3.0 + k3v * 4.0) * (sigma / 9.0);
            let k4v = at(to);
            // The difference to the second-order solution; a direction's error counts over the length of the step.
            let error_x = (k1x * -5.0 + k2x * 6.0 + k3x * 8.0 - direction * 9.0).length() * (sigma / 72.0);
            let error_v = (k1v * -5.0 + k2v * 6.0 + k3v * 8.0 - k4v * 9.0).length() * (sigma / 72.0);
            let error = (error_x + error_v * sigma) / voxel;
            let factor = (0.9 * (TOLERANCE / error.max(1e-12)).cbrt()).clamp(0.2, 3.0);
            let next = (step * factor).clamp(1e-3 * voxel, LONGEST * voxel);
            if error <= TOLERANCE || step <= 1.01e-3 * voxel {
                let mean = (field.extinction(x) + field.extinction(to) + field.extinction(x.midpoint(to)) * 4.0) / 6.0;
                self.weight *= (mean * -(to - x).length()).map(f64::exp);
                (self.position, self.direction) = (to, direction);
                return next;
            }
            step = next;
        }
    }
}
