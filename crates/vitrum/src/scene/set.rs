//! Changing one key of a scene, as `--set KEY=VALUE` does.

use super::check::{check_value, unknown_key};
use super::error::{Fault, Origin, Problem, SceneError};
use super::schema::{Kind, Shape};
use super::{Scene, colors};
use toml::{Table, Value};

impl Scene {
    /// Sets one key: `light.0.azimuth=30`, `camera.up=[0, 1, 0]`, `clip.0.offset=2.5`, `volume.builtin=ball`.
    ///
    /// The value is TOML; texts need no quotes. A number in the key is an index into a list, and the index behind the last item
    /// appends one. A new kind of a light takes the keys away that lights of that kind do not have. `none` removes an optional
    /// key: `ground=none`; a text of that name takes quotes.
    ///
    /// The value is checked against its own range. Whether it fits the rest of the scene is left to
    /// [`Scene::validate`], so that keys that depend on each other can be set one after the other.
    ///
    /// # Errors
    ///
    /// Where `assignment` is not `KEY=VALUE`, the key is unknown or an index is beyond its list, or where the value is
    /// of the wrong type, out of range or not finite. The scene is then unchanged.
    pub fn set(&mut self, assignment: &str) -> Result<(), SceneError> {
        let changed = self.with(assignment);
        *self = changed.map_err(|fault| fault.from(Origin::Setting(assignment.to_owned())))?;
        Ok(())
    }

    fn with(&self, assignment: &str) -> Result<Self, Fault> {
        let syntax = |problem: &str| Fault::at(&[], Problem::Syntax(problem.to_owned()));
        let (key, text) = assignment.split_once('=').ok_or_else(|| syntax("there is no `=`"))?;
        let mut path: Vec<String> = key.trim().split('.').map(|segment| segment.trim().to_owned()).collect();
        if path.iter().any(String::is_empty) {
            return Err(syntax("there is no key, or a part of it is empty"));
        }
        let shape = shape_of(&path)?;
        let mut table = self.to_table()?;
        match parse(shape, text.trim(), &path)? {
            Some(mut value) => {
                colors::resolve(shape, &mut value);
                check_value(shape, &value, &mut path)?;
                *entry(&mut table, &path)? = value;
            }
            None => remove(&mut table, &path),
        }
        let mut scene = Self::from_table(table)?;
        if let [list, index, key] = path.as_slice()
            && (list.as_str(), key.as_str()) == ("light", "kind")
            && let Some(light) = index.parse().ok().and_then(|index: usize| scene.light.get_mut(index))
        {
            light.forget_foreign_keys();
        }
        Ok(scene)
    }
}

/// Follows the path through the schema, where every valid key is, given or not.
fn shape_of(path: &[String]) -> Result<Shape<'static>, Fault> {
    let mut shape = Shape::scene();
    for (depth, segment) in path.iter().enumerate() {
        shape = shape.child(segment).ok_or_else(|| unknown_key(shape, &path[..depth], segment))?;
    }
    Ok(shape)
}

/// The value in `text`; `None` to remove the key.
fn parse(shape: Shape<'_>, text: &str, path: &[String]) -> Result<Option<Value>, Fault> {
    if text == "none" && shape.optional() {
        return Ok(None);
    }
    let quoted = text.starts_with(['"', '\'']);
    if matches!(shape.kind(), Kind::Text | Kind::Choice(_)) && !quoted {
        return Ok(Some(Value::String(text.to_owned())));
    }
    match text.parse::<Value>() {
        Ok(value) => Ok(Some(value)),
        // A bare word where another type is expected: the check says which.
        Err(_) if !quoted && !text.starts_with(['[', '{']) => Ok(Some(Value::String(text.to_owned()))),
        Err(error) => Err(Fault::at(path, Problem::Syntax(error.message().to_owned()))),
    }
}

/// The place of the key, made where it is not there yet.
pub(super) fn entry<'a>(table: &'a mut Table, path: &[String]) -> Result<&'a mut Value, Fault> {
    let (first, rest) =
        path.split_first().ok_or_else(|| Fault::at(path, Problem::Syntax("there is no key".to_owned())))?;
    let mut place = table.entry(first).or_insert_with(|| empty(Shape::scene().child(first)));
    let mut shape = Shape::scene().child(first);
    for (depth, segment) in rest.iter().enumerate() {
        shape = shape.and_then(|shape| shape.child(segment));
        let beyond = |length: usize| {
            let problem = format!("the list has {length} items, and indices count from 0");
            Fault::contradiction(&path[..=depth].join("."), problem, format!("use an index from 0 to {length}"))
        };
        place = match place {
            Value::Array(items) => {
                let length = items.len();
                let index =
                    segment.parse::<usize>().ok().filter(|&index| index <= length).ok_or_else(|| beyond(length))?;
                if index == length {
                    items.push(empty(shape));
                }
                items.get_mut(index).ok_or_else(|| beyond(length))?
            }
            Value::Table(members) => members.entry(segment).or_insert_with(|| empty(shape)),
            _ => return Err(Fault::at(path, Problem::Syntax("this key has no keys inside".to_owned()))),
        };
    }
    Ok(place)
}

/// A stand-in for a value that is about to be filled in.
fn empty(shape: Option<Shape<'_>>) -> Value {
    match shape.map(Shape::kind) {
        Some(Kind::List { .. }) => Value::Array(Vec::new()),
        _ => Value::Table(Table::new()),
    }
}

fn remove(table: &mut Table, path: &[String]) {
    if let [first] = path {
        table.remove(first);
    } else if let [first, middle @ .., last] = path {
        let inner = middle.iter().fold(table.get_mut(first), |value, segment| match value? {
            Value::Table(members) => members.get_mut(segment),
            Value::Array(items) => items.get_mut(segment.parse::<usize>().ok()?),
            _ => None,
        });
        if let Some(members) = inner.and_then(Value::as_table_mut) {
            members.remove(last);
        }
    }
}
