//! Tabulated phase functions, as kernels read them.

use vitrum_kernels::abi::beams::PHASES;

/// The value at an angle, in steps of the table, linear between its values.
fn at(values: &[f32], place: f64) -> f64 {
    let last = values.len() - 1;
    let first = (place.max(0.0) as usize).min(last.saturating_sub(1));
    let [low, high] = [first, (first + 1).min(last)].map(|index| f64::from(values[index]));
    low + (high - low) * (place - first as f64)
}

/// The phase function over the isotropic one at [`PHASES`] even steps of x = sin(θ/2), of `values` at even steps of the angle θ from 0 to π. Its integral
/// over all directions, with the linear interpolation of the kernels, is that of the isotropic one.
pub(super) fn table(values: &[f32]) -> Vec<f32> {
    // The check of scenes refuses fewer.
    if values.len() < 2 {
        return vec![1.0; PHASES as usize];
    }
    let last = f64::from(PHASES - 1);
    let steps = (values.len() - 1) as f64;
    let place = |index: u32| 2.0 * libm::asin(f64::from(index) / last) / std::f64::consts::PI * steps;
    let sampled: Vec<f64> = (0..PHASES).map(|index| at(values, place(index))).collect();
    // ∫ p dω = 8 π ∫ p x dx, and 4 π of the isotropic one: over each step p is linear.
    let width = 1.0 / last;
    let integral: f64 = sampled
        .windows(2)
        .enumerate()
        .map(|(index, pair)| {
            let (x, low, change) = (index as f64 * width, pair[0], pair[1] - pair[0]);
            width * (low * x + 0.5 * (low * width + change * x) + change * width / 3.0)
        })
        .sum();
    sampled.iter().map(|value| (value / (2.0 * integral)) as f32).collect()
}

/// The mean cosine of the angle that light is scattered by, of a phase function as [`table`] gives it.
pub(super) fn mean_cosine(table: &[f32]) -> f64 {
    let last = (table.len() - 1) as f64;
    let (mut whole, mut along) = (0.0, 0.0);
    for (index, &value) in table.iter().enumerate() {
        let x = index as f64 / last;
        // cos θ = 1 − 2 sin²(θ/2), and ∫ p dω = 8 π ∫ p x dx, by trapezoids: x is 0 at the first.
        let weight = f64::from(value) * x * if index + 1 == table.len() { 0.5 } else { 1.0 };
        whole += weight;
        along += weight * (1.0 - 2.0 * x * x);
    }
    if whole > 0.0 { along / whole } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Henyey and Greenstein's function over the isotropic one, at the cosine `cosine`.
    fn henyey_greenstein(g: f64, cosine: f64) -> f64 {
        let base = 1.0 + g * g - 2.0 * g * cosine;
        (1.0 - g * g) / (base * base.sqrt())
    }

    #[test]
    fn a_table_of_a_known_function_gives_it_back_in_any_unit() {
        for g in [-0.5, 0.0, 0.8] {
            let values: Vec<f32> = (0..=3600)
                .map(|step| {
                    (7.0 * henyey_greenstein(g, libm::cos(f64::from(step) / 3600.0 * std::f64::consts::PI))) as f32
                })
                .collect();
            let table = table(&values);
            for (index, found) in table.iter().enumerate() {
                let x = index as f64 / f64::from(PHASES - 1);
                let right = henyey_greenstein(g, 1.0 - 2.0 * x * x);
                // A step of the table is 0.004 of x: its curvature changes the integral by (0.004)² / 12 of the peak's, over its width 0.1.
                assert!(
                    (f64::from(*found) / right - 1.0).abs() < 2e-3,
                    "g = {g}, x = {x}: {found}, and {right} is right"
                );
            }
        }
    }

    #[test]
    fn the_mean_cosine_of_a_known_function_is_known() {
        for g in [-0.5, 0.0, 0.8] {
            let angle = |step: u16| f64::from(step) / 3600.0 * std::f64::consts::PI;
            let values: Vec<f32> = (0..=3600).map(|step| henyey_greenstein(g, libm::cos(angle(step))) as f32).collect();
            // The table's steps leave 10⁻³ of a peak as narrow as 0.1 in x.
            assert!((mean_cosine(&table(&values)) - g).abs() < 2e-3, "{g}: {}", mean_cosine(&table(&values)));
        }
    }

    #[test]
    fn two_values_make_a_function_of_integral_one() {
        let table = table(&[3.0, 3.0]);
        assert!(table.iter().all(|value| (value - 1.0).abs() < 1e-6), "{table:?}");
    }
}
