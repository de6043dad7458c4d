//! 7: a ball lens, R = 1, n = 1.5: where rays at impact height h cross the axis.

use vitrum_conformance::closed_forms::ball::{crossing, worst_crossing};

use crate::setup::backends;

/// (h, distance of the crossing from the centre).
const TRUTH: [(f64, f64); 5] = [(0.1, 1.4958), (0.25, 1.4737), (0.5, 1.3916), (0.75, 1.2410), (0.9, 1.1044)];

#[test]
fn the_table_is_snells_law() {
    for (h, z) in TRUTH {
        assert!((crossing(h) - z).abs() < 1e-4, "h = {h}: {} instead of {z}", crossing(h));
    }
}

#[test]
fn rays_cross_the_axis_where_snell_says() {
    for mut backend in backends() {
        let coarse = worst_crossing(64, backend.as_mut());
        let fine = worst_crossing(128, backend.as_mut());
        println!("{}: crossing off by {:.2} % at 64³, {:.2} % at 128³", backend.name(), 100.0 * coarse, 100.0 * fine);
        // The surface is a layer four voxels thick (0.075 R at 128³); its mean radius is right, its curvature to first order.
        assert!(fine < 0.03, "{fine}");
        assert!(fine < 0.75 * coarse, "{coarse} to {fine} when the voxels halve");
    }
}
