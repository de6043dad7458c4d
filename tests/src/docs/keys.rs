//! Tables of scene keys, as the scene describes them.
//!
//! A page marks the place of the table of the keys in `light`, say, by the lines `<!-- keys of light -->` and `<!-- end -->`; keys of
//! the scene itself are those `of the scene`.

use vitrum::scene::{KeyDescription, describe_keys};

use super::sections;

const HEAD: &str = "| key | unit | range | default | meaning |\n|---|---|---|---|---|\n";

/// The page with its tables of keys made anew.
pub(super) fn filled(page: &str) -> Result<String, String> {
    sections::filled(page, "keys", |path| table(if path == "the scene" { "" } else { path }))
}

/// The table of the keys at a dotted path.
fn table(path: &str) -> Result<String, String> {
    let keys = describe_keys();
    let mut rows = keys.iter().filter(|key| key.table == path).peekable();
    if rows.peek().is_none() {
        return Err(format!("the scene has no table `{path}`"));
    }
    let row = |key: &KeyDescription| {
        let KeyDescription { name, unit, range, default, meaning, .. } = key;
        let row = format!("| `{name}` | {unit} | {range} | {default} | {} |\n", meaning.replace('|', "\\|"));
        row.replace("|  |", "| |").replace("|  |", "| |")
    };
    Ok(HEAD.to_owned() + &rows.map(row).collect::<String>())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_stand_between_their_marks_and_the_rest_stays() {
        let page = "before\n<!-- keys of ground -->\nold\n<!-- end -->\nafter\n";
        let text = filled(page).unwrap();
        assert!(
            text.starts_with(&format!("before\n<!-- keys of ground -->\n{HEAD}| `height` | world units | any | — |"))
        );
        assert!(text.ends_with("|\n<!-- end -->\nafter\n") && !text.contains("old"), "{text}");
        assert_eq!(filled(&text), Ok(text), "once more changes nothing");
    }

    #[test]
    fn marks_that_are_wrong_are_refused() {
        assert!(filled("<!-- keys of grond -->\n<!-- end -->\n").unwrap_err().contains("`grond`"));
        assert!(filled("<!-- keys of ground -->\n").unwrap_err().contains("<!-- end -->"));
    }

    #[test]
    fn rows_say_choices_ranges_and_defaults() {
        let text = table("light").unwrap();
        assert!(text.contains("| `kind` | | `distant`, `point`, `spot` | `distant` |"), "{text}");
        assert!(
            text.contains("| `color` | radiance | three numbers, each 0 to 1e6, or a colour | [1, 1, 1] |"),
            "{text}"
        );
        assert!(table("transfer.ior").unwrap().contains("| `ior` | | 0.2 to 5 | required |"));
        assert!(table("").unwrap().contains("| `method` |") && !table("").unwrap().contains("`clip`"));
    }
}
