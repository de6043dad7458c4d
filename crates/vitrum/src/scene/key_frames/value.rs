//! Values of a scene as lists of numbers, and back.

use toml::Value;

/// The numbers in a value, and its form: the value's text without them. `None` for a value that contains anything but numbers.
pub fn numbers(value: &Value) -> Option<(Vec<f64>, String)> {
    let (mut numbers, mut form) = (Vec::new(), String::new());
    collect(value, &mut numbers, &mut form).then_some((numbers, form))
}

fn collect(value: &Value, numbers: &mut Vec<f64>, form: &mut String) -> bool {
    match value {
        Value::Float(number) => numbers.push(*number),
        Value::Integer(number) => numbers.push(*number as f64),
        Value::Array(items) => {
            form.push('[');
            let all = items.iter().all(|item| collect(item, numbers, form));
            form.push(']');
            return all;
        }
        Value::Table(members) => {
            for name in sorted(members) {
                form.push_str(name);
                if !collect(&members[name], numbers, form) {
                    return false;
                }
            }
            form.push(';');
            return true;
        }
        _ => return false,
    }
    form.push('n');
    true
}

/// A value of the form of another, with these numbers, as whole ones if they have to be.
pub fn filled(form: &Value, numbers: &mut impl Iterator<Item = f64>, whole: bool) -> Value {
    match form {
        Value::Array(items) => items.iter().map(|item| filled(item, numbers, whole)).collect::<Vec<_>>().into(),
        Value::Table(members) => {
            let fill = |name: &str| (name.to_owned(), filled(&members[name], numbers, whole));
            Value::Table(sorted(members).into_iter().map(fill).collect())
        }
        other => match numbers.next() {
            Some(number) if whole => Value::Integer(number.round() as i64),
            Some(number) => Value::Float(number),
            None => other.clone(),
        },
    }
}

/// The names in one order, however they were written.
fn sorted(members: &toml::Table) -> Vec<&str> {
    let mut names: Vec<_> = members.keys().map(String::as_str).collect();
    names.sort_unstable();
    names
}

#[cfg(test)]
mod tests {
    use super::{filled, numbers};
    use toml::Value;

    fn value(text: &str) -> Value {
        text.parse().expect("TOML")
    }

    #[test]
    fn values_come_apart_and_together() {
        for text in
            ["3.5", "[1.0, 2.0, 3.0]", "[{ color = [1.0, 0.5, 0.0], value = 7.0 }, { color = [], value = 1.0 }]"]
        {
            let (list, _) = numbers(&value(text)).expect("numbers alone");
            assert_eq!(filled(&value(text), &mut list.into_iter(), false), value(text));
        }
        assert_eq!(filled(&value("1"), &mut [2.6].into_iter(), true), value("3"));
    }

    #[test]
    fn forms_tell_lengths_and_names_apart_and_not_orders() {
        let form = |text: &str| numbers(&value(text)).map(|(_, form)| form);
        assert_eq!(form("{ a = 1, b = 2 }"), form("{ b = 3.0, a = 4 }"));
        assert_ne!(form("[1, 2]"), form("[1, 2, 3]"));
        assert_ne!(form("[[1], [2, 3]]"), form("[[1, 2], [3]]"));
        assert_eq!(form("[1, \"two\"]"), None);
        assert_eq!(form("true"), None);
    }
}
