//! 7: a ball lens, R = 1, n = 1.5: where rays at impact height h cross the axis.

use vitrum::backend::Backend;

use super::table::larger;
use super::{cube, end, orthographic_frame, refracting, render, start};

/// The edge of the volume's cube; the ball has radius 1.
pub const EDGE: f64 = 2.4;

/// The exact crossing for any h, by Snell's law at both surfaces.
#[must_use]
pub fn crossing(h: f64) -> f64 {
    let outside = h.asin();
    let inside = (h / 1.5).asin();
    h / (2.0 * (outside - inside)).sin()
}

/// The largest relative error of the crossing over 0.1 ≤ h ≤ 0.75, in a volume of `n`³ voxels whose surface is `layer` voxels
/// thick.
pub fn worst_crossing(n: u32, layer: f64, backend: &mut dyn Backend) -> f64 {
    let size = EDGE as f32;
    let edge = EDGE / f64::from(n) * layer;
    let volume = cube(n, size, |[x, y, z]| {
        let r = (x * x + y * y + z * z).sqrt();
        let t = ((1.0 - r) / edge + 0.5).clamp(0.0, 1.0);
        1.0 + 0.5 * t * t * (3.0 - 2.0 * t)
    });
    let mut scene = refracting(&volume, 64);
    scene.sweep.sample_distance = 0.5;
    let frame = render(&scene, &volume, backend);
    let (half, centre) = orthographic_frame(EDGE);
    let mut worst = 0.0f64;
    for y in 0..64 {
        for x in 0..64 {
            let [sx, sy] = start(&frame, x, y, half);
            let h = sx.hypot(sy);
            if !(0.1..0.75).contains(&h) {
                continue;
            }
            let end = end(&frame, x, y);
            // In the plane of incidence: distance from the axis along the start's direction.
            let radial = |v: [f64; 2]| (v[0] * sx + v[1] * sy) / h;
            let at = radial([end.position[0], end.position[1]]);
            let slope = radial([end.direction[0], end.direction[1]]) / -end.direction[2];
            let z = (centre - end.position[2]) - at / slope;
            worst = larger(worst, (z / crossing(h) - 1.0).abs());
        }
    }
    worst
}
