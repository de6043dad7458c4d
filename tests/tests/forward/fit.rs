//! Smooth curves through measured points.

/// The least-squares polynomial of order five through (x, y), at each x.
pub fn fit(points: &[(f64, f64)]) -> Vec<f64> {
    const TERMS: usize = 6;
    let low = points.iter().map(|point| point.0).fold(f64::INFINITY, f64::min);
    let high = points.iter().map(|point| point.0).fold(f64::NEG_INFINITY, f64::max);
    // Chebyshev's polynomials keep the equations well conditioned.
    let terms = |x: f64| {
        let t = (2.0 * x - low - high) / (high - low);
        let mut terms = [1.0, t, 0.0, 0.0, 0.0, 0.0];
        for term in 2..TERMS {
            terms[term] = 2.0 * t * terms[term - 1] - terms[term - 2];
        }
        terms
    };
    let mut rows = [[0.0; TERMS + 1]; TERMS];
    for &(x, y) in points {
        let terms = terms(x);
        for (row, &term) in rows.iter_mut().zip(&terms) {
            for (entry, &other) in row.iter_mut().zip(&terms) {
                *entry += term * other;
            }
            row[TERMS] += term * y;
        }
    }
    for pivot in 0..TERMS {
        let top = rows[pivot].map(|entry| entry / rows[pivot][pivot]);
        for row in &mut rows {
            let factor = row[pivot];
            row.iter_mut().zip(&top).for_each(|(entry, above)| *entry -= factor * above);
        }
        rows[pivot] = top;
    }
    points.iter().map(|&(x, _)| terms(x).iter().zip(&rows).map(|(term, row)| term * row[TERMS]).sum()).collect()
}

#[test]
fn a_fit_of_order_five_leaves_such_a_polynomial_alone() {
    let points: Vec<_> =
        (0..40).map(|i| f64::from(i) * 0.03 - 0.2).map(|x| (x, 1.0 + x - 2.0 * x * x * x + x.powi(5))).collect();
    for (point, fitted) in points.iter().zip(fit(&points)) {
        assert!((point.1 - fitted).abs() < 1e-12, "{fitted} instead of {}", point.1);
    }
}
