//! Checks of a picture and its metadata, on which the encoders rely.

use super::options::Metadata;
use super::picture::Picture;
use crate::error::{Error, Report};

/// Encoders rely on this: at least one pixel, and each channel complete.
pub(super) fn check_picture(report: Report, picture: &Picture) -> Result<(), Error> {
    let Picture { width, height, ref layers } = *picture;
    let pixels = u64::from(width) * u64::from(height);
    let refuse = |problem: String| Err(report.write(problem, "this is the caller's mistake: report it", None));
    if pixels == 0 || layers.is_empty() {
        return refuse(format!("{width} x {height} pixels in {} layers", layers.len()));
    }
    for (index, layer) in layers.iter().enumerate() {
        let name = &layer.name;
        if layer.channels.is_empty() {
            return refuse(format!("layer `{name}` has no channels"));
        }
        if layers.iter().take(index).any(|other| other.name == *name) {
            return refuse(format!("two layers have the name `{name}`"));
        }
        for (index, channel) in layer.channels.iter().enumerate() {
            let (inner, count) = (&channel.name, channel.data.len());
            if layer.channels.iter().take(index).any(|other| other.name == *inner) {
                return refuse(format!("layer `{name}` has two channels of the name `{inner}`"));
            }
            if count as u64 != pixels {
                return refuse(format!(
                    "layer `{name}`, channel `{inner}` has {count} values for {width} x {height} \
                     pixels"
                ));
            }
            for text in [name, inner] {
                // A C string of at most 255 bytes is what OpenEXR's names are.
                if text.is_empty() || text.len() > 255 || text.contains('\0') {
                    return refuse(format!("`{}` is no layer or channel name", text.escape_debug()));
                }
            }
        }
    }
    Ok(())
}

/// Keys that every format takes: PNG's limits are the tightest.
pub(super) fn check_metadata(report: Report, metadata: &Metadata) -> Result<(), Error> {
    for (index, (key, value)) in metadata.iter().enumerate() {
        let characters = key.bytes().all(|byte| byte.is_ascii_graphic() || byte == b' ');
        let trimmed = key.trim() == key && (1..=79).contains(&key.len());
        let unique = metadata.iter().take(index).all(|(other, _)| other != key);
        if !(characters && trimmed && unique && !value.contains('\0')) {
            return Err(report.write(
                format!("the metadata `{}` cannot be kept", key.escape_debug()),
                "use keys of 1 to 79 printable ASCII characters, each once, and values without NUL",
                None,
            ));
        }
    }
    Ok(())
}
