//! OME-XML: what a microscope's file says of its pages, in the description of the first.
//!
//! The format: <https://docs.openmicroscopy.org/ome-model/6.3.1/ome-tiff/specification.html>.

use quick_xml::Reader;
use quick_xml::XmlVersion;
use quick_xml::events::{BytesStart, Event};

use crate::placement::millimetres;

/// More channels than this are a mistake.
const MOST_CHANNELS: usize = 10_000;

/// The first image of a document.
#[derive(Debug, Default, Clone, PartialEq)]
pub(super) struct Ome {
    /// Counts of channels, slices and points in time, each at least 1.
    pub channels: u64,
    pub slices: u64,
    pub frames: u64,
    /// The letters of the axes, that of the rows first, then those that change from page to page, the fastest first.
    pub order: String,
    /// Distances along x, y and z, in millimetres.
    pub spacing: [Option<f64>; 3],
    /// A unit that is not known.
    pub unknown_unit: Option<String>,
    /// Names of the channels; empty where one has none.
    pub names: Vec<String>,
    /// Count of the images.
    pub images: u64,
}

impl Ome {
    /// The image that a description describes; `None` where it is no OME-XML.
    pub fn read(text: &str) -> Option<Self> {
        if !text.contains("<OME") && !text.contains(":OME") {
            return None;
        }
        let mut reader = Reader::from_str(text);
        let mut found: Option<Self> = None;
        let mut inside = false;
        loop {
            // What is damaged behind the image does no harm to it.
            match reader.read_event() {
                Ok(Event::Start(tag)) => inside |= Self::take(&mut found, &tag, inside),
                Ok(Event::Empty(tag)) => drop(Self::take(&mut found, &tag, inside)),
                Ok(Event::End(tag)) if is_local(tag.name().as_ref(), "Pixels") => inside = false,
                Ok(Event::Eof) | Err(_) => return found,
                Ok(_) => {}
            }
        }
    }

    /// Takes in an element; whether it is one of pixels.
    fn take(found: &mut Option<Self>, tag: &BytesStart, inside: bool) -> bool {
        let name = tag.name();
        let name = name.as_ref();
        if is_local(name, "Pixels") {
            match found {
                None => *found = Some(Self::of(tag)),
                Some(first) => first.images += 1,
            }
            return true;
        }
        if let Some(image) = found
            && inside
            && image.images == 1
            && is_local(name, "Channel")
            && image.names.len() < MOST_CHANNELS
        {
            image.names.push(attribute(tag, "Name").unwrap_or_default());
        }
        false
    }

    fn of(tag: &BytesStart) -> Self {
        let count = |name| attribute(tag, name).and_then(|text| text.trim().parse().ok()).unwrap_or(1_u64).max(1);
        let mut image = Self {
            channels: count("SizeC"),
            slices: count("SizeZ"),
            frames: count("SizeT"),
            order: attribute(tag, "DimensionOrder").unwrap_or_default(),
            images: 1,
            ..Self::default()
        };
        for (axis, name) in ["PhysicalSizeX", "PhysicalSizeY", "PhysicalSizeZ"].into_iter().enumerate() {
            let size = attribute(tag, name).and_then(|text| text.trim().parse::<f64>().ok());
            let Some(size) = size.filter(|size| size.is_finite() && *size > 0.0) else { continue };
            // The default of the format is a micrometre.
            let unit = attribute(tag, &format!("{name}Unit")).unwrap_or_else(|| "µm".to_owned());
            let scale = millimetres(&unit);
            if scale.is_none() {
                image.unknown_unit = Some(unit);
            }
            image.spacing[axis] = Some(size * scale.unwrap_or(1.0));
        }
        image
    }

    /// The distances in pages of channels, slices and points in time.
    pub fn strides(&self) -> [u64; 3] {
        let mut strides = [1; 3];
        let mut stride = 1_u64;
        let counts = [('C', self.channels), ('Z', self.slices), ('T', self.frames)];
        let axes = self.order.chars().chain("CZT".chars());
        let mut left = vec![0, 1, 2];
        for letter in axes {
            if let Some(index) = left.iter().position(|&axis| counts[axis].0 == letter) {
                let axis = left.remove(index);
                strides[axis] = stride;
                stride = stride.saturating_mul(counts[axis].1);
            }
        }
        strides
    }
}

fn is_local(name: &str, local: &str) -> bool {
    name.rsplit(':').next() == Some(local)
}

fn attribute(tag: &BytesStart, name: &str) -> Option<String> {
    let mut attributes = tag.attributes();
    let found = attributes.with_checks(false).flatten().find(|attribute| attribute.key.as_ref() == name)?;
    found.normalized_value(XmlVersion::Implicit1_0).ok().map(|text| text.into_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_document_says_of_its_first_image() {
        let text = r#"<?xml version="1.0"?><OME><Image><Pixels DimensionOrder="XYZCT" SizeZ="5" SizeC="2" SizeT="3"
            PhysicalSizeX="0.5" PhysicalSizeXUnit="&#181;m" PhysicalSizeZ="2500" PhysicalSizeZUnit="nm">
            <Channel Name="DAPI"/><Channel/></Pixels></Image><Image><Pixels SizeC="9"><Channel Name="no"/></Pixels></Image></OME>"#;
        let ome = Ome::read(text).expect("an image");
        assert_eq!((ome.channels, ome.slices, ome.frames, ome.images), (2, 5, 3, 2));
        assert_eq!(ome.spacing, [Some(0.5 * 1e-3), None, Some(2500.0 * 1e-6)]);
        assert_eq!(ome.names, ["DAPI", ""]);
        assert_eq!(ome.strides(), [5, 1, 10]);
        assert_eq!(Ome::read("ImageJ=1"), None);
    }
}
