//! The keys of a scene as a form: what an editor needs to show each, and to keep its values in their range.

use super::describe_keys;
use super::schema::{Kind, Shape};
use std::collections::BTreeMap;
use std::sync::LazyLock;

/// A key of the scene, or of one of its sections.
#[derive(Debug, Clone, PartialEq)]
pub struct Field {
    /// Name of the key in its section.
    pub name: String,
    /// What the value is, and with it how it is edited.
    pub control: Control,
    /// Whether the key can be left out for good, as `ground` can.
    pub is_optional: bool,
    /// Whether the key has no default and must be given.
    pub is_required: bool,
    /// The default as TOML; `None` where the key is left out by default, or has no short one.
    pub default: Option<String>,
    /// Unit of the value; empty where it has none.
    pub unit: String,
    /// Valid values, in words; empty for sections.
    pub range: String,
    /// Meaning of the key.
    pub meaning: String,
}

/// The kind of value that a key has.
#[derive(Debug, Clone, PartialEq)]
pub enum Control {
    /// A section: keys with values of their own.
    Section(Vec<Field>),
    /// A list of sections, such as lights.
    Sections {
        /// The keys of each.
        item: Vec<Field>,
        /// The greatest number of them.
        most: usize,
    },
    /// A number.
    Number(Bounds),
    /// A list of numbers, such as a direction.
    Numbers {
        /// The bounds of each.
        each: Bounds,
        /// The number of numbers; `None` where any number will do.
        count: Option<usize>,
    },
    /// A colour in linear RGB, with the bounds of each component.
    Color(Bounds),
    /// True or false.
    Switch,
    /// One of several words, each with its meaning.
    Choice(Vec<(String, String)>),
    /// A text.
    Text,
}

/// Bounds of a number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// The least value; minus infinity if there is none.
    pub least: f32,
    /// The greatest value; infinity if there is none.
    pub most: f32,
    /// Whether the value has to be above the least.
    pub above_least: bool,
    /// Whether the number is whole.
    pub whole: bool,
}

static FORM: LazyLock<Vec<Field>> = LazyLock::new(|| {
    let described = describe_keys().into_iter().map(|key| (key.path, (key.unit, key.range))).collect();
    fields(Shape::scene(), "", &described)
});

/// The keys of a scene, in the order in which `docs/scene.md` has them.
#[must_use]
pub fn form() -> &'static [Field] {
    &FORM
}

/// The field of a key by its dotted path, such as `light.0.azimuth`; any index of a list will do.
#[must_use]
pub fn field(path: &str) -> Option<&'static Field> {
    let mut fields: &'static [Field] = &FORM;
    let mut found = None;
    for segment in path.split('.') {
        if segment.parse::<usize>().is_ok() {
            continue;
        }
        let field: &'static Field = fields.iter().find(|field| field.name == segment)?;
        fields = match &field.control {
            Control::Section(inner) | Control::Sections { item: inner, .. } => inner,
            _ => &[],
        };
        found = Some(field);
    }
    found
}

/// Units and ranges of keys by path.
type Described = BTreeMap<String, (String, String)>;

fn fields(shape: Shape<'_>, path: &str, described: &Described) -> Vec<Field> {
    let required: Vec<&str> = shape.required().collect();
    let field = |name: &str| {
        let inner = shape.child(name)?;
        let path = if path.is_empty() { name.to_owned() } else { format!("{path}.{name}") };
        let (unit, range) = described.get(&path).cloned().unwrap_or_default();
        Some(Field {
            name: name.to_owned(),
            control: control(inner, &path, described),
            is_optional: inner.optional(),
            is_required: required.contains(&name),
            default: inner.default(),
            unit,
            range,
            meaning: inner.description(),
        })
    };
    shape.keys().into_iter().filter_map(field).collect()
}

fn control(shape: Shape<'_>, path: &str, described: &Described) -> Control {
    match shape.kind() {
        Kind::Table => Control::Section(fields(shape, path, described)),
        Kind::List { .. } if shape.is_color() => Control::Color(bounds(shape.item())),
        Kind::List { least, most } => match shape.item().kind() {
            Kind::Table => Control::Sections { item: fields(shape.item(), &format!("{path}.0"), described), most },
            _ => Control::Numbers { each: bounds(shape.item()), count: (least == most).then_some(most) },
        },
        Kind::Choice(_) => {
            let choices = shape.choices().into_iter();
            Control::Choice(choices.map(|(name, meaning)| (name.to_owned(), meaning.replace('\n', " "))).collect())
        }
        Kind::Number | Kind::WholeNumber => Control::Number(bounds(shape)),
        Kind::Switch => Control::Switch,
        Kind::Text => Control::Text,
    }
}

fn bounds(shape: Shape<'_>) -> Bounds {
    let (least, most, above_least) = shape.range();
    Bounds { least, most, above_least, whole: matches!(shape.kind(), Kind::WholeNumber) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn gather(fields: &[Field], path: &str, found: &mut Vec<String>) {
        for field in fields {
            let path = if path.is_empty() { field.name.clone() } else { format!("{path}.{}", field.name) };
            match &field.control {
                Control::Section(inner) => gather(inner, &path, found),
                Control::Sections { item, .. } => gather(item, &format!("{path}.0"), found),
                _ => found.push(path),
            }
        }
    }

    #[test]
    fn every_described_key_with_a_value_has_a_field() {
        let mut found = Vec::new();
        gather(form(), "", &mut found);
        for key in describe_keys() {
            let field = field(&key.path).expect(&key.path);
            assert!(!field.meaning.is_empty(), "{}", key.path);
            let is_list = matches!(field.control, Control::Sections { .. });
            assert!(is_list || found.contains(&key.path), "{}", key.path);
        }
    }

    #[test]
    fn controls_are_those_of_the_values() {
        let control = |path: &str| field(path).map(|field| &field.control).expect(path);
        let unit = Bounds { least: 0.0, most: 1.0, above_least: false, whole: false };
        assert_eq!(*control("transfer.opacity.0.opacity"), Control::Number(unit));
        assert_eq!(*control("transfer.color.3.color"), Control::Color(unit));
        assert_eq!(*control("light.0.shadows"), Control::Switch);
        assert!(
            matches!(control("camera.target"), Control::Numbers { count: Some(3), .. }),
            "{:?}",
            control("camera.target")
        );
        assert!(matches!(control("light"), Control::Sections { most: 16, .. }));
        assert!(matches!(control("light.0.kind"), Control::Choice(kinds) if kinds.len() == 3));
        assert!(matches!(control("volume.file"), Control::Text));
        assert!(field("light.0.position").is_some_and(|field| field.is_optional));
        assert!(field("isosurface.0.value").is_some_and(|field| field.is_required));
        assert!(matches!(control("film.width"), Control::Number(Bounds { whole: true, .. })));
        assert_eq!(field("light.0.azimut"), None);
    }
}
