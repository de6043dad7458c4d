//! The little Python that `.npy` headers are written in.

/// Largest number of entries of a dictionary or a tuple; real ones have 3.
const MOST_ENTRIES: usize = 64;

/// A value in the dictionary.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Literal {
    Text(String),
    Bool(bool),
    /// Whole numbers from 0.
    Tuple(Vec<u64>),
    /// The list that describes a record, unread.
    List,
}

/// The entries of `{'key': value, ...}`; `None` where it is not one, or one is given twice.
pub(super) fn dictionary(text: &str) -> Option<Vec<(String, Literal)>> {
    let mut rest = text.trim().strip_prefix('{')?.strip_suffix('}')?.trim();
    let mut entries: Vec<(String, Literal)> = Vec::new();
    while !rest.is_empty() {
        let (key, after) = quoted(rest)?;
        let (value, after) = value(after.trim_start().strip_prefix(':')?.trim_start())?;
        if entries.iter().any(|(name, _)| name == key) || entries.len() == MOST_ENTRIES {
            return None;
        }
        entries.push((key.to_owned(), value));
        rest = separated(after)?;
    }
    Some(entries)
}

/// The text behind a comma, or an empty one at the end; `None` if another character follows.
fn separated(rest: &str) -> Option<&str> {
    let rest = rest.trim_start();
    if rest.is_empty() { Some(rest) } else { Some(rest.strip_prefix(',')?.trim_start()) }
}

/// A value, and the text behind it.
fn value(text: &str) -> Option<(Literal, &str)> {
    if let Some(rest) = text.strip_prefix("True") {
        return Some((Literal::Bool(true), rest));
    }
    if let Some(rest) = text.strip_prefix("False") {
        return Some((Literal::Bool(false), rest));
    }
    match text.chars().next()? {
        '(' => tuple(text),
        '[' => list(text),
        _ => quoted(text).map(|(text, rest)| (Literal::Text(text.to_owned()), rest)),
    }
}

/// A text in either kind of quotes; none of those that matter has an escape in it.
fn quoted(text: &str) -> Option<(&str, &str)> {
    let quote = text.chars().next().filter(|quote| matches!(quote, '\'' | '"'))?;
    text[1..].split_once(quote)
}

fn tuple(text: &str) -> Option<(Literal, &str)> {
    let (inside, rest) = text.strip_prefix('(')?.split_once(')')?;
    let mut numbers = Vec::new();
    let mut left = inside.trim();
    while !left.is_empty() {
        let end = left.find(',').unwrap_or(left.len());
        let (number, after) = left.split_at(end);
        // Python 2 wrote long integers with an L behind them.
        numbers.push(number.trim().trim_end_matches('L').parse().ok()?);
        if numbers.len() > MOST_ENTRIES {
            return None;
        }
        left = separated(after)?;
    }
    Some((Literal::Tuple(numbers), rest))
}

/// A list to its closing bracket, over lists and texts inside.
fn list(text: &str) -> Option<(Literal, &str)> {
    let (mut depth, mut quote) = (0_u32, None);
    for (at, character) in text.char_indices() {
        match (quote, character) {
            (Some(open), _) if open == character => quote = None,
            (Some(_), _) => {}
            (None, '\'' | '"') => quote = Some(character),
            (None, '[') => depth += 1,
            (None, ']') => depth -= 1,
            (None, _) => {}
        }
        if depth == 0 {
            return Some((Literal::List, &text[at + 1..]));
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_numpy_writes_is_read() {
        let text = "{'descr': '<f4', 'fortran_order': False, 'shape': (4, 3L, 2), }            \n";
        let entries = dictionary(text).unwrap();
        let named = |key: &str| entries.iter().find(|(name, _)| name == key).map(|(_, value)| value.clone());
        assert_eq!(named("descr"), Some(Literal::Text("<f4".to_owned())));
        assert_eq!(named("fortran_order"), Some(Literal::Bool(false)));
        assert_eq!(named("shape"), Some(Literal::Tuple(vec![4, 3, 2])));
        assert_eq!(dictionary("{\"shape\":(7,)}").unwrap()[0].1, Literal::Tuple(vec![7]));
        assert_eq!(dictionary("{'shape': ()}").unwrap()[0].1, Literal::Tuple(vec![]));
        assert_eq!(dictionary("{'a': [('x]', '<f4', (2,)), ['y']], 'b': True}").unwrap()[0].1, Literal::List);
    }

    #[test]
    fn anything_else_is_none() {
        for text in [
            "",
            "{",
            "}",
            "{}}",
            "{'a'}",
            "{'a':}",
            "{'a': 1}",
            "{'a': True 'b': True}",
            "{'a': (1 2)}",
            "{'a': (-1)}",
            "{'a': (1,,2)}",
            "{'a': [}",
            "{'a': 'b}",
            "{'a': True, 'a': True}",
            "{'a': (99999999999999999999,)}",
            "{µ",
        ] {
            assert_eq!(dictionary(text), None, "{text}");
        }
    }
}
