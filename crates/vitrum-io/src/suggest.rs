//! The known name that someone most likely meant.

/// The name in `known` that `given` most likely stands for: one that it abbreviates, or the nearest in edits.
///
/// `None` where every known name is further away than a third of the longer one's letters.
pub fn nearest<'a>(given: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    const SHORTEST_ABBREVIATION: usize = 3;
    let given = given.to_lowercase();
    let known: Vec<&str> = known.into_iter().collect();
    if given.len() >= SHORTEST_ABBREVIATION
        && let Some(name) = known.iter().find(|name| name.starts_with(&given))
    {
        return Some(name);
    }
    let distance = |name: &&str| strsim::osa_distance(&given, name);
    let name = known.into_iter().min_by_key(distance)?;
    let longer = given.chars().count().max(name.chars().count());
    (distance(&name) * 3 <= longer).then_some(name)
}

#[cfg(test)]
mod tests {
    use super::nearest;

    const KNOWN: [&str; 4] = ["color", "intensity", "softness", "elevation"];

    #[test]
    fn a_slip_finds_its_name() {
        assert_eq!(nearest("softnes", KNOWN), Some("softness"));
        assert_eq!(nearest("colour", KNOWN), Some("color"));
        assert_eq!(nearest("Intesnity", KNOWN), Some("intensity"));
    }

    #[test]
    fn an_abbreviation_finds_its_name() {
        assert_eq!(nearest("elev", KNOWN), Some("elevation"));
        assert_eq!(nearest("el", KNOWN), None);
    }

    #[test]
    fn something_else_finds_nothing() {
        assert_eq!(nearest("wavelength", KNOWN), None);
        assert_eq!(nearest("", KNOWN), None);
        assert_eq!(nearest("x", []), None);
    }
}
