//! 1, 2 and 5: media whose rays are known curves.

use vitrum::scene::Gradient;
use vitrum_conformance::closed_forms::curve::{CATENARY, PARABOLA, SINE, worst};

use crate::setup::backends;

#[test]
fn rays_are_parabolas_catenaries_and_sines() {
    for mut backend in backends() {
        for curve in [PARABOLA, CATENARY, SINE] {
            let (position, slope) = worst(&curve, 64, Gradient::Central, backend.as_mut());
            println!("{} {}: position off by {position:.5}, slope by {slope:.5}", backend.name(), curve.name);
            // A voxel is 0.031; second order in it leaves less than a thousandth of the edge.
            assert!(position < 2e-3 && slope < 2e-3, "{}: {position}, {slope}", curve.name);
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
