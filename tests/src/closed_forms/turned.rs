//! Rays that a sweep over planes cannot follow, or could not with one gradient a step: a ball of a high index, and Eaton's lens.

use vitrum::backend::Backend;
use vitrum_kernels::abi::record::status;

use super::table::larger;
use super::{End, cube, end, orthographic_frame, refracting, render, start};

/// The edge of the volume's cube; the lens has radius 1.
const EDGE: f64 = 2.4;
/// Pixels along an edge of the picture.
const PIXELS: u32 = 96;

/// The rays of a picture that is `PIXELS` wide: height over the axis, the direction of the start's place from the axis, and the end.
fn rays(n: u32, backend: &mut dyn Backend, field: impl Fn(f64) -> f64) -> Vec<(f64, [f64; 2], End)> {
    let volume = cube(n, EDGE as f32, |[x, y, z]| field((x * x + y * y + z * z).sqrt()));
    let scene = refracting(&volume, PIXELS);
    let frame = render(&scene, &volume, backend);
    let (half, _) = orthographic_frame(EDGE);
    let pixels = (0..PIXELS).flat_map(|y| (0..PIXELS).map(move |x| (x, y)));
    let ray = |(x, y)| {
        let [sx, sy] = start(&frame, x, y, half);
        let height = sx.hypot(sy);
        (height, [sx / height, sy / height], end(&frame, x, y))
    };
    pixels.map(ray).collect()
}

/// The angle of a ray's direction from the direction of view, degrees: positive towards the axis, −180 to 180.
fn deviation([x, y]: [f64; 2], end: &End) -> f64 {
    let [dx, dy, dz] = end.direction;
    (-(dx * x + dy * y)).atan2(-dz).to_degrees()
}

/// Of the rays through a ball of index 2.4 whose deviation 2 (asin h − asin (h / n)) is below 80°: their number, the share that ended as
/// turned or deviates by more than 10° from it, and the median error of the others' deviation, degrees.
pub fn ball(n: u32, backend: &mut dyn Backend) -> (usize, f64, f64) {
    const IOR: f64 = 2.4;
    // A surface four voxels thick.
    let edge = EDGE / f64::from(n) * 4.0;
    let rays = rays(n, backend, |r| {
        let t = ((1.0 - r) / edge + 0.5).clamp(0.0, 1.0);
        1.0 + (IOR - 1.0) * t * t * (3.0 - 2.0 * t)
    });
    let truth = |height: f64| 2.0 * (height.asin() - (height / IOR).asin()).to_degrees();
    let errors: Vec<f64> = rays
        .iter()
        .filter(|(height, ..)| *height < 0.95 && truth(*height) < 80.0)
        .map(|(height, side, end)| {
            let followed = end.status == status::ACTIVE || end.status == status::LEFT;
            if followed { (deviation(*side, end) - truth(*height)).abs() } else { 180.0 }
        })
        .collect();
    let wrong = errors.iter().filter(|&&error| error > 10.0).count();
    let mut sorted = errors.clone();
    sorted.sort_by(f64::total_cmp);
    (errors.len(), wrong as f64 / errors.len() as f64, sorted[sorted.len() / 2])
}

/// The largest angle by which rays leave Eaton's lens, η² = 2/r − 1 inside r = 1, otherwise than back to where they come from, degrees; and
/// the largest distance from their truth, which is the start's mirror image at the axis; of rays at heights 0.6 to 0.9.
pub fn eaton(n: u32, backend: &mut dyn Backend) -> (f64, f64) {
    let rays = rays(n, backend, |r| (2.0 / r.clamp(0.08, 1.0) - 1.0).sqrt());
    let (mut turn, mut aside) = (0.0, 0.0);
    for (height, [x, y], end) in rays.iter().filter(|(height, ..)| (0.6..0.9).contains(height)) {
        assert_eq!(end.status, status::LEFT, "a ray at {height} is followed until it leaves");
        let back = deviation([*x, *y], end).abs();
        turn = larger(turn, 180.0 - back);
        let [px, py, _] = end.position;
        aside = larger(aside, (px + x * height).hypot(py + y * height));
    }
    (turn, aside)
}
