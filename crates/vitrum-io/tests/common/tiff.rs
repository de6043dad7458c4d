//! Small TIFF files of either byte order.

use std::collections::BTreeMap;

/// A tag's value.
#[derive(Clone)]
pub enum Value {
    Short(u16),
    Long(u32),
    Rational(u32, u32),
    Text(&'static str),
    Shorts(Vec<u16>),
}

use Value::{Long, Short};

/// A page of 3 x 2 samples.
#[derive(Clone)]
pub struct Page {
    tags: BTreeMap<u16, Value>,
    data: Vec<u8>,
}

impl Page {
    /// `format` is 1 for unsigned integers, 2 for signed ones, 3 for floats.
    pub fn new(bits: u16, format: u16, data: &[u8]) -> Self {
        let tags = [
            (256, Long(3)),
            (257, Long(2)),
            (258, Short(bits)),
            (259, Short(1)),
            (262, Short(1)),
            (277, Short(1)),
            (278, Long(2)),
            (279, Long(data.len() as u32)),
            (339, Short(format)),
        ];
        Self { tags: BTreeMap::from(tags), data: data.to_vec() }
    }

    /// A page of uint8.
    pub fn bytes(data: &[u8]) -> Self {
        Self::new(8, 1, data)
    }

    pub fn set(mut self, tag: u16, value: Value) -> Self {
        self.tags.insert(tag, value);
        self
    }

    pub fn without(mut self, tag: u16) -> Self {
        self.tags.remove(&tag);
        self
    }
}

pub fn tiff(big: bool, pages: &[Page]) -> Vec<u8> {
    let short = |value: u16| if big { value.to_be_bytes() } else { value.to_le_bytes() };
    let long = |value: u32| if big { value.to_be_bytes() } else { value.to_le_bytes() };
    let mut file = if big { b"MM\0*".to_vec() } else { b"II*\0".to_vec() };
    let mut link = file.len();
    file.extend([0; 4]);
    for page in pages {
        let mut tags = page.tags.clone();
        tags.entry(273).or_insert(Long(file.len() as u32));
        file.extend(&page.data);
        let mut entries = Vec::new();
        for (tag, value) in &tags {
            let (kind, count, bytes) = match value {
                Short(value) => (3, 1, short(*value).to_vec()),
                Long(value) => (4, 1, long(*value).to_vec()),
                Value::Rational(above, below) => (5, 1, [long(*above), long(*below)].concat()),
                Value::Shorts(values) => (3, values.len(), values.iter().flat_map(|value| short(*value)).collect()),
                Value::Text(text) => (2, text.len() + 1, [text.as_bytes(), &[0]].concat()),
            };
            let mut field = bytes.clone();
            if bytes.len() > 4 {
                field = long(file.len() as u32).to_vec();
                file.extend(bytes);
            }
            field.resize(4, 0);
            entries.extend([&short(*tag)[..], &short(kind), &long(count as u32), &field].concat());
        }
        let start = long(file.len() as u32);
        file[link..link + 4].copy_from_slice(&start);
        file.extend(short(tags.len() as u16));
        file.extend(entries);
        link = file.len();
        file.extend([0; 4]);
    }
    file
}

/// Two uint8 pages, the second after a change.
pub fn stack_u8(change: impl FnOnce(Page) -> Page) -> Vec<u8> {
    tiff(false, &[Page::bytes(&[1, 2, 3, 4, 5, 6]), change(Page::bytes(&[7, 8, 9, 10, 11, 12]))])
}
