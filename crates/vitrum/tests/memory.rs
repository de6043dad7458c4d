//! Rendering again and again does not take more and more memory.

#![cfg(target_os = "linux")]

use std::path::Path;
use vitrum::backend::CpuBackend;
use vitrum::{Assets, OutputRequest, builtin, render, render_requested};

/// Bytes of memory that this process has now.
fn resident() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").expect("Linux tells");
    let line = status.lines().find(|line| line.starts_with("VmRSS:")).expect("the line is there");
    line.split_whitespace().nth(1).and_then(|kibibytes| kibibytes.parse::<u64>().ok()).expect("a number") * 1024
}

#[test]
fn two_hundred_renders_take_the_memory_of_one() {
    let mut scene = builtin::scene("ball").expect("it is built in");
    scene.volume.resolution = Some(32);
    (scene.film.width, scene.film.height) = (64, 64);
    let assets = Assets::load(&scene, Path::new("")).expect("it needs no file");
    let mut backend = CpuBackend::new(Some(2)).expect("threads");
    let frame = |backend: &mut CpuBackend, index: u32| {
        // All of it: volumes up and down each time, twice, with another light grid.
        let mut scene = scene.clone();
        scene.camera.azimuth = index as f32;
        scene.film.width = 60 + index % 5;
        let one = render(&scene, &assets, backend, &mut |_| true).expect("a picture");
        let request = OutputRequest { light: false, ..OutputRequest::default() };
        render_requested(&scene, &assets, request, backend, &mut |_| true).expect("a picture");
        one.layers.iter().flat_map(|layer| &layer.channels).map(|channel| 4 * channel.data.len() as u64).sum::<u64>()
    };
    // Until the allocator has what it keeps for each thread: with one arena for all, nothing grows behind the first 20.
    let bytes = (0..80).map(|index| frame(&mut backend, index)).max().expect("a frame");
    let before = resident();
    for index in 80..180 {
        frame(&mut backend, index);
    }
    let grown = resident().saturating_sub(before);
    // The picture alone is a quarter of a megabyte: of 200 that were kept, 50 would be left. What an allocator sets aside for
    // sizes that are new to it is far below 8.
    assert!(bytes * 200 > 40 << 20, "the frames are too small to tell: {bytes} bytes");
    assert!(grown < 8 << 20, "{grown} bytes more after 200 pictures");
}
