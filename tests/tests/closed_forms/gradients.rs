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
