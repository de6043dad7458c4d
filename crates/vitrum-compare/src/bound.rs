//! Bounds of the difference between two pictures or buffers.

use std::fmt;

use crate::comparison::Comparison;

/// A bound of the difference between two pictures or buffers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Bound {
    /// Every value has the same bits as its counterpart, and none is NaN.
    BitEqual,
    /// The largest distance of a value from its counterpart, in representable numbers (ULP); no value may be NaN.
    Ulp(u32),
    /// The largest distance of a value from its counterpart, in representable numbers (ULP, a power of two), for all but a share (0 to
    /// 1) of the values; no value may be NaN.
    MostlyUlp(u32, f64),
    /// Stated quantities stay below stated limits.
    Tolerance(Tolerance),
}

/// Limits on measured quantities. A quantity whose limit is `None` may have any value but NaN.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Tolerance {
    /// Whether `max_abs`, `rmse` and the threshold of `share_above` are in units of the reference's peak.
    pub relative_to_peak: bool,
    /// The largest difference.
    pub max_abs: Option<f64>,
    /// The root mean squared difference.
    pub rmse: Option<f64>,
    /// A threshold, and the share of pixels (0 to 1) that may be off by more.
    pub share_above: Option<(f64, f64)>,
    /// The mean ꟻLIP error.
    pub mean_flip: Option<f64>,
}

/// The quantities that a bound can limit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// The largest distance in representable numbers.
    Ulp,
    /// The share of values that are more representable numbers apart than allowed.
    UlpShare,
    /// The number of values that are NaN in either picture.
    Undefined,
    /// The largest difference.
    MaxAbs,
    /// The root mean squared difference.
    Rmse,
    /// The share of pixels beyond the threshold.
    Share,
    /// The mean ꟻLIP error.
    MeanFlip,
}

/// One limit that does not hold.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Breach {
    /// The limited quantity.
    pub quantity: Quantity,
    /// The measured value, or `None` if the comparison did not measure the quantity.
    pub measured: Option<f64>,
    /// The limit, in the unit of the measurement.
    pub limit: f64,
}

/// The outcome of a check.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub enum Verdict {
    /// Every limit holds.
    Pass,
    /// A comparison that breaches these limits.
    Fail(Vec<Breach>),
}

impl Verdict {
    /// Whether every limit holds.
    #[must_use]
    pub fn passed(&self) -> bool {
        matches!(self, Self::Pass)
    }
}

impl Bound {
    /// Holds a comparison against the bound.
    pub fn check(&self, comparison: &Comparison) -> Verdict {
        let undefined = (Quantity::Undefined, Some(comparison.ulps.undefined as f64), Some(0.0));
        let distance = |limit: u32| (Quantity::Ulp, Some(f64::from(comparison.ulps.max)), Some(f64::from(limit)));
        let limits = match *self {
            Self::BitEqual => vec![undefined, distance(0)],
            Self::Ulp(limit) => vec![undefined, distance(limit)],
            Self::MostlyUlp(distance, limit) => {
                let share = comparison.ulps.above(distance) as f64 / comparison.ulps.total() as f64;
                vec![undefined, (Quantity::UlpShare, Some(share), Some(limit))]
            }
            Self::Tolerance(tolerance) => {
                let unit = if tolerance.relative_to_peak { comparison.peak } else { 1.0 };
                let share = tolerance.share_above.map(|(threshold, _)| comparison.share_above(threshold * unit));
                vec![
                    undefined,
                    (Quantity::MaxAbs, Some(comparison.max_abs), tolerance.max_abs.map(|limit| limit * unit)),
                    (Quantity::Rmse, Some(comparison.rmse), tolerance.rmse.map(|limit| limit * unit)),
                    (Quantity::Share, share, tolerance.share_above.map(|(_, share)| share)),
                    (Quantity::MeanFlip, comparison.mean_flip, tolerance.mean_flip),
                ]
            }
        };
        let breaches: Vec<Breach> = limits
            .into_iter()
            .filter_map(|(quantity, measured, limit)| Some(Breach { quantity, measured, limit: limit? }))
            // Not `measured > limit`: a quantity that is missing or NaN is a breach.
            .filter(|breach| !breach.measured.is_some_and(|measured| measured <= breach.limit))
            .collect();
        if breaches.is_empty() { Verdict::Pass } else { Verdict::Fail(breaches) }
    }
}

/// Text such as `RMSE ≤ 1e-4 of the peak, mean FLIP ≤ 1e-3`.
impl fmt::Display for Bound {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::BitEqual => formatter.write_str("bit-equal"),
            Self::Ulp(limit) => write!(formatter, "≤ {limit} ULP"),
            Self::MostlyUlp(distance, share) => {
                write!(formatter, "≤ {distance} ULP but for {} %", share * 100.0)
            }
            Self::Tolerance(tolerance) => {
                let unit = if tolerance.relative_to_peak { " of the peak" } else { "" };
                let texts = [
                    tolerance.max_abs.map(|limit| format!("largest difference ≤ {limit:e}{unit}")),
                    tolerance.rmse.map(|limit| format!("RMSE ≤ {limit:e}{unit}")),
                    tolerance.share_above.map(|(threshold, share)| {
                        format!("at most {} % of pixels off by more than {threshold:e}{unit}", share * 100.0)
                    }),
                    tolerance.mean_flip.map(|limit| format!("mean FLIP ≤ {limit:e}")),
                ];
                formatter.write_str(&texts.into_iter().flatten().collect::<Vec<_>>().join(", "))
            }
        }
    }
}

impl fmt::Display for Quantity {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::Ulp => "largest distance in ULP",
            Self::UlpShare => "share of values beyond the distance in ULP",
            Self::Undefined => "number of NaN values",
            Self::MaxAbs => "largest difference",
            Self::Rmse => "RMSE",
            Self::Share => "share of pixels beyond the threshold",
            Self::MeanFlip => "mean FLIP",
        })
    }
}

/// Text such as `RMSE 3.2e-4 exceeds 1e-4`.
impl fmt::Display for Breach {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { quantity, measured, limit } = self;
        match (quantity, measured) {
            (_, None) => write!(formatter, "{quantity} is limited to {limit:e} but was not measured"),
            (Quantity::Ulp | Quantity::Undefined, Some(measured)) => {
                write!(formatter, "{quantity} {measured} exceeds {limit}")
            }
            (_, Some(measured)) => write!(formatter, "{quantity} {measured:.3e} exceeds {limit:e}"),
        }
    }
}

/// `pass`, or the breaches separated by semicolons.
impl fmt::Display for Verdict {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Pass => formatter.write_str("pass"),
            Self::Fail(breaches) => {
                let texts: Vec<String> = breaches.iter().map(ToString::to_string).collect();
                formatter.write_str(&texts.join("; "))
            }
        }
    }
}
