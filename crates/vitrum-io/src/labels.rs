//! Volumes whose values are labels of parts, and no measurements.

use crate::error::clip;
use crate::volume::Volume;
use crate::voxels::Voxels;

/// A label, as far as a file names it.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Label {
    /// The value of the label's voxels.
    pub value: f32,
    /// Its name; empty where the file has none.
    pub name: String,
    /// Red, green and blue from 0 to 1, as they are displayed (sRGB).
    pub color: Option<[f64; 3]>,
}

/// The labels of a volume, and by what its values are taken for such.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Labels {
    /// What says it, such as `header's intent`.
    pub by: String,
    /// The labels that the file names and those among the voxels, in ascending order where the file has no order of its own; not those of a
    /// volume with more than anyone tells apart.
    pub list: Vec<Label>,
}

impl Labels {
    /// The labels of values that are indices of colours, where these jump from index to index as colours of labels do; those of a map over
    /// measurements do not.
    pub(crate) fn of_palette(colors: &[[f64; 3]], volume: &Volume) -> Option<Self> {
        const JUMP: f64 = 0.3;
        let steps = colors.windows(2).map(|pair| pair[0].iter().zip(pair[1]).map(|(a, b)| (a - b).abs()).sum::<f64>());
        let mean = steps.sum::<f64>() / colors.len().max(2) as f64;
        if mean < JUMP {
            return None;
        }
        let colored =
            |value: &f32| Label { value: *value, color: colors.get(*value as usize).copied(), ..Label::default() };
        let values = distinct(&volume.voxels, MOST)?;
        let list = values.iter().filter(|value| **value > 0.0).map(colored).collect();
        Some(Self { by: "colours of the palette".to_owned(), list })
    }
}

/// More labels than these are not listed.
const MOST: usize = 256;

/// More numbers than these are not taken for labels without the file's word.
const FEW: usize = 64;

/// The statement that values are labels, by whom.
pub(crate) fn note(Labels { by, list }: &Labels) -> String {
    const SHOWN: usize = 12;
    let described = |label: &Label| {
        let name = if label.name.is_empty() { String::new() } else { format!(" `{}`", clip(&label.name)) };
        let color = label.color.map(|[r, g, b]| format!(" ({r} {g} {b})")).unwrap_or_default();
        format!("{}{name}{color}", label.value)
    };
    let shown: Vec<String> = list.iter().take(SHOWN).map(described).collect();
    let more = list.len().saturating_sub(SHOWN);
    let more = if more > 0 { format!(" and {more} more") } else { String::new() };
    let listed = if shown.is_empty() { String::new() } else { format!(": {}{more}", shown.join(", ")) };
    format!(
        "the values are labels, by the {by}{listed}; `--preset labels` shows each in its colour, other presets interpolate between them"
    )
}

/// Tells the labels of a volume: those that its file declares, with the values that it does not name; else those of whole numbers that lie
/// together as labels do.
pub(crate) fn tell(volume: &mut Volume) {
    let assumptions = &volume.source.assumptions;
    let declared = assumptions.labels().cloned();
    if declared.is_none() && !is_integer(&volume.source.sample_type) {
        return;
    }
    let most = if declared.is_some() { MOST } else { FEW };
    let stored = distinct(&volume.voxels, most);
    let mut labels = match (declared, &stored) {
        (Some(labels), _) => labels,
        (None, Some(stored)) if volume.paged.is_none() && looks_like_labels(volume, stored) => {
            let by =
                if stored.len() == 2 { "two values, as those of a mask" } else { "few whole numbers that lie apart" };
            Labels { by: by.to_owned(), list: Vec::new() }
        }
        (None, _) => return,
    };
    for stored in stored.unwrap_or_default() {
        let value = stored * volume.value_scale + volume.value_offset;
        if value != 0.0 && labels.list.iter().all(|label| label.value.to_bits() != value.to_bits()) {
            labels.list.push(Label { value, ..Label::default() });
        }
    }
    labels.list.truncate(MOST);
    volume.source.assumptions.push(note(&labels));
    volume.source.assumptions.set_labels(labels);
}

