//! Numbers as people read them.

/// A number with so many significant digits as its precision says, those behind them cut off.
pub struct Digits(pub f64);

impl std::fmt::Display for Digits {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let digits = f.precision().unwrap_or(6);
        // By way of the shortest form, so that neither zeros nor noise follow.
        match format!("{:.*e}", digits - 1, self.0).parse::<f64>() {
            Ok(rounded) if (1e-4..1e15).contains(&rounded.abs()) || rounded == 0.0 => write!(f, "{rounded}"),
            Ok(rounded) => write!(f, "{rounded:e}"),
            Err(_) => write!(f, "{}", self.0),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Digits;

    #[test]
    fn numbers_have_six_digits() {
        for (number, expected) in [(1234567.8, "1234570"), (0.1 + 0.2, "0.3"), (-1.5e-9, "-1.5e-9"), (0.0, "0")] {
            assert_eq!(format!("{:.6}", Digits(number)), expected);
        }
    }
}
