//! Sections of a page that are made from the code: they stand between a line such as `<!-- table of outputs -->` and the line `<!-- end -->`.

const END: &str = "<!-- end -->";

/// The page with the text of its sections `KIND of NAME` made anew; `text` gives that of a name, with a newline at its end.
pub(super) fn filled(page: &str, kind: &str, text: impl Fn(&str) -> Result<String, String>) -> Result<String, String> {
    let begin = format!("<!-- {kind} of ");
    let mut filled = String::new();
    let mut lines = page.lines();
    while let Some(line) = lines.next() {
        filled += line;
        filled.push('\n');
        let Some(name) = line.strip_prefix(&begin).and_then(|rest| rest.strip_suffix(" -->")) else { continue };
        filled += &text(name)?;
        if !lines.any(|line| line == END) {
            return Err(format!("no line `{END}` follows the line `{line}`"));
        }
        filled += END;
        filled.push('\n');
    }
    Ok(filled)
}