fn is_integer(sample_type: &str) -> bool {
    matches!(sample_type, "bool" | "uint8" | "int8" | "uint16" | "int16" | "uint32" | "int32" | "uint64" | "int64")
}

/// The different stored numbers, in ascending order; `None` of more than `most`.
fn distinct(voxels: &Voxels, most: usize) -> Option<Vec<f32>> {
    match voxels {
        Voxels::U8(voxels) => seen(voxels.iter().map(|&voxel| usize::from(voxel)), 1 << 8, most),
        Voxels::U16(voxels) => seen(voxels.iter().map(|&voxel| usize::from(voxel)), 1 << 16, most),
        Voxels::F32(voxels) => {
            let mut found: Vec<f32> = Vec::new();
            let mut last = f32::NAN;
            // Neighbours are mostly alike.
            for &value in voxels.iter() {
                if value.to_bits() != last.to_bits()
                    && let Err(place) = found.binary_search_by(|known| known.total_cmp(&value))
                {
                    if found.len() == most {
                        return None;
                    }
                    found.insert(place, value);
                }
                last = value;
            }
            Some(found)
        }
    }
}

/// The different ones of whole numbers below `end`; `None` of more than `most`.
fn seen(numbers: impl Iterator<Item = usize>, end: usize, most: usize) -> Option<Vec<f32>> {
    let mut seen = vec![false; end];
    let mut count = 0;
    for number in numbers {
        if !std::mem::replace(&mut seen[number], true) {
            count += 1;
            if count > most {
                return None;
            }
        }
    }
    Some((0..end).filter(|&number| seen[number]).map(|number| number as f32).collect())
}

/// Whether numbers that no file calls labels are such: few, 0 among them and none below; most neighbours alike; and where they differ, the
/// numbers between them mostly left out, as no measurement does. Of two numbers, those of a mask: 0, and 1 or the type's largest.
fn looks_like_labels(volume: &Volume, stored: &[f32]) -> bool {
    const FEWEST_VOXELS: usize = 4096;
    let of = |stored: &f32| stored * volume.value_scale + volume.value_offset;
    let values: Vec<f32> = stored.iter().map(of).collect();
    if values.first() != Some(&0.0) || volume.voxels.len() < FEWEST_VOXELS {
        return false;
    }
    if let [_, high] = values[..] {
        return [1.0, 255.0, 65535.0].contains(&high) && MASKS.contains(&volume.source.format);
    }
    if values.len() < 3 || values.iter().any(|value| value.fract() != 0.0) {
        return false;
    }
    let width = volume.dimensions[0] as usize;
    let (mut alike, mut near, mut far) = (0_u64, 0_u64, 0_u64);
    let place = |value: f32| stored.partition_point(|known| known.total_cmp(&value).is_lt());
    for index in (1..volume.voxels.len()).filter(|index| index % width != 0) {
        let [Some(a), Some(b)] = [index - 1, index].map(|index| volume.voxels.stored(index)) else { return false };
        match () {
            () if a.to_bits() == b.to_bits() => alike += 1,
            () if place(a).abs_diff(place(b)) == 1 => near += 1,
            () => far += 1,
        }
    }
    alike > 4 * (near + far) && far > near
}

/// Formats in which programs write masks. A volume of another with two values may be one of voxels that a body fills.
const MASKS: [&str; 3] = ["TIFF stack", "NIfTI-1", "NIfTI-2"];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_are_told_with_names_and_colours() {
        let label = Label { value: 3.0, name: "liver".to_owned(), color: Some([0.5, 0.25, 1.0]) };
        let list = vec![label, Label { value: 4.0, ..Label::default() }];
        let told = note(&Labels { by: "header".to_owned(), list });
        assert!(told.contains("labels, by the header: 3 `liver` (0.5 0.25 1), 4; `--preset labels`"), "{told}");
    }
}
