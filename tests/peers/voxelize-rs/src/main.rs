//! Voxelizes a binary STL file by voxelize-rs: `voxelize-rs-times FILE.stl RESOLUTION RUNS` prints milliseconds and the count of voxels,
//! a line for each run.

use std::time::Instant;
use voxelize_rs::{Triangle, Vector3, voxelize};

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    let bytes = std::fs::read(&arguments[1]).expect("a file");
    let resolution: f32 = arguments[2].parse().expect("a resolution");
    let runs: usize = arguments[3].parse().expect("a count");
    let number = |at: usize| f32::from_le_bytes(bytes[at..at + 4].try_into().expect("four bytes"));
    let point = |at: usize| Vector3::new(number(at), number(at + 4), number(at + 8));
    // A header of 84 bytes; a normal, three corners and two bytes for each triangle.
    let corners: Vec<[Vector3<f32>; 3]> =
        (84..bytes.len() - 49).step_by(50).map(|at| [12, 24, 36].map(|corner| point(at + corner))).collect();
    let extent = |axis: usize| {
        let values = corners.iter().flatten().map(|corner| corner[axis]);
        values.clone().fold(f32::MIN, f32::max) - values.fold(f32::MAX, f32::min)
    };
    let edge = (0..3).map(extent).fold(0.0, f32::max) / resolution;
    for _ in 0..runs {
        let triangles = corners.iter().map(|&[a, b, c]| Triangle::new(a, b, c)).collect();
        let started = Instant::now();
        let voxels = voxelize(&triangles, &Vector3::new(edge, edge, edge));
        println!("{} {}", started.elapsed().as_secs_f64() * 1e3, voxels.len());
    }
}
