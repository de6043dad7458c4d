//! Reading scenes from TOML.

use super::check::check_table;
use super::error::{Fault, Origin, Problem, SceneError};
use super::lines::{line_of, line_of_key};
use super::schema::Shape;
use super::{Scene, colors};
use toml::Table;

impl Scene {
    /// Reads a scene from the text of a scene file; `name` is the file's name for messages.
    ///
    /// Keys that are left out take their defaults. The scene that comes back has passed [`Scene::validate`].
    ///
    /// # Errors
    ///
    /// Where the text is not TOML, has a key that scenes do not have, or a value that is of the wrong type, out of
    /// range, not finite, or in contradiction to another. The error names the line.
    pub fn from_toml(text: &str, name: &str) -> Result<Self, SceneError> {
        let at_line = |line| Origin::File { name: name.to_owned(), line };
        let not_toml = |error: &toml::de::Error| SceneError {
            origin: at_line(error.span().map(|span| line_of(text, span.start))),
            key: String::new(),
            problem: Box::new(Problem::Syntax(error.message().to_owned())),
        };
        let located = |fault: Fault| {
            let line = line_of_key(text, &fault.path);
            fault.from(at_line(line))
        };
        let table: Table = toml::from_str(text).map_err(|error| not_toml(&error))?;
        let scene = Self::from_table(table).map_err(located)?;
        scene.check_consistency().map_err(located)?;
        Ok(scene)
    }

    /// The scene in a tree of values, each checked for itself.
    pub(super) fn from_table(mut table: Table) -> Result<Self, Fault> {
        colors::resolve_table(Shape::scene(), &mut table);
        check_table(Shape::scene(), &table, &mut Vec::new())?;
        // The types take every value that the schema lets pass: this error is unreachable, and kept for its message.
        table.try_into().map_err(|error: toml::de::Error| Fault::at(&[], Problem::Syntax(error.message().to_owned())))
    }

    /// The scene as a tree of values.
    pub(super) fn to_table(&self) -> Result<Table, Fault> {
        Table::try_from(self)
            .map_err(|error| Fault::contradiction("", error.to_string(), "use file names that are valid Unicode"))
    }
}
