//! Segmentations of 3D Slicer: names and colours of labels, in key/value pairs of the header.
//!
//! The format: <https://slicer.readthedocs.io/en/latest/developer_guide/modules/segmentations.html>.

use std::collections::BTreeMap;

use crate::error::clip;
use crate::labels::{Label, Labels};
use crate::source::Assumptions;

/// More segments than these are not told.
const MOST: usize = 4096;

/// The labels of a header, by the numbers of their segments.
#[derive(Debug, Default)]
pub(crate) struct Segments(BTreeMap<u32, Label>);

impl Segments {
    /// Takes in a key/value pair, such as `Segment0_Name:=liver`; others are left alone.
    pub fn add(&mut self, key: &str, value: &str) {
        let Some((number, what)) = key.trim().strip_prefix("Segment").and_then(|rest| rest.split_once('_')) else {
            return;
        };
        let Ok(number) = number.parse() else { return };
        if self.0.len() >= MOST && !self.0.contains_key(&number) {
            return;
        }
        let label = || Label { value: number as f32 + 1.0, ..Label::default() };
        let value = value.trim();
        match what {
            "Name" => self.0.entry(number).or_insert_with(label).name = clip(value),
            "LabelValue" => {
                if let Ok(value) = value.parse() {
                    self.0.entry(number).or_insert_with(label).value = value;
                }
            }
            "Color" => {
                let color: Option<Vec<f64>> = value.split_whitespace().map(|word| word.parse().ok()).collect();
                self.0.entry(number).or_insert_with(label).color = color.and_then(|color| color.try_into().ok());
            }
            _ => {}
        }
    }

    /// Tells the labels.
    pub fn tell(&self, assumptions: &mut Assumptions) {
        let list: Vec<Label> = self.0.values().cloned().collect();
        if !list.is_empty() {
            assumptions.set_labels(Labels { by: "segments of the header".to_owned(), list });
        }
    }
}
