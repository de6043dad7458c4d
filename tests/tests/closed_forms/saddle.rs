//! Light that is sheared: Eq. 13 multiplies derivative lengths, and for a shear s that is too large by √(1 + s²) or more.

use vitrum::scene::Intensity;
use vitrum_conformance::Failure;
use vitrum_conformance::closed_forms::saddle::flux;
use vitrum_conformance::closed_forms::table;

use crate::setup::backends;

/// A plane's map is I − S + S² for a shear S, by two steps of the iteration that finds where light comes from: its area is right to the
/// third order in the shear. Lengths of 1 + s² and a shear of s make an Eq. 13 that is off by s² on each of four planes.
#[test]
fn the_jacobian_keeps_sheared_light_and_the_papers_product_does_not() -> Result<(), Failure> {
    for mut backend in backends() {
        let mut errors = [Vec::new(), Vec::new()];
        for strength in [0.5, 1.0, 2.0] {
            for (errors, intensity) in errors.iter_mut().zip([Intensity::Jacobian, Intensity::Paper]) {
                let (shear, flux) = flux(strength, intensity, backend.as_mut())?;
                println!(
                    "{} {intensity:?}: shear {shear:.4}, flux off by {:+.2} %",
                    backend.name(),
                    100.0 * (flux - 1.0)
                );
                errors.push((shear, (flux - 1.0).abs()));
            }
        }
        for ((shear, error), of_flux) in
            errors[0].iter().zip([table::SHEAR_WEAK, table::SHEAR_MIDDLE, table::SHEAR_STRONG])
        {
            of_flux.hold(*error, backend.as_ref());
            // s³, on four planes.
            assert!(*error < 4.0 * shear.powi(3) + 5e-4, "{error} at a shear of {shear}");
        }
        let [(coarse, small), _, (fine, large)] = errors[1][..] else { panic!("three strengths") };
        let order = (large / small).ln() / (fine / coarse).ln();
        assert!((1.8..2.3).contains(&order), "order {order} in the shear");
    }
    Ok(())
}
