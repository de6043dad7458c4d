//! The ray step alone, with exact gradients: kick–drift–kick is second order, the paper's Euler step does not converge.

use vitrum_conformance::closed_forms::step::worst_miss as error;
use vitrum_conformance::closed_forms::table;
use vitrum_kernels::glam::Vec3;
use vitrum_kernels::optics::step::{flight, kick};

#[test]
fn orders_of_convergence() {
    for steps in [64, 128, 256, 512] {
        println!("{steps} planes: Euler {:.2e}, kick–drift–kick {:.2e}", error(steps, true), error(steps, false));
    }
    let order = |euler: bool| f64::from(error(64, euler) / error(256, euler)).log2() / 2.0;
    println!("orders: Euler {:.2}, kick–drift–kick {:.2}", order(true), order(false));
    // Rounding hides less than a tenth of an order: at 256 planes the miss is 1.6e-6, and 256 roundings of 6e-8 add up to some 1e-6 at most.
    assert!((1.9..2.2).contains(&order(false)), "{}", order(false));
    table::STEP.hold_native(f64::from(error(512, false)));
    // With Δs the distance of planes oblique rays are bent too little, however fine the planes are.
    assert!(order(true).abs() < 0.3 && error(512, true) > 5e-3, "{}, {}", order(true), error(512, true));
}

/// 4: Maxwell's fisheye, η = 2/(1 + r²). Rays from (0, 0, −1) meet at (0, 0, 1); the miss of one that starts at `degrees`.
fn fisheye(degrees: f32, steps: u32) -> f32 {
    let distance = 2.0 / steps as f32;
    let (sin, cos) = degrees.to_radians().sin_cos();
    let ior = |x: Vec3| 2.0 / (1.0 + x.length_squared());
    // ½∇(η²) = η∇η = −η³ x.
    let acceleration = |x: Vec3| x * -ior(x).powi(3);
    let mut x = Vec3::new(0.0, 0.0, -1.0);
    // Drift velocities: half a kick ahead of the first plane.
    let v = Vec3::new(sin, 0.0, cos);
    let mut v = v + acceleration(x) * (0.5 * flight(v, distance));
    for _ in 0..steps {
        let sigma = flight(v, distance);
        x = Vec3::new(x.x + v.x * sigma, x.y, x.z + distance);
        v = kick(v, acceleration(x), sigma, distance, 0.5, 0.01).direction;
    }
    x.x.abs()
}

#[test]
fn a_fisheye_images_a_point() {
    for (degrees, of_image) in [(10.0, table::FISHEYE_10), (30.0, table::FISHEYE_30), (50.0, table::FISHEYE_50)] {
        let (coarse, fine) = (fisheye(degrees, 64), fisheye(degrees, 256));
        println!("fisheye, {degrees}°: miss {coarse:.2e} with 64 planes, {fine:.2e} with 256");
        // Second order would be 16 times better; 8 leaves room for rounding.
        assert!(fine < coarse / 8.0, "{coarse}, {fine}");
        of_image.hold_native(f64::from(fine));
    }
}
