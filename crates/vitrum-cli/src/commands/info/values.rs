//! The values of a volume: counts by value, percentiles, and the landmarks that presets find.

use serde_json::{Map, Value, json};
use vitrum::io::{Moments, Volume, Voxels};
use vitrum::preset::{Choice, Noise, choose, gradient_percentiles, landmarks, noise, percentiles};

/// Parts of the histogram that are told with their counts.
const PARTS: usize = 16;

/// Shares of the voxels, and their names as percentiles.
const SHARES: [(&str, f64); 9] = [
    ("0.1", 0.001),
    ("1", 0.01),
    ("5", 0.05),
    ("25", 0.25),
    ("50", 0.5),
    ("75", 0.75),
    ("95", 0.95),
    ("99", 0.99),
    ("99.9", 0.999),
];

/// Shares of the voxels whose gradient's magnitude is told, and their names.
const GRADIENT_SHARES: [(&str, f64); 5] = [("50", 0.5), ("75", 0.75), ("90", 0.9), ("99", 0.99), ("99.9", 0.999)];

/// A part of the values, and the number of voxels in it.
struct Part {
    range: [f32; 2],
    count: u64,
}

/// Equal parts of the range without outliers, and before and behind them the outliers, where there are any.
fn parts(volume: &Volume) -> Vec<Part> {
    let [low, high] = volume.common_range();
    let mut counts = volume.histogram_over([low, high], PARTS);
    let [below, above] = outliers(volume, [low, high]);
    counts[0] -= below.min(counts[0]);
    counts[PARTS - 1] -= above.min(counts[PARTS - 1]);
    let edge = |index: usize| low + (high - low) * index as f32 / PARTS as f32;
    let inner =
        counts.into_iter().enumerate().map(|(index, count)| Part { range: [edge(index), edge(index + 1)], count });
    let [least, most] = volume.range;
    let outer = |count: u64, range| (count > 0).then_some(Part { range, count });
    outer(below, [least, low]).into_iter().chain(inner).chain(outer(above, [high, most])).collect()
}

/// The numbers of voxels below and above a range.
fn outliers(volume: &Volume, [low, high]: [f32; 2]) -> [u64; 2] {
    if volume.range == [low, high] {
        return [0, 0];
    }
    let value = |stored: f32| stored * volume.value_scale + volume.value_offset;
    let count = |values: &mut dyn Iterator<Item = f32>| {
        values.fold([0, 0], |[below, above], stored| {
            let value = value(stored);
            [below + u64::from(value < low), above + u64::from(value > high)]
        })
    };
    match &volume.voxels {
        Voxels::U8(voxels) => count(&mut voxels.iter().map(|&voxel| f32::from(voxel))),
        Voxels::U16(voxels) => count(&mut voxels.iter().map(|&voxel| f32::from(voxel))),
        Voxels::F32(voxels) => count(&mut voxels.iter().copied()),
    }
}

/// Rows for people: a name, where one begins, and the text.
pub fn rows(volume: &Volume) -> Vec<(&'static str, String)> {
    let mut rows = Vec::new();
    let parts = parts(volume);
    let total: u64 = parts.iter().map(|part| part.count).sum();
    let shown: Vec<[String; 3]> =
        parts.iter().map(|part| [number(part.range[0]), number(part.range[1]), part.count.to_string()]).collect();
    let width = |column: usize| shown.iter().map(|row| row[column].len()).max().unwrap_or(0);
    let (from, to, count) = (width(0), width(1), width(2));
    for (index, ([low, high, voxels], part)) in shown.iter().zip(&parts).enumerate() {
        let share = 100.0 * part.count as f64 / total.max(1) as f64;
        let text = format!("{low:>from$} to {high:>to$}  {voxels:>count$} voxels  {share:7.3} %");
        rows.push((if index == 0 { "counts" } else { "" }, text));
    }
    rows.push(("percentiles", listed(&percentiles_of(volume))));
    let told = listed(&gradients_of(volume));
    rows.push(("gradients", format!("{told}  (changes over a voxel; --gradient-opacity takes them)")));
    let text = landmarks(volume).named().map(|(name, value)| format!("{name} {}", number(value)));
    rows.push(("landmarks", format!("{}  (of presets; --threshold takes a value)", text.join(", "))));
    rows.push(("noise", told_noise(noise(volume))));
    let Choice { name, reason } = choose(volume);
    rows.push(("preset", format!("{name}, if none is named: {reason}")));
    rows
}

