//! GLB: chunks of JSON and of bytes in one file.

use crate::error::{Error, Place, Report};

pub(super) const MAGIC: &[u8] = b"glTF";

/// The parts of a file.
#[derive(Debug)]
pub(super) struct Container<'a> {
    pub json: &'a [u8],
    /// The chunk of bytes of a GLB file; empty where that has none.
    pub binary: Option<&'a [u8]>,
    /// Bytes behind the end that a GLB file states.
    surplus: usize,
}

impl<'a> Container<'a> {
    pub fn split(bytes: &'a [u8], report: Report) -> Result<Self, Error> {
        if !bytes.starts_with(MAGIC) {
            return Ok(Self { json: bytes, binary: None, surplus: 0 });
        }
        let version = word(bytes, 4).ok_or_else(|| truncated(report, bytes.len(), 12))?;
        if version != 2 {
            let problem = format!("GLB of version {version}, and only 2 is read");
            return Err(report.unsupported(Place::Byte(4), problem, "convert it to glTF 2.0"));
        }
        let length = word(bytes, 8).ok_or_else(|| truncated(report, bytes.len(), 12))? as usize;
        let Some(whole) = bytes.get(..length) else {
            return Err(truncated(report, bytes.len(), length));
        };
        let (mut json, mut binary) = (None, None);
        let mut position = 12;
        while position < length {
            let chunk = word(whole, position)
                .zip(word(whole, position + 4))
                .and_then(|(size, kind)| Some((kind, whole.get(position + 8..)?.get(..size as usize)?)));
            let Some((kind, content)) = chunk else {
                let problem = format!("a chunk that ends behind the file's {length} bytes");
                return Err(report.invalid(Place::Byte(position as u64), problem, "get the whole file"));
            };
            match &kind.to_le_bytes() {
                b"JSON" if json.is_none() => json = Some(content),
                b"BIN\0" if binary.is_none() => binary = Some(content),
                // Others are for extensions.
                _ => {}
            }
            position += 8 + content.len();
        }
        let Some(json) = json else {
            return Err(report.invalid(Place::Byte(12), "there is no chunk of JSON", "check that this is a GLB file"));
        };
        Ok(Self { json, binary: Some(binary.unwrap_or_default()), surplus: bytes.len() - length })
    }

    pub fn surplus_note(&self) -> Option<String> {
        let surplus = self.surplus;
        (surplus > 0).then(|| format!("{surplus} bytes behind the end that the header states were left unread"))
    }
}

fn word(bytes: &[u8], at: usize) -> Option<u32> {
    let bytes = bytes.get(at..at.checked_add(4)?)?;
    Some(u32::from_le_bytes(bytes.try_into().ok()?))
}

fn truncated(report: Report, there: usize, needed: usize) -> Error {
    let problem = format!("the header promises {needed} bytes, {there} are there");
    report.invalid(Place::Byte(8), problem, "get the whole file")
}
