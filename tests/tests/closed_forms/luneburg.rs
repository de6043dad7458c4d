//! 3: the Luneburg lens, η² = 2 − r². A parallel beam meets at the antipode.

use vitrum::scene::{Gradient, Integrator};
use vitrum_conformance::closed_forms::luneburg::worst_miss;
use vitrum_conformance::closed_forms::table;

use crate::setup::backends;

/// In the lens, trilinear interpolation and central differences are second order in the voxel's edge. At its surface ∇η jumps by 1: a
/// layer one voxel thick in which it is wrong by something like ½ bends a ray by half a voxel at most, first order. So the order lies
/// between 1 and 2, for either rule, and one jump is enough to keep them alike.
#[test]
fn a_parallel_beam_meets_at_the_antipode() {
    for mut backend in backends() {
        let mut found = Vec::new();
        for (gradient, of_miss) in
            [(Gradient::Central, table::LUNEBURG_CENTRAL), (Gradient::Chain, table::LUNEBURG_CHAIN)]
        {
            let [coarse, middle, fine] =
                [32, 64, 128].map(|n| worst_miss(n, Integrator::Symplectic, gradient, backend.as_mut()));
            let order = (coarse / fine).log2() / 2.0;
            println!(
                "{} {gradient:?}: miss {coarse:.5} at 32³, {middle:.5} at 64³, {fine:.5} at 128³, order {order:.2}",
                backend.name()
            );
            assert!(middle < 0.5 * coarse && fine < 0.5 * middle, "{coarse}, {middle}, {fine}");
            assert!((1.0..2.2).contains(&order), "order {order}");
            of_miss.hold(fine, backend.as_ref());
            found.push(fine);
        }
        assert!(found[1] < found[0] && found[1] > 0.5 * found[0], "central and chain rule: {found:?}");
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
