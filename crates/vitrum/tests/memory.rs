//! Rendering again and again does not take more and more memory.

use std::path::Path;

use peak_alloc::PeakAlloc;
use vitrum::backend::CpuBackend;
use vitrum::{Assets, OutputRequest, builtin, render, render_requested};

/// Counts the bytes that are in use. The memory of the process says less: the system's allocator keeps for each thread
/// blocks that nobody uses, as many as the threads' turns happened to need.
#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

#[test]
fn a_hundred_renders_take_the_memory_of_one() {
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
        one.layers.iter().flat_map(|layer| &layer.channels).map(|channel| 4 * channel.data.len()).sum::<usize>()
    };
    // Each width of the film once, and the tables that are made once.
    let picture = (0..10).map(|index| frame(&mut backend, index)).min().expect("a frame");
    let before = MEMORY.current_usage();
    for index in 10..60 {
        frame(&mut backend, index);
    }
    let grown = MEMORY.current_usage().saturating_sub(before);
    // Half of one of 100 pictures. Queues between threads grow by blocks of a few kilobytes.
    assert!(picture > 100 << 10, "the frames are too small to tell: {picture} bytes");
    assert!(grown < picture / 2, "{grown} bytes more after 100 pictures of {picture} bytes");
}
