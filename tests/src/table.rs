//! Measurements as a table for people, and as JSON for machines.

use serde_json::{Value, json};
use vitrum_compare::{Bound, Comparison, Verdict};

/// One comparison of the conformance run.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// The tier, such as `T2`.
    pub tier: &'static str,
    /// The scene.
    pub scene: String,
    /// The method that rendered it.
    pub method: String,
    /// The kernel or the output that was compared.
    pub item: String,
    /// The component of a record that has the first difference.
    pub component: Option<&'static str>,
    /// What was measured.
    pub comparison: Comparison,
    /// The bound of the differences.
    pub bound: Bound,
    /// The counterpart of the comparison, such as an adapter; empty if it is the obvious one.
    pub against: String,
}

impl Row {
    /// The names of [`Self::cells`].
    #[rustfmt::skip]
    pub const HEADER: [&str; 11] = [
        "tier", "scene", "method", "item", "max", "RMSE", "FLIP", "ULP: count", "max ULP", "bound", "verdict",
    ];

    /// Whether the bound holds.
    pub fn verdict(&self) -> Verdict {
        self.bound.check(&self.comparison)
    }

    /// The row for people.
    #[must_use]
    pub fn cells(&self) -> [String; 11] {
        let Comparison { max_abs, rmse, mean_flip, ulps, .. } = &self.comparison;
        [
            self.tier.to_owned(),
            self.scene.clone(),
            self.method.clone(),
            self.component.map_or(self.item.clone(), |component| format!("{}: {component}", self.item)),
            number(*max_abs),
            number(*rmse),
            mean_flip.map_or("–".to_owned(), number),
            ulps.to_string(),
            ulps.max.to_string(),
            // The table of families spells it out.
            if let Bound::Tolerance(_) = self.bound { "tolerance".to_owned() } else { self.bound.to_string() },
            self.verdict().to_string(),
        ]
    }

    /// The numbers as JSON; infinite and unmeasured values are null.
    #[must_use]
    pub fn json(&self) -> Value {
        let Comparison { max_abs, rmse, psnr, peak, mean_flip, ulps, .. } = &self.comparison;
        let buckets: Vec<Value> = ulps
            .buckets()
            .map(|(range, count)| json!({ "from": range.start(), "to": range.end(), "count": count }))
            .collect();
        json!({
            "tier": self.tier,
            "scene": self.scene,
            "method": self.method,
            "item": self.item,
            "component": self.component,
            "against": self.against,
            "max_abs": max_abs,
            "rmse": rmse,
            "psnr": psnr,
            "peak": peak,
            "mean_flip": mean_flip,
            "worst_pixel": self.comparison.worst_pixel(),
            "max_ulp": ulps.max,
            "nan_values": ulps.undefined,
            "first_difference": ulps.first_difference,
            "ulp_histogram": buckets,
            "bound": self.bound.to_string(),
            "passed": self.verdict().passed(),
            "verdict": self.verdict().to_string(),
        })
    }
}

/// The rows as a Markdown table.
#[must_use]
pub fn markdown(rows: &[Row]) -> String {
    aligned(Row::HEADER.map(str::to_owned), rows.iter().map(Row::cells))
}

/// A Markdown table, padded so that it also reads well in a terminal.
#[must_use]
pub fn aligned<const COLUMNS: usize>(
    header: [String; COLUMNS],
    rows: impl IntoIterator<Item = [String; COLUMNS]>,
) -> String {
    let mut lines = vec![header];
    lines.extend(rows);
    let width = |column: usize| lines.iter().map(|line| line[column].chars().count()).max().unwrap_or(0);
    let widths: [usize; COLUMNS] = std::array::from_fn(width);
    let line = |cells: &[String; COLUMNS]| {
        let cells = cells.iter().zip(widths).map(|(cell, width)| format!("{cell:<width$}"));
        format!("| {} |", cells.collect::<Vec<_>>().join(" | "))
    };
    let rule = widths.map(|width| "-".repeat(width));
    let mut text: Vec<String> = lines.iter().map(line).collect();
    text.insert(1, line(&rule));
    text.join("\n")
}

fn number(value: f64) -> String {
    if value == 0.0 { "0".to_owned() } else { format!("{value:.2e}") }
}

#[cfg(test)]
mod tests {
    use super::*;
    use vitrum_compare::compare_buffers;

    fn row(other: f32) -> Row {
        Row {
            tier: "T2",
            scene: "ball".to_owned(),
            method: "sweep".to_owned(),
            item: "depth".to_owned(),
            component: None,
            comparison: compare_buffers(&[1.0, 2.0], &[1.0, other]).unwrap(),
            bound: Bound::BitEqual,
            against: String::new(),
        }
    }

    #[test]
    fn a_breach_is_in_the_table() {
        let table = markdown(&[row(2.0), row(2.5)]);
        let lines: Vec<&str> = table.lines().collect();
        assert_eq!(lines.len(), 4);
        assert!(lines.iter().all(|line| line.chars().count() == lines[0].chars().count()), "{table}");
        assert!(lines[2].contains("| 0 ") && lines[2].contains("| 0       | bit-equal | pass"), "{table}");
        assert!(lines[3].contains("5.00e-1") && lines[3].contains("ULP 2097152 exceeds 0"), "{table}");
    }

    #[test]
    fn json_says_null_for_what_is_unknown() {
        let json = row(f32::NAN).json();
        assert_eq!((&json["max_abs"], &json["mean_flip"]), (&Value::Null, &Value::Null));
        assert_eq!((&json["passed"], &json["nan_values"]), (&json!(false), &json!(1)));
        assert_eq!(row(2.0).json()["passed"], json!(true));
    }
}
