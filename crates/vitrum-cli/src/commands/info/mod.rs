//! `vitrum info`: the description of a volume or a mesh, and the assumptions that the reader made.

mod digits;
mod mesh;
mod place;
mod values;

use crate::failure::Failure;
use crate::volume::VolumeArguments;
use crate::{advice, input, output};
use clap::Args;
use serde_json::json;
use std::fmt::Write;
use std::process::ExitCode;
use vitrum::io::{Fact, Orientation, Volume, Voxels};

/// Show what a volume or a mesh is: format, size, spacing, range, histogram; triangles, bounds, area, closed or not
#[derive(Debug, Args)]
pub struct Arguments {
    /// A volume file, a folder of DICOM files, a mesh file, `-` for a volume from standard input, a scene file (.toml; its
    /// volume is shown), or builtin:NAME
    #[arg(add = crate::complete::inputs())]
    input: String,

    #[command(flatten)]
    volume: VolumeArguments,

    /// Print JSON
    #[arg(long)]
    json: bool,
}

/// Columns of the histogram.
const BINS: usize = 64;

pub fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    let opened = vitrum::composition::open(&arguments.input)?;
    let as_raw_voxels = opened.bare && arguments.volume.raw.is_some();
    if opened.scene.shows_mesh() && !as_raw_voxels {
        let mesh = input::open_mesh(&arguments.input, arguments.volume.limit())?;
        if arguments.json {
            output::print_json(&mesh::json(&mesh))?;
        } else {
            output::print(&mesh::text(&mesh))?;
        }
        return Ok(ExitCode::SUCCESS);
    }
    let volume = input::open_volume(&arguments.input, &arguments.volume)?;
    if arguments.json {
        output::print_json(&json(&volume))?;
    } else {
        output::print(&text(&volume))?;
    }
    Ok(ExitCode::SUCCESS)
}

fn text(volume: &Volume) -> String {
    let [nx, ny, nz] = volume.dimensions;
    let [low, high] = volume.range;
    let source = &volume.source;
    let mut text = String::new();
    let mut row = |name: &str, value: String| {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "{name:12}{value}");
    };
    row("volume", volume.name.clone());
    row("format", if source.format.is_empty() { "computed".to_owned() } else { source.format.to_owned() });
    row("voxels", format!("{nx} x {ny} x {nz} ({} in memory)", bytes(volume.bytes())));
    let file = [&*source.sample_type, &*source.encoding].into_iter().filter(|part| !part.is_empty());
    let file = file.map(|part| format!("{part}, ")).collect::<String>();
    row("type", format!("{file}{} in memory", stored(volume)));
    let facts = source.assumptions.stated();
    let from = |name: &str| match facts.iter().find(|fact| fact.name == name) {
        Some(fact) => format!("  (from {})", fact.from),
        None => String::new(),
    };
    let unit = place::unit(volume);
    let [sx, sy, sz] = place::shown(volume.spacing);
    row("spacing", format!("{sx} x {sy} x {sz}{unit}{}", from("spacing")));
    let [ex, ey, ez] = place::shown(volume.extent());
    row("extent", format!("{ex} x {ey} x {ez}{unit}"));
    let [ox, oy, oz] = place::shown(volume.origin);
    row("origin", format!("({ox}, {oy}, {oz}){unit}"));
    let oriented = if volume.orientation == Orientation::Unknown { String::new() } else { from("orientation") };
    row("orientation", format!("{}{oriented}", volume.orientation.name()));
    row("axes", place::axes(volume));
    for fact in facts.iter().filter(|fact| !fact.value.is_empty() && fact.name != "unit") {
        row(fact.name, format!("{}  (from {})", fact.value, fact.from));
    }
    if let Some(moments) = source.moments().filter(|moments| moments.count > 1) {
        row("times", values::times(moments));
    }
    let hounsfield = facts.iter().any(|fact| fact.name == "values" && fact.value.contains("(HU)"));
    row("range", format!("{low} to {high}{}", if hounsfield { " HU" } else { "" }));
    row("histogram", format!("{}  (logarithmic)", bars(&volume.histogram(BINS))));
    for (name, told) in values::rows(volume) {
        row(name, told);
    }
    for (name, told) in advice::on_assumptions(&source.assumptions) {
        row(name, told);
    }
    text
}

