//! 16: rays that turn back, or would turn back by the gradient of one point a step, are followed until they leave the volume.

use vitrum_conformance::closed_forms::table::{self, larger};
use vitrum_conformance::closed_forms::turned::{ball, eaton};

use crate::setup::{backends, cube, end, refracting, render};

#[test]
fn rays_through_a_ball_of_a_high_index_do_not_turn_back_falsely() {
    for mut backend in backends() {
        let (rays, wrong, median) = ball(128, backend.as_mut());
        println!("{}: of {rays} rays {:.2} % go wrong, median {median:.3}°", backend.name(), 100.0 * wrong);
        assert!(rays > 1500, "{rays} rays");
        table::DENSE_BALL_WRONG.hold(wrong, backend.as_ref());
        table::DENSE_BALL_MEDIAN.hold(median, backend.as_ref());
    }
}

#[test]
fn eatons_lens_sends_rays_back_to_where_they_come_from() {
    for mut backend in backends() {
        let (turn, aside) = eaton(192, backend.as_mut());
        println!("{}: off by {turn:.3}°, {aside:.4} radii", backend.name());
        table::EATON_TURN.hold(turn, backend.as_ref());
        table::EATON_SIDE.hold(aside, backend.as_ref());
    }
}

/// In a layer from 1 to 1/1.5, met at 43°, beyond the critical angle of 41.8°, a ray deviates by 94°.
#[test]
fn a_ray_reflected_totally_is_followed() {
    const DEGREES: f64 = 43.0;
    for mut backend in backends() {
        let (sin, cos) = DEGREES.to_radians().sin_cos();
        let volume = cube(96, 2.0, |[x, y, _]| {
            let t = ((x * sin - y * cos) / 0.3 + 0.5).clamp(0.0, 1.0);
            1.0 - t * t * (3.0 - 2.0 * t) / 3.0
        });
        let mut scene = refracting(&volume, 9);
        let middle = end(&render(&scene, &volume, backend.as_mut()), 4, 4);
        let cosine = -middle.direction[0] * sin - middle.direction[2] * cos;
        let angle = cosine.clamp(-1.0, 1.0).acos().to_degrees();
        println!("{}: {angle:.3}°, status {}", backend.name(), middle.status);
        assert_eq!(middle.status, vitrum_kernels::abi::record::status::LEFT);
        table::LAYER_FOLLOWED.hold(larger(0.0, (angle - (180.0 - DEGREES)).abs()), backend.as_ref());

        scene.sweep.follow_turned_rays = false;
        let frame = render(&scene, &volume, backend.as_mut());
        assert_eq!(end(&frame, 4, 4).status, vitrum_kernels::abi::record::status::TURNED);
        assert!(frame.statistics.rays_terminated.is_some_and(|rays| rays > 0), "the statistics count it");
    }
}
