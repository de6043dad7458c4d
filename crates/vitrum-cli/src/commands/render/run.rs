//! The course of a render: check, read, render, write.

use super::Arguments;
use super::aov::AovRequest;
use super::write::{check_annotations, check_names, check_outputs, write_outputs};
use crate::failure::Failure;
use crate::figure::{Figure, check_background};
use crate::progress::Bar;
use crate::{faster, interrupt, output};
use std::process::ExitCode;
use vitrum::composition::Composed;
use vitrum::method::voxels::bodies;
use vitrum::{Frame, Layers, OutputRequest, Renderer, Statistics};

pub fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    interrupt::listen(arguments.timeout);
    arguments.device.limit_threads()?;
    // Refusals that need no work come before any work.
    check_outputs(arguments)?;
    let composed = arguments.scene.compose()?;
    output::tell(&arguments.scene.input, &composed.notes, arguments.quiet);
    check_names(arguments, &composed.scene)?;
    arguments.memory.check(&composed.scene)?;
    vitrum::check(&composed.scene, &composed.assets)?;
    check_background(&composed.scene, &arguments.output)?;
    let figure = Figure::new(&composed.scene, &composed.assets)?;
    check_annotations(arguments, &figure)?;
    let mut renderer = arguments.device.renderer(&composed.assets, &arguments.memory, arguments.quiet)?;
    let frame = render(arguments, &composed, &mut renderer)?;
    interrupt::check()?;
    let statistics = frame.statistics.clone();
    write_outputs(arguments, &composed.scene, frame, &figure)?;
    if !arguments.quiet {
        figure.tell(&arguments.output);
        warn_of_holes(arguments, &composed, &statistics)?;
        eprintln!("{}: {}", arguments.output.display(), summary(&statistics));
    }
    if arguments.json {
        output::print_json(&serde_json::to_value(&statistics).unwrap_or_default())?;
    }
    Ok(ExitCode::SUCCESS)
}

/// Says whether clear bodies of a mesh have holes.
fn warn_of_holes(arguments: &Arguments, composed: &Composed, statistics: &Statistics) -> Result<(), Failure> {
    let Some(mesh) = composed.assets.subject.mesh() else { return Ok(()) };
    let bodies = bodies(mesh, &composed.scene.material)?;
    let clear = bodies.iter().filter(|body| !body.opaque);
    let edges = clear.map(|body| body.mesh.topology().unpaired_edges).sum();
    output::warn_of_holes(&arguments.scene.input, edges, statistics.open_rows);
    Ok(())
}

/// The last of `--frames` frames, with the times of all.
fn render(arguments: &Arguments, composed: &Composed, renderer: &mut Renderer) -> Result<Frame, Failure> {
    let named = |layers: Layers, aov: &AovRequest| layers.with(aov.name);
    let request = OutputRequest {
        light: arguments.aov.iter().any(|aov| aov.name == "light"),
        layers: arguments.aov.iter().fold(Figure::layers(&arguments.output), named),
        ..OutputRequest::default()
    };
    let advice = faster::advice(&composed.scene, renderer.backend().name());
    let bar = Bar::new(arguments.frames, arguments.quiet).warning_of_long_work(arguments.quiet, advice);
    let mut frame_ms = Vec::new();
    // Only the first frame waits for the volume.
    let mut upload_ms = None;
    let mut index = 0;
    loop {
        let mut progress = |progress| {
            bar.update(index, &progress);
            !interrupt::requested()
        };
        let mut frame = renderer.render(&composed.scene, request, &mut progress)?;
        frame_ms.append(&mut frame.statistics.frame_ms);
        upload_ms = upload_ms.or(frame.statistics.upload_ms);
        index += 1;
        if index >= arguments.frames {
            frame.statistics = Statistics { frame_ms, upload_ms, ..frame.statistics };
            return Ok(frame);
        }
    }
}

/// Size and time in a line: the median of the frames.
fn summary(statistics: &Statistics) -> String {
    let mut times = statistics.frame_ms.clone();
    times.sort_by(f64::total_cmp);
    let size = format!("{} x {} pixels", statistics.width, statistics.height);
    match times.get(times.len() / 2) {
        Some(median) if times.len() > 1 => format!("{size}, {} frames, median {median:.1} ms", times.len()),
        Some(time) => format!("{size} in {time:.1} ms"),
        None => size,
    }
}