fn json(volume: &Volume) -> serde_json::Value {
    json!({
        "name": volume.name,
        "format": volume.source.format,
        "sample_type": volume.source.sample_type,
        "encoding": volume.source.encoding,
        "dimensions": volume.dimensions,
        "spacing": volume.spacing,
        "unit": place::unit_name(volume),
        "extent": volume.extent(),
        "origin": place::tidy(volume.origin),
        "orientation": volume.orientation.name(),
        "axes": volume.axes.map(place::tidy),
        "letters": place::letters(volume),
        "facts": volume.source.assumptions.stated().iter().map(fact).collect::<Vec<_>>(),
        "stored_as": stored(volume),
        "value_scale": volume.value_scale,
        "value_offset": volume.value_offset,
        "range": volume.range,
        "times": volume.source.moments().map_or(1, |moments| moments.count),
        "moments": volume.source.moments().and_then(|moments| moments.seconds.clone()),
        "bytes": volume.bytes(),
        "histogram": volume.histogram(BINS),
        "histogram_parts": values::json_parts(volume),
        "percentiles": values::json_percentiles(volume),
        "gradients": values::json_gradients(volume),
        "landmarks": values::json_landmarks(volume),
        "noise": values::json_noise(volume),
        "preset": values::json_preset(volume),
        "assumptions": volume.source.assumptions.iter().map(advice::on_assumption).collect::<Vec<_>>(),
    })
}

fn fact(fact: &Fact) -> serde_json::Value {
    json!({ "name": fact.name, "value": fact.value, "from": fact.from })
}

fn stored(volume: &Volume) -> &'static str {
    match volume.voxels {
        Voxels::U8(_) => "8-bit",
        Voxels::U16(_) => "16-bit",
        Voxels::F32(_) => "float32",
    }
}

/// A count of bytes in the unit that keeps it short.
fn bytes(count: usize) -> String {
    const UNITS: [&str; 4] = ["bytes", "KiB", "MiB", "GiB"];
    let mut count = count as f64;
    let mut unit = 0;
    while count >= 1024.0 && unit + 1 < UNITS.len() {
        count /= 1024.0;
        unit += 1;
    }
    if unit == 0 { format!("{count} bytes") } else { format!("{count:.1} {}", UNITS[unit]) }
}

/// One character a bin, its height the logarithm of the count; empty bins are blank.
fn bars(counts: &[u64]) -> String {
    const HEIGHTS: [char; 8] = ['▁', '▂', '▃', '▄', '▅', '▆', '▇', '█'];
    let most = counts.iter().copied().max().unwrap_or(0);
    let scale = libm::log(most as f64 + 1.0);
    let bar = |&count: &u64| match count {
        0 => ' ',
        // The cast saturates, and the largest count is the last height.
        count => HEIGHTS[((libm::log(count as f64 + 1.0) / scale * 8.0) as usize).min(7)],
    };
    counts.iter().map(bar).collect()
}

#[cfg(test)]
mod tests {
    use super::{bars, bytes};

    #[test]
    fn bars_grow_with_the_logarithm() {
        assert_eq!(bars(&[0, 1, 1_000_000]), " ▁█");
        assert_eq!(bars(&[]), "");
        assert_eq!(bars(&[0, 0]), "  ");
    }

    #[test]
    fn bytes_are_short() {
        assert_eq!(bytes(17), "17 bytes");
        assert_eq!(bytes(27_543_608), "26.3 MiB");
        assert_eq!(bytes(usize::MAX), "17179869184.0 GiB");
    }
}