/// The deviation of a value from its neighbours', and what share of matter's values it is.
fn told_noise(noise: Option<Noise>) -> String {
    noise.map_or_else(
        || "too little matter to tell".to_owned(),
        |Noise { deviation, share }| {
            let percent = (1000.0 * f64::from(share)).round() / 10.0;
            format!(
                "{}, {percent} % of the way from air to soft  (standard deviation within the matter)",
                number(deviation)
            )
        },
    )
}

/// The noise for machines; null where it cannot be told.
pub fn json_noise(volume: &Volume) -> Value {
    noise(volume).map_or(Value::Null, |Noise { deviation, share }| json!({ "deviation": deviation, "share": share }))
}

/// The preset that would be chosen, for machines.
pub fn json_preset(volume: &Volume) -> Value {
    let Choice { name, reason } = choose(volume);
    json!({ "name": name, "reason": reason })
}

/// The points in time of a file, and when they are.
pub fn times(moments: &Moments) -> String {
    let Moments { count, chosen, seconds } = moments;
    let seconds = seconds.as_deref().unwrap_or_default();
    let chosen_at = usize::try_from(*chosen).ok().and_then(|chosen| seconds.get(chosen));
    match (seconds.first(), seconds.last(), chosen_at) {
        (Some(first), Some(last), Some(at)) => {
            format!("{count} from {first} s to {last} s; this is number {chosen}, at {at} s")
        }
        _ => format!("{count}; this is number {chosen}"),
    }
}

/// The parts for machines: `[from, to, count]`.
pub fn json_parts(volume: &Volume) -> Value {
    parts(volume).iter().map(|part| json!([part.range[0], part.range[1], part.count])).collect()
}

pub fn json_percentiles(volume: &Volume) -> Value {
    object(percentiles_of(volume))
}

pub fn json_gradients(volume: &Volume) -> Value {
    object(gradients_of(volume))
}

/// Shares of voxels by name, and the numbers below which these are.
type Percentiles = Vec<(&'static str, f32)>;

fn percentiles_of(volume: &Volume) -> Percentiles {
    SHARES.map(|(name, _)| name).into_iter().zip(percentiles(volume, SHARES.map(|(_, share)| share))).collect()
}

fn gradients_of(volume: &Volume) -> Percentiles {
    let values = gradient_percentiles(volume, GRADIENT_SHARES.map(|(_, share)| share));
    GRADIENT_SHARES.map(|(name, _)| name).into_iter().zip(values).collect()
}

/// Percentiles for people.
fn listed(percentiles: &[(&str, f32)]) -> String {
    percentiles.iter().map(|(name, value)| format!("{name} %: {}", number(*value))).collect::<Vec<_>>().join(", ")
}

/// Numbers by name, for machines.
fn object(entries: impl IntoIterator<Item = (&'static str, f32)>) -> Value {
    Value::Object(entries.into_iter().map(|(name, value)| (name.to_owned(), json!(value))).collect::<Map<_, _>>())
}

pub fn json_landmarks(volume: &Volume) -> Value {
    let entries = landmarks(volume).named().map(|(name, value)| (name.to_owned(), json!(value)));
    Value::Object(entries.into_iter().collect::<Map<_, _>>())
}

/// A value with about five digits, without a sign in front of 0.
fn number(value: f32) -> String {
    let value = f64::from(value);
    let rounded: f64 = format!("{value:.4e}").parse().unwrap_or(value);
    match rounded.abs() {
        0.0 => "0".to_owned(),
        1e-4..1e7 => rounded.to_string(),
        _ => format!("{rounded:e}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        for (value, text) in [(-0.0, "0"), (1023.99, "1024"), (0.1, "0.1"), (-2.5e-9, "-2.5e-9"), (1e20, "1e20")] {
            assert_eq!(number(value), text);
        }
    }

    #[test]
    fn outliers_are_apart_and_nothing_is_counted_twice() {
        let mut voxels: Vec<f32> = (0..8000).map(|index| (index % 100) as f32).collect();
        voxels[77] = 1e9;
        let volume = Volume::new("a", [20, 20, 20], [1.0; 3], Voxels::from(voxels)).expect("a volume");
        let parts = parts(&volume);
        assert_eq!(parts.iter().map(|part| part.count).sum::<u64>(), 8000);
        let last = &parts[parts.len() - 1];
        assert_eq!((parts.len(), last.count, last.range[1]), (PARTS + 1, 1, 1e9));
    }
}
