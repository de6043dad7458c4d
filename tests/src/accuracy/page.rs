//! Sections of a page that a program writes.

/// The page with the text between `<!-- measured: NAME -->` and the next `<!-- end -->` replaced; nothing if it has no such section.
#[must_use]
pub fn replace(page: &str, name: &str, text: &str) -> Option<String> {
    let begin = format!("<!-- measured: {name} -->\n");
    let (before, rest) = page.split_once(&begin)?;
    let (_, after) = rest.split_once("<!-- end -->")?;
    Some(format!("{before}{begin}{text}\n<!-- end -->{after}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_section_is_replaced() {
        let page = "a\n<!-- measured: one -->\nold\n<!-- end -->\nb\n<!-- measured: two -->\nkept\n<!-- end -->\n";
        let new = replace(page, "one", "new").unwrap();
        assert_eq!(new, page.replace("old", "new"));
        assert_eq!(replace(&new, "one", "new").unwrap(), new);
        assert_eq!(replace(page, "three", "new"), None);
    }
}
