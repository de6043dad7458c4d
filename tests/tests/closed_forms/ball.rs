//! 7: a ball lens, R = 1, n = 1.5: where rays at impact height h cross the axis.

use vitrum_conformance::closed_forms::ball::{crossing, worst_crossing};
use vitrum_conformance::closed_forms::table;

use crate::setup::backends;

/// (h, distance of the crossing from the centre).
const TRUTH: [(f64, f64); 5] = [(0.1, 1.4958), (0.25, 1.4737), (0.5, 1.3916), (0.75, 1.2410), (0.9, 1.1044)];

#[test]
fn the_table_is_snells_law() {
    for (h, z) in TRUTH {
        assert!((crossing(h) - z).abs() < 1e-4, "h = {h}: {} instead of {z}", crossing(h));
    }
}

/// A surface of a fixed number of voxels looks the same to a ray however fine the voxels are: how far the voxels turn its normal does not
/// fall with them, and with it the error of the worst ray stays. Thicker, it is turned less; what is left is the error of a surface that is a
/// layer, first order in its thickness.
#[test]
fn rays_cross_the_axis_where_snell_says() {
    for mut backend in backends() {
        let mut errors = |layer: f64| [64, 128].map(|n| worst_crossing(n, layer, backend.as_mut()));
        let ([thin, thin_fine], [coarse, fine]) = (errors(4.0), errors(8.0));
        let order = (coarse / fine).log2();
        // A normal that is off by 1° moves a crossing by 2 %.
        table::BALL_THIN.hold(thin, backend.as_ref());
        table::BALL_THIN_FINE.hold(thin_fine, backend.as_ref());
        table::BALL_THICK.hold(coarse, backend.as_ref());
        table::BALL_THICK_FINE.hold(fine, backend.as_ref());
        assert!(order > 0.5, "{coarse} to {fine} when the voxels halve, order {order}");
    }
}
