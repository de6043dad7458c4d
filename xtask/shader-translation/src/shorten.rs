//! WGSL in fewer characters, for what reads it and not for people.
//!
//! Numbers are shortened for another reason, too: naga writes all digits of a large or small number, and Safari refuses literals that
//! are long.

/// The text without indentation, each number of type `f32` in the shorter of its notations. The numbers' values stay the same.
pub fn shorten(text: &str) -> String {
    let mut shortened = String::with_capacity(text.len());
    for line in text.lines().map(str::trim).filter(|line| !line.is_empty()) {
        shorten_numbers(line, &mut shortened);
        shortened.push('\n');
    }
    shortened
}

/// Appends a line with short numbers.
fn shorten_numbers(line: &str, to: &mut String) {
    let of_number = |character: char| character.is_ascii_digit() || character == '.';
    let of_word = |character: char| character.is_ascii_alphanumeric() || character == '_';
    let mut rest = line;
    while let Some(start) = rest.find(|character: char| of_word(character)) {
        let (before, word) = rest.split_at(start);
        to.push_str(before);
        // A word is an identifier, or a number with its point.
        let is_number = word.starts_with(|character: char| character.is_ascii_digit());
        let end = word.find(|character| !(of_word(character) || is_number && of_number(character)));
        let (word, after) = word.split_at(end.unwrap_or(word.len()));
        match word.strip_suffix('f').filter(|_| is_number).and_then(|digits| digits.parse::<f32>().ok()) {
            Some(value) => to.push_str(&number(value)),
            None => to.push_str(word),
        }
        rest = after;
    }
    to.push_str(rest);
}

/// A number of type `f32` in the shorter of its notations.
fn number(value: f32) -> String {
    let (decimal, scientific) = (format!("{value}f"), format!("{value:e}f"));
    if scientific.len() < decimal.len() { scientific } else { decimal }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn indentation_and_digits_go() {
        let text = "fn main() {\n    let a = 340282350000000000000000000000000000000f;\n\n    a_1f = -0.000001f * 1.5f + x.y1;\n}\n";
        assert_eq!(shorten(text), "fn main() {\nlet a = 3.4028235e38f;\na_1f = -1e-6f * 1.5f + x.y1;\n}\n");
    }

    #[test]
    fn what_is_no_float_stays() {
        let text = "let b = 1000000u + array<u32, 16>(7i, 0xffu) + vec3<f32>(v.x12, 2147483647i);\n";
        assert_eq!(shorten(text), text);
    }

    #[test]
    fn values_stay_the_same() {
        for value in [f32::MIN_POSITIVE, 1e-20, 0.1, 16_777_216.0, 1.267_650_6e30, f32::MAX] {
            let text = number(value);
            assert_eq!(text.trim_end_matches('f').parse::<f32>().unwrap().to_bits(), value.to_bits(), "{text}");
        }
    }
}
