//! 1, 2 and 5: media whose rays are known curves.

use vitrum::scene::Gradient;
use vitrum_conformance::closed_forms::curve::{CATENARY, PARABOLA, SINE, worst};
use vitrum_conformance::closed_forms::table;

use crate::setup::backends;

#[test]
fn rays_are_parabolas_catenaries_and_sines() {
    for mut backend in backends() {
        // A voxel is 0.031; second order in it leaves less than a thousandth of the edge.
        for (curve, of_position, of_slope) in [
            (PARABOLA, table::PARABOLA_POSITION, table::PARABOLA_SLOPE),
            (CATENARY, table::CATENARY_POSITION, table::CATENARY_SLOPE),
            (SINE, table::SINE_POSITION, table::SINE_SLOPE),
        ] {
            let (position, slope) = worst(&curve, 64, Gradient::Central, backend.as_mut());
            of_position.hold(position, backend.as_ref());
            of_slope.hold(slope, backend.as_ref());
        }
    }
}

/// Where nothing jumps, both rules are second order in the voxel's edge: trilinear interpolation and central differences are, and the
/// step, which is as long as a voxel, is too.
#[test]
fn both_gradients_are_second_order() {
    for mut backend in backends() {
        for gradient in [Gradient::Central, Gradient::Chain] {
            let [coarse, middle, fine] = [16, 32, 64].map(|n| worst(&SINE, n, gradient, backend.as_mut()).0);
            let order = (coarse / fine).log2() / 2.0;
            println!(
                "{} sine {gradient:?}: off by {coarse:.1e} at 16³, {middle:.1e} at 32³, {fine:.1e} at 64³, order {order:.2}",
                backend.name()
            );
            assert!((1.7..2.4).contains(&order), "{gradient:?}: order {order}");
        }
    }
}
