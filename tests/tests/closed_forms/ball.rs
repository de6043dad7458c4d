//! 7: a ball lens, R = 1, n = 1.5: where rays at impact height h cross the axis.

use crate::setup::{backends, cube, end, orthographic_frame, refracting, render, start};

/// (h, distance of the crossing from the centre).
const TRUTH: [(f64, f64); 5] = [(0.1, 1.4958), (0.25, 1.4737), (0.5, 1.3916), (0.75, 1.2410), (0.9, 1.1044)];

/// The exact crossing for any h, by Snell's law at both surfaces.
fn crossing(h: f64) -> f64 {
    let outside = h.asin();
    let inside = (h / 1.5).asin();
    h / (2.0 * (outside - inside)).sin()
}

#[test]
fn the_table_is_snells_law() {
    for (h, z) in TRUTH {
        assert!((crossing(h) - z).abs() < 1e-4, "h = {h}: {} instead of {z}", crossing(h));
    }
}

/// The largest relative error of the crossing over 0.1 ≤ h ≤ 0.75.
fn worst(n: u32, backend: &mut dyn vitrum::backend::Backend) -> f64 {
    let size = 2.4f32;
    let edge = f64::from(size) / f64::from(n) * 4.0;
    let volume = cube(n, size, |[x, y, z]| {
        let r = (x * x + y * y + z * z).sqrt();
        let t = ((1.0 - r) / edge + 0.5).clamp(0.0, 1.0);
        1.0 + 0.5 * t * t * (3.0 - 2.0 * t)
    });
    let mut scene = refracting(&volume, 64);
    scene.sweep.sample_distance = 0.5;
    let frame = render(&scene, &volume, backend);
    let (half, centre) = orthographic_frame(f64::from(size));
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
            worst = worst.max((z / crossing(h) - 1.0).abs());
        }
    }
    worst
}

#[test]
fn rays_cross_the_axis_where_snell_says() {
    for mut backend in backends() {
        let coarse = worst(64, backend.as_mut());
        let fine = worst(128, backend.as_mut());
        println!("{}: crossing off by {:.2} % at 64³, {:.2} % at 128³", backend.name(), 100.0 * coarse, 100.0 * fine);
        // The surface is a layer four voxels thick (0.075 R at 128³); its mean radius is right, its curvature to first order.
        assert!(fine < 0.03, "{fine}");
        assert!(fine < 0.75 * coarse, "{coarse} to {fine} when the voxels halve");
    }
}
