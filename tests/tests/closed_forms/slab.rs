//! 9: a thin slab η = 1 + ε cos kx focuses parallel light: on-axis irradiance 1/(1 − Z/Z_f), Z_f = 1/(ε k² t).

use vitrum::scene::Intensity;
use vitrum_conformance::closed_forms::slab::irradiance;

use crate::setup::backends;

/// Light texels per pixel edge: 49 a period, about the voxels' size.
const RESOLUTION: f32 = 2.0;

#[test]
fn light_gets_brighter_towards_the_focus() {
    for mut backend in backends() {
        for (share, on_axis, beside, sample_distance) in
            [(0.25, 1.333, 0.8, 1.0), (0.5, 2.0, 0.667, 1.0), (0.75, 4.0, 0.571, 1.0), (0.75, 4.0, 0.571, 4.0)]
        {
            let (middle, side, mean) =
                irradiance(share, RESOLUTION, sample_distance, Intensity::Jacobian, backend.as_mut());
            println!(
                "{}: Z = {share} Z_f, planes every {sample_distance} voxels: on axis {middle:.3} (truth {on_axis}), beside {side:.3} (truth {beside}), mean {mean:.4}",
                backend.name()
            );
            assert!((mean - 1.0).abs() < 0.02, "flux is conserved: {mean}");
            assert!((side / beside - 1.0).abs() < 0.02, "{side} instead of {beside}");
            // Interpolation blurs a little on each of some 150 to 250 planes, and the peak gets narrower and higher towards the
            // focus: 0 %, 3 % and 18 % are missing at ¼, ½ and ¾ of the way; with a quarter of the planes 14 %.
            let bound = match share {
                s if s < 0.3 => 0.01,
                s if s < 0.6 => 0.03,
                _ => 0.2,
            };
            assert!((middle / on_axis - 1.0).abs() < bound, "{middle} instead of {on_axis}");
        }
    }
}

#[test]
fn without_correction_there_is_no_caustic() {
    for mut backend in backends() {
        let (middle, side, _) = irradiance(0.5, RESOLUTION, 1.0, Intensity::None, backend.as_mut());
        assert!((middle - 1.0).abs() < 1e-3 && (side - 1.0).abs() < 1e-3, "{middle}, {side}");
    }
}

/// More light texels blur less on each plane. The blur of one plane goes with the square of a texel's edge, and the peak is as much too
/// low as it is wide: towards the focus, where it gets narrow, the error falls, but not yet with an order.
#[test]
fn more_light_texels_come_closer() {
    for mut backend in backends() {
        for (share, truth) in [(0.5, 2.0), (0.75, 4.0)] {
            let error = |resolution: f32, backend: &mut dyn vitrum::backend::Backend| {
                (irradiance(share, resolution, 1.0, Intensity::Jacobian, backend).0 / truth - 1.0).abs()
            };
            let errors = [0.5, 1.0, 2.0, 4.0].map(|resolution| error(resolution, backend.as_mut()));
            println!("{}: at {share} of the focal distance off by {errors:.3?}", backend.name());
            assert!(errors.is_sorted_by(|more, less| more > less), "{errors:?}");
            assert!(errors[3] < 0.06, "{errors:?}");
        }
    }
}
