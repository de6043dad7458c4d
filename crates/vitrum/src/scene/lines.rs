//! Finding the line of a scene file that a key stands on.

use toml::de::{DeTable, DeValue};

/// The line, counted from 1, that holds the byte at `offset`.
pub(super) fn line_of(text: &str, offset: usize) -> usize {
    1 + text.bytes().take(offset).filter(|&byte| byte == b'\n').count()
}

/// The line of the key at `path`, or of the innermost table or list around it that the text has.
pub(super) fn line_of_key(text: &str, path: &[String]) -> Option<usize> {
    let document = DeTable::parse(text).ok()?;
    let mut table = Some(document.get_ref());
    let mut list = None;
    let mut offset = None;
    for segment in path {
        let value: &DeValue<'_> = if let Some(items) = list {
            let items: &[_] = items;
            let Some(item) = segment.parse().ok().and_then(|index: usize| items.get(index)) else { break };
            offset = Some(toml::Spanned::span(item).start);
            item.get_ref()
        } else {
            let entry = table.and_then(|table| table.iter().find(|(key, _)| key.get_ref() == segment));
            let Some((key, value)) = entry else { break };
            offset = Some(key.span().start);
            value.get_ref()
        };
        table = value.as_table();
        list = value.as_array().map(|items| &**items);
    }
    offset.map(|offset| line_of(text, offset))
}

#[cfg(test)]
mod tests {
    use super::line_of_key;

    const TEXT: &str = "[camera]\nroll = 3\n\n[[clip]]\noffset = 1\n\n[[clip]]\nnormal = [\n  0,\n  1,\n  2,\n]\n";

    fn line(path: &str) -> Option<usize> {
        line_of_key(TEXT, &path.split('.').map(str::to_owned).collect::<Vec<_>>())
    }

    #[test]
    fn every_depth_has_its_line() {
        assert_eq!(line("camera"), Some(1));
        assert_eq!(line("camera.roll"), Some(2));
        assert_eq!(line("clip.0.offset"), Some(5));
        assert_eq!(line("clip.1.normal.2"), Some(11));
    }

    #[test]
    fn a_missing_key_has_the_line_of_what_is_around_it() {
        assert_eq!(line("camera.zoom"), Some(1));
        assert_eq!(line("film.width"), None);
    }
}
