//! 3: the Luneburg lens, η² = 2 − r². A parallel beam meets at the antipode.

use vitrum::scene::{Gradient, Integrator};
use vitrum_conformance::closed_forms::luneburg::worst_miss;

use crate::setup::backends;

#[test]
fn a_parallel_beam_meets_at_the_antipode() {
    for mut backend in backends() {
        for gradient in [Gradient::Central, Gradient::Chain] {
            let coarse = worst_miss(32, Integrator::Symplectic, gradient, backend.as_mut());
            let fine = worst_miss(64, Integrator::Symplectic, gradient, backend.as_mut());
            println!("{} {gradient:?}: miss {coarse:.5} at 32³, {fine:.5} at 64³", backend.name());
            // Trilinear interpolation and central differences are second order in the voxel's edge (1/29 here): a few h².
            assert!(fine < 0.01, "{fine}");
            assert!(fine < coarse * 0.5, "{coarse} to {fine} when the voxels halve");
        }
    }
}

#[test]
fn the_papers_euler_step_misses_by_more() {
    for mut backend in backends() {
        let euler = worst_miss(64, Integrator::Euler, Gradient::Central, backend.as_mut());
        let symplectic = worst_miss(64, Integrator::Symplectic, Gradient::Central, backend.as_mut());
        println!("{}: Euler {euler:.5}, symplectic {symplectic:.5}", backend.name());
        assert!(euler > 3.0 * symplectic, "Euler {euler}, symplectic {symplectic}");
    }
}
