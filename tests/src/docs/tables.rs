//! Tables of names that the code has lists of: outputs, presets, built-in scenes; and of bounds.
//!
//! A page marks the place of a table by the lines `<!-- table of outputs -->`, say, and `<!-- end -->`.

use vitrum::{builtin, method, preset};

use super::sections;
use crate::bounds::{self, FAMILIES};
use crate::closed_forms::table::{HEADER, cells};

/// A table's name, and its Markdown.
type Table = (&'static str, fn() -> String);

const TABLES: [Table; 6] = [
    ("outputs", outputs),
    ("presets", presets),
    ("media", media),
    ("built-in scenes", scenes),
    ("closed forms", || table(HEADER, cells())),
    ("families", || bounds::markdown(&FAMILIES)),
];

/// The page with its tables made anew.
pub(super) fn filled(page: &str) -> Result<String, String> {
    sections::filled(page, "table", |name| {
        let (_, table) = TABLES.iter().find(|(known, _)| *known == name).ok_or_else(|| {
            format!("there is no table of `{name}`, but of {}", TABLES.map(|(name, _)| name).join(", "))
        })?;
        Ok(table() + "\n")
    })
}

/// The named outputs of each method.
fn outputs() -> String {
    let row = |(method, output): (&dyn method::Method, &vitrum::Output)| {
        [code(output.name), code(method.name().as_str()), output.description.to_owned()]
    };
    table(["output", "method", "value"], method::outputs().map(row))
}

fn presets() -> String {
    let rows = |kind: &'static str, names: &'static [(&'static str, &'static str)]| {
        names
            .iter()
            .map(move |&(name, look)| [code(name), kind.to_owned(), look.trim_start_matches("of a mesh: ").to_owned()])
    };
    table(["preset", "of", "look"], rows("volumes", preset::names()).chain(rows("meshes", preset::mesh_names())))
}

fn media() -> String {
    let row = |&(name, look): &(&str, &str)| [code(name), look.trim_start_matches("a medium: ").to_owned()];
    table(["medium", "look"], preset::medium_names().iter().map(row))
}

fn scenes() -> String {
    let row = |&(name, description): &(&str, &str)| {
        let method = builtin::scene(name).map_or("", |scene| scene.method.as_str());
        [code(name), code(method), description.to_owned()]
    };
    table(["scene", "method", "shows"], builtin::names().iter().map(row))
}

fn code(name: &str) -> String {
    format!("`{name}`")
}

fn table<const COLUMNS: usize>(header: [&str; COLUMNS], rows: impl Iterator<Item = [String; COLUMNS]>) -> String {
    let line = |cells: &[String]| {
        format!("| {} |", cells.iter().map(|cell| cell.replace('|', "\\|")).collect::<Vec<_>>().join(" | "))
    };
    let mut lines = vec![line(&header.map(str::to_owned)), format!("|{}", "---|".repeat(COLUMNS))];
    lines.extend(rows.map(|row| line(&row)));
    lines.join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_table_has_a_row_for_each_name() {
        let rows = |text: &str| text.lines().count() - 2;
        assert_eq!(rows(&outputs()), method::outputs().count());
        assert_eq!(rows(&presets()), preset::names().len() + preset::mesh_names().len());
        assert_eq!(rows(&media()), preset::medium_names().len());
        assert_eq!(rows(&scenes()), builtin::names().len());
        assert!(outputs().contains("| `bounces` | `voxels` | surfaces at which"), "{}", outputs());
    }

    #[test]
    fn a_table_that_there_is_not_is_refused() {
        let problem = filled("<!-- table of output -->\n<!-- end -->\n").unwrap_err();
        assert!(problem.contains("`output`") && problem.contains("outputs, presets"), "{problem}");
    }
}
