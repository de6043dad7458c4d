//! A caustic does not depend on how many pixels look at it.

use vitrum_compare::compare;
use vitrum_conformance::case::Case;
use vitrum_conformance::{Failure, frames};

use crate::{CARRIER, on_the_cpu};

const EDGE: usize = 256;
/// The largest mean ꟻLIP: pictures of which an observer hardly tells one from the other.
const ALIKE: f64 = 0.02;

/// The mean of each of 256 × 256 squares of pixels.
fn reduced(pixels: &[[f32; 3]], edge: usize) -> Vec<[f32; 3]> {
    let part = edge / EDGE;
    let mean = |x: usize, y: usize| {
        let mut sum = [0.0f64; 3];
        for (row, column) in (0..part * part).map(|at| (at / part, at % part)) {
            let pixel = pixels[(y * part + row) * edge + x * part + column];
            sum.iter_mut().zip(pixel).for_each(|(sum, channel)| *sum += f64::from(channel));
        }
        sum.map(|channel| (channel / (part * part) as f64) as f32)
    };
    (0..EDGE * EDGE).map(|at| mean(at % EDGE, at / EDGE)).collect()
}

#[test]
fn the_caustic_of_the_glass_is_the_same_at_all_sizes() -> Result<(), Failure> {
    let settings = [
        format!("sweep.light={CARRIER}"),
        "light.0.angular_radius=0".to_owned(),
        "wall=none".to_owned(),
        "sweep.sample_distance=2".to_owned(),
    ];
    let settings: Vec<&str> = settings.iter().map(String::as_str).collect();
    on_the_cpu(|backend, held| {
        let mut pictures: Vec<Vec<[f32; 3]>> = Vec::new();
        let mut on_ground = Vec::new();
        for part in [1, 2, 4] {
            let case = Case::builtin("glass", (EDGE * part) as u32, Some(48), &settings)?;
            let frame = frames::render(&case, backend)?;
            let color = frame.aov("color").expect("every frame has a colour").color();
            if part == 1 {
                // Straight rays that end on the ground see it beside the glass.
                on_ground = seen_straight(&frame)?;
            }
            let mut picture = reduced(&color, EDGE * part);
            for (pixel, seen) in picture.iter_mut().zip(&on_ground) {
                if !seen {
                    *pixel = [0.0; 3];
                }
            }
            pictures.push(picture);
        }
        let ground = on_ground.iter().filter(|seen| **seen).count();
        assert!(ground > EDGE * EDGE / 8, "{ground} pixels see the ground");
        for (one, other, what) in [(0, 1, "256² and 512²"), (1, 2, "512² and 1024²"), (0, 2, "256² and 1024²")] {
            let compared = compare(&pictures[one], &pictures[other], EDGE as u32, EDGE as u32);
            let compared = compared.map_err(|error| Failure::Compare { what: what.to_owned(), error })?;
            let flip = compared.mean_flip.expect("pictures have one") * (EDGE * EDGE) as f64 / ground as f64;
            println!("{}: {what}: FLIP {flip:.4}, RMSE {:.4}", backend.name(), compared.rmse);
            held.at_most(backend, &format!("mean FLIP on the ground of pictures of {what} pixels"), flip, ALIKE);
        }
        Ok(())
    })
}

/// The pixels whose rays have ended on a receiver in the direction in which they set out.
fn seen_straight(frame: &vitrum::Frame) -> Result<Vec<bool>, Failure> {
    let channel = |layer: &str, channel: &str| {
        frame.channel(layer, channel).ok_or_else(|| Failure::Setup(format!("a frame has no {layer}.{channel}")))
    };
    let direction = [channel("direction", "X")?, channel("direction", "Y")?, channel("direction", "Z")?];
    let position = [channel("position", "X")?, channel("position", "Y")?, channel("position", "Z")?];
    let status = channel("status", "Y")?;
    let seen = |at: usize| {
        let [direction, position] = [&direction, &position].map(|of| of.each_ref().map(|of| f64::from(of[at])));
        // The eye is the view's origin.
        let length = position.iter().map(|x| x * x).sum::<f64>().sqrt();
        let straight = (0..3).all(|axis| (direction[axis] - position[axis] / length).abs() < 1e-3);
        straight && status[at] == vitrum_kernels::abi::record::status::ENDED
    };
    Ok((0..status.len()).map(seen).collect())
}
