//! Horizontal sheets: the transmittance everywhere below them is e^(−optical depth).

use super::{ABOVE, case, on_both, sheets};
use vitrum_conformance::Failure;
use vitrum_conformance::shadow::Map;
use vitrum_kernels::glam::DVec3;

/// Rounding of a transmittance to 16 bits, and of a sum of four of them in floats.
const ROUNDING: f64 = 1.2e-5;

/// Points across a square with the half edge `half`, diagonals and voxels' faces among them.
fn across(half: f64) -> impl Iterator<Item = [f64; 2]> {
    let at = move |i: u32| (f64::from(i) / 48.0 - 1.0) * half;
    (0..=96).flat_map(move |y| (0..=96).map(move |x| [at(x), at(y)]))
}

#[test]
fn coincident_sheets_multiply() -> Result<(), Failure> {
    for resolution in [16, 50, 128] {
        let setting = format!("shadow.resolution={resolution}");
        for (count, depth) in [(1, 0.3), (3, 0.3), (7, 0.11), (40, 0.02)] {
            let material = format!("material.0.density={depth}");
            let case = case(sheets(vec![0.0; count]), 8, &[&ABOVE[..], &[&setting, &material]].concat())?;
            on_both(|backend| {
                let map = Map::of(&case, backend)?;
                let expected = (-(count as f64) * depth).exp();
                // Beside the outermost voxel of the sheet, whose neighbours are lit.
                for [x, y] in across(1.0 - 1.01 * map.edge()) {
                    for below in [2.0, 17.3] {
                        let [found, ..] = map.at(DVec3::new(x, y, -below * map.edge()));
                        assert!(
                            (found - expected).abs() < ROUNDING,
                            "{count}: {found} at {x}, {y}, expected {expected}"
                        );
                    }
                    assert_eq!(map.at(DVec3::new(x, y, 2.0 * map.edge())), [1.0; 3], "above it");
                }
                assert_eq!(map.at(DVec3::new(1.0 + 2.0 * map.edge(), 0.0, -1.0)), [1.0; 3], "beside it");
                Ok(())
            })?;
        }
    }
    Ok(())
}

/// Behind k of a stack of sheets e^(−k c) is left, whichever way light goes through.
#[test]
fn a_stack_darkens_step_by_step() -> Result<(), Failure> {
    for (elevation, azimuth) in [(90.0, 0.0), (60.0, 30.0), (35.0, 200.0)] {
        let light = [format!("light.0.elevation={elevation}"), format!("light.0.azimuth={azimuth}")];
        let settings = [light[0].as_str(), light[1].as_str(), "material.0.density=0.2", "shadow.resolution=160"];
        let case = case(sheets((0..5).map(|k| f64::from(k) * 0.1)), 8, &settings)?;
        on_both(|backend| {
            let map = Map::of(&case, backend)?;
            // Midway between two sheets, more than a voxel and a half away from each.
            assert!(map.edge() < 0.03, "{}", map.edge());
            for (behind, height) in [(0, 0.45), (1, 0.35), (2, 0.25), (3, 0.15), (4, 0.05), (5, -0.05)] {
                // Away from the edges, over which oblique light comes in.
                for [x, y] in across(0.2) {
                    let [found, ..] = map.at(DVec3::new(x, y, height));
                    let expected = (-0.2 * f64::from(behind)).exp();
                    assert!(
                        (found - expected).abs() < ROUNDING,
                        "{elevation}° behind {behind}: {found}, not {expected}"
                    );
                }
            }
            Ok(())
        })?;
    }
    Ok(())
}

/// Light that is 30° from straight above moves the shadow by the tangent of that, times the height.
#[test]
fn oblique_light_moves_the_shadow_by_its_tangent() -> Result<(), Failure> {
    for resolution in [64, 256] {
        let setting = format!("shadow.resolution={resolution}");
        // From the right of one who looks from the front, which is world −x.
        let settings = ["light.0.elevation=60", "light.0.azimuth=90", &setting];
        let case = case(sheets([0.0]), 8, &settings)?;
        on_both(|backend| {
            let map = Map::of(&case, backend)?;
            for height in [0.5, 1.0, 3.0] {
                let shift = height * 30f64.to_radians().tan() * map.light().x.signum();
                for edge in [-1.0, 1.0] {
                    // Where the light falls to a half, by halving.
                    let (mut lit, mut dark) = (edge * 1.5 + shift, edge * 0.5 + shift);
                    for _ in 0..40 {
                        let middle = 0.5 * (lit + dark);
                        let [found, ..] = map.at(DVec3::new(middle, 0.1, -height));
                        (lit, dark) = if found > 0.5 { (middle, dark) } else { (lit, middle) };
                    }
                    // A column is in the shadow or is not: half a voxel, on the ground longer by 1 / cos 30°.
                    let bound = 0.5 * map.edge() / 30f64.to_radians().cos() + 1e-6;
                    assert!((lit - edge - shift).abs() < bound, "{resolution}, {height}: {lit}, not {}", edge + shift);
                }
            }
            Ok(())
        })?;
    }
    Ok(())
}

/// With one coefficient for all, n coincident sheets are one occupied voxel.
#[test]
fn a_uniform_coefficient_does_not_count() -> Result<(), Failure> {
    let settings = ["shadow.coefficient=uniform", "shadow.optical_depth=0.4", "shadow.resolution=64"];
    let case = case(sheets([0.0, 0.0, 0.0, 0.5]), 8, &[&ABOVE[..], &settings].concat())?;
    on_both(|backend| {
        let map = Map::of(&case, backend)?;
        for [x, y] in across(0.9) {
            let [found, ..] = map.at(DVec3::new(x, y, -0.2));
            assert!((found - (-0.8f64).exp()).abs() < ROUNDING, "{found}");
        }
        Ok(())
    })
}

/// A soft shadow's edge is as wide as the filter, and its middle stays where it is.
#[test]
fn softness_is_a_length_in_the_world() -> Result<(), Failure> {
    for resolution in [32, 96] {
        let setting = format!("shadow.resolution={resolution}");
        let case = case(sheets([0.0]), 8, &[&ABOVE[..], &[&setting, "shadow.filter_radius=0.2"]].concat())?;
        on_both(|backend| {
            let map = Map::of(&case, backend)?;
            let at = |x: f64| map.at(DVec3::new(1.0 + x, 0.05, -0.5))[0];
            let reach = 0.2 + 1.6 * map.edge();
            assert!(at(-reach) < ROUNDING && at(reach) == 1.0);
            // A tent's integral up to half of its half width is 1/8; the sheet's edge is known to half a voxel.
            let slack = 0.5 * map.edge() / (0.2 + map.edge()) + 0.01;
            assert!((at(0.0) - 0.5).abs() < slack, "{}", at(0.0));
            assert!((at(-0.5 * (0.2 + map.edge())) - 0.125).abs() < slack, "{}", at(-0.1));
            Ok(())
        })?;
    }
    Ok(())
}
