//! A share of an animation's pictures, for work on several machines.

use std::str::FromStr;

/// Every `count`-th picture from the `index`-th: neighbours cost alike, and each share has some of all.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Part {
    index: u32,
    count: u32,
}

impl Default for Part {
    /// All pictures.
    fn default() -> Self {
        Self { index: 0, count: 1 }
    }
}

impl Part {
    /// Whether the share has a picture.
    pub fn has(self, picture: u32) -> bool {
        picture % self.count == self.index
    }
}

impl FromStr for Part {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let number = |text: &str| text.parse().ok();
        let part = text.split_once('/').and_then(|(index, count)| Some((number(index)?, number(count)?)));
        match part {
            Some((index, count)) if index < count => Ok(Self { index, count }),
            Some((_, count @ 1..)) => {
                Err(format!("of {count} parts the first is 0/{count}, and the last {}/{count}", count - 1))
            }
            _ => Err("expected I/N, such as 0/4, the first of four parts".to_owned()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Part;

    #[test]
    fn parts_share_out_all_pictures() {
        let parts = ["0/3", "1/3", "2/3"].map(|text| text.parse::<Part>().expect("a part"));
        for picture in 0..10 {
            assert_eq!(parts.iter().filter(|part| part.has(picture)).count(), 1, "{picture}");
        }
        assert!(parts[2].has(2) && parts[2].has(5) && Part::default().has(7));
    }

    #[test]
    fn texts_that_are_no_part_are_refused() {
        for (text, expected) in
            [("3/3", "the last 2/3"), ("0/0", "such as 0/4"), ("1", "such as 0/4"), ("-1/2", "such as 0/4")]
        {
            let refused = text.parse::<Part>().expect_err(text);
            assert!(refused.contains(expected), "{refused}");
        }
    }
}
