//! Volumes whose values are labels of parts, and no measurements.

/// A label, as far as a file names it.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Label {
    pub value: f64,
    pub name: String,
    /// Red, green and blue from 0 to 1.
    pub color: Option<[f64; 3]>,
}

/// The statement that values are labels, by whom.
pub(crate) fn note(labels: &[Label], by: &str) -> String {
    const SHOWN: usize = 12;
    let described = |label: &Label| {
        let name = if label.name.is_empty() { String::new() } else { format!(" `{}`", label.name) };
        let color = label.color.map(|[r, g, b]| format!(" ({r} {g} {b})")).unwrap_or_default();
        format!("{}{name}{color}", label.value)
    };
    let shown: Vec<String> = labels.iter().take(SHOWN).map(described).collect();
    let more = labels.len().saturating_sub(SHOWN);
    let more = if more > 0 { format!(" and {more} more") } else { String::new() };
    let listed = if shown.is_empty() { String::new() } else { format!(": {}{more}", shown.join(", ")) };
    format!(
        "the values are labels, by the {by}{listed}; they are interpolated between voxels as others are, so that rims of a label show the values between"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_are_told_with_names_and_colours() {
        let label = Label { value: 3.0, name: "liver".to_owned(), color: Some([0.5, 0.25, 1.0]) };
        let told = note(&[label, Label { value: 4.0, ..Label::default() }], "header");
        assert!(told.contains("labels, by the header: 3 `liver` (0.5 0.25 1), 4; they"), "{told}");
    }
}
