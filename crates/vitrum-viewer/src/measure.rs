//! Measuring how pictures follow the hand on this machine, without a window.

use crate::document::Document;
use crate::trouble::Trouble;
use crate::worker::{DeviceOptions, Reply, View, Worker};
use std::sync::Arc;
use std::time::{Duration, Instant};
use vitrum::backend::Choice;

/// Pictures of a drag.
const PICTURES: u64 = 60;

/// Pictures of it before the size has settled.
const SETTLING: u64 = 20;

/// Degrees between two pictures of a drag.
const STEP: f32 = 2.0;

/// The times of a drag on an input, of what comes after it, and of giving a picture up, as lines of text.
///
/// # Errors
/// Where the input cannot be read, or makes no picture.
pub fn measure(input: &str, size: [u32; 2], backend: Choice, device: DeviceOptions) -> Result<String, Trouble> {
    let mut document = Document::open(input, Some(size))?;
    let worker = Worker::start(device, Arc::new(|| ())).map_err(|error| Trouble::new(error.to_string(), ""))?;
    let view = |document: &Document, number, moving| View {
        number,
        scene: document.scene.clone(),
        data: document.data.clone(),
        moving,
        backend,
    };
    let mut text = String::new();
    let mut start = Instant::now();
    let mut last = [0; 2];
    for number in 1..=PICTURES {
        if number == SETTLING {
            start = Instant::now();
        }
        document.scene.camera.azimuth += STEP;
        worker.show(view(&document, number, true));
        last = picture(&worker, number)?.0;
    }
    let seconds = start.elapsed().as_secs_f64() / (PICTURES - SETTLING + 1) as f64;
    let [width, height] = last;
    text += &format!("dragged: {width} x {height} pixels, {:.0} ms, {:.1} a second\n", seconds * 1e3, 1.0 / seconds);
    let start = Instant::now();
    worker.show(view(&document, PICTURES + 1, false));
    loop {
        let ([width, height], complete) = picture(&worker, PICTURES + 1)?;
        let state = if complete { ", complete" } else { "" };
        text += &format!("at rest: {width} x {height} pixels{state} after {:.2} s\n", start.elapsed().as_secs_f64());
        if complete {
            break;
        }
    }
    // A picture at rest is given up for one of another place: what it takes is more than that one takes by itself.
    let mut longest = Duration::ZERO;
    for number in 0..10 {
        document.scene.camera.azimuth += STEP;
        worker.show(view(&document, PICTURES + 2 + 2 * number, false));
        std::thread::sleep(Duration::from_millis(20 + 13 * number));
        document.scene.camera.azimuth += STEP;
        let start = Instant::now();
        worker.show(view(&document, PICTURES + 3 + 2 * number, true));
        while worker.is_waiting() {
            std::thread::sleep(Duration::from_micros(200));
        }
        longest = longest.max(start.elapsed());
        picture(&worker, PICTURES + 3 + 2 * number)?;
    }
    text += &format!("given up: after {:.0} ms at most\n", longest.as_secs_f64() * 1e3);
    Ok(text)
}

/// The size of the next picture of a view, and whether it is complete.
fn picture(worker: &Worker, wanted: u64) -> Result<([u32; 2], bool), Trouble> {
    loop {
        match worker.wait() {
            Some(Reply::Picture { number, shown, complete, .. }) if number == wanted => {
                return Ok((shown.size, complete));
            }
            Some(Reply::Failed { trouble, .. }) => return Err(trouble),
            Some(_) => {}
            None => return Err(Trouble::new("the rendering thread has ended", "report it")),
        }
    }
}
