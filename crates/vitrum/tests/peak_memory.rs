//! A render on the CPU takes the volume once.

#![cfg(target_os = "linux")]

use vitrum::backend::CpuBackend;
use vitrum::io::{Shared, Volume, Voxels};
use vitrum::scene::Transport;
use vitrum::{builtin, render};

/// The most memory that this process had, in bytes.
fn peak() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").expect("Linux tells");
    let line = status.lines().find(|line| line.starts_with("VmHWM:")).expect("the line is there");
    line.split_whitespace().nth(1).and_then(|kibibytes| kibibytes.parse::<u64>().ok()).expect("a number") * 1024
}

#[test]
fn a_render_takes_the_volume_a_fifth_of_it_and_the_film() {
    let mut scene = builtin::scene("phantom").expect("it is built in");
    (scene.film.width, scene.film.height) = (32, 32);
    scene.sweep.sample_distance = 16.0;
    // Light that is carried forward takes up to 192 MiB of its own.
    scene.sweep.light = Transport::Texels;
    let mut backend = CpuBackend::new(Some(2)).expect("threads");
    let mut take = |edge: u32| {
        let count = edge.pow(3);
        let mut voxels = Vec::with_capacity(Shared::<u8>::room(count as usize));
        voxels.extend((0..count).map(|index| (index.wrapping_mul(2_654_435_761) >> 24) as u8));
        let spacing = [2.0 / edge as f32; 3];
        let volume = Volume::new("noise", [edge; 3], spacing, Voxels::U8(voxels.into())).expect("a volume");
        render(&scene, &volume.into(), &mut backend, &mut |_| true).expect("a picture");
        u64::from(count)
    };
    // Memory of the program, its threads, the tables and the picture: this volume has 32 KiB.
    take(32);
    let before = peak();
    // Each brick of this one is a word among 64 bytes of voxels: the most that the occupancy can take.
    let bytes = take(400);
    let taken = peak() - before;
    assert!(taken >= bytes, "{taken} bytes for a volume of {bytes}: they were not measured");
    assert!(taken < bytes + bytes / 5, "{taken} bytes for a volume of {bytes}");
}
