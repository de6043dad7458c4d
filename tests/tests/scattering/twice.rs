//! Light that was scattered exactly twice.

use vitrum_conformance::scattering::table::SETS;

/// Paths for each viewing ray.
const SAMPLES: u64 = 1 << 16;

/// The largest difference in standard errors: of six, one in sixty would be off by more.
const STANDARD_ERRORS: f64 = 3.0;

/// Sets and rays of the table, and radiance of light that was scattered twice. It is the integral over a viewing ray,
/// directions from it, and the lines in these directions: Gauss's rule with 48 angles at which the lamp sees the first
/// ray, 120 angles from the lamp with 96 azimuths around it, and 40 angles at which the lamp sees the line. Fewer, 32,
/// 80, 64 and 32, change the results by 2 · 10⁻⁵ at most.
const TWICE: [(usize, usize, f64); 6] = [
    (0, 0, 7.47960e-3),
    (0, 5, 8.84150e-4),
    (1, 3, 1.34721e-3),
    (1, 5, 3.45225e-4),
    (2, 0, 7.57221e-3),
    (3, 2, 1.60832e-3),
];

#[test]
fn light_scattered_twice_is_that_of_a_quadrature() {
    for (set, ray, expected) in TWICE {
        let found = SETS[set].look(ray, 2, SAMPLES, 21 + set as u64).more;
        let of_table = SETS[set].radiance()[ray][1];
        let off = [found, of_table].map(|estimate| estimate.off(expected));
        println!("set {set}, ray {ray}: {:.1e}, {off:.1?} standard errors", found.mean / expected - 1.0);
        assert!(
            off.iter().all(|off| off.abs() <= STANDARD_ERRORS),
            "set {set}, ray {ray}: {found:?}, {of_table:?}, not {expected}"
        );
    }
}
