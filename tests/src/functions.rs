//! T0: building blocks by themselves, over random and edge inputs.

use std::ops::RangeInclusive;

use vitrum::backend::{Backend, Buffer, Contents, Pass, PassList, ReadBack as _};
use vitrum::scene::MethodName;
use vitrum_kernels::abi::dispatch::Dispatch;
use vitrum_kernels::abi::probe::ProbeUniforms;
use vitrum_kernels::abi::record::probe;
use vitrum_kernels::kernel::{Window, kernels};
use vitrum_kernels::probe::functions::NAMES;

use crate::Failure;
use crate::bounds;
use crate::raster::Raster;
use crate::run::{About, Run};

/// Assets in a row of the dispatch.
const WIDTH: u32 = 1024;

/// Numbers at which functions change their ways.
const EDGES: [f32; 24] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    -0.5,
    2.0,
    3.0,
    1e-20,
    -1e-20,
    1e20,
    -1e20,
    88.0,
    -87.0,
    8_388_608.0,
    -8_388_609.0,
    f32::MIN_POSITIVE,
    -f32::MIN_POSITIVE,
    1e-42,
    f32::MAX,
    f32::MIN,
    f32::INFINITY,
    f32::NEG_INFINITY,
    f32::NAN,
];

/// The value that stands for every NaN: results must agree on being NaN, not on its payload.
const NOT_A_NUMBER: f32 = -1.234_567_9e-30;

/// Compares every building block over `rows` · 1024 inputs, the CPU's results first.
///
/// # Errors
/// If a backend fails, or evidence cannot be written.
pub fn compare(rows: u32, cpu: &mut dyn Backend, other: &mut dyn Backend, run: &mut Run) -> Result<(), Failure> {
    // Functions are of all methods; the first stands for them.
    run.method(MethodName::Sweep);
    let arguments = arguments(rows * WIDTH);
    let expected = results(rows, &arguments, cpu)?;
    let found = results(rows, &arguments, other)?;
    for ((name, expected), found) in NAMES.iter().zip(&expected).zip(&found) {
        let bound = bounds::of_function(other, name);
        let about = About { tier: "T0", scene: "functions", item: name, components: &[] };
        if bounds::is_exact(other) {
            let raster = |numbers| Raster::stacked(WIDTH, [numbers]);
            run.hold(about, bound, &raster(expected), &raster(found))?;
        } else {
            let (expected, found) = ordinary(&arguments, expected, found);
            let raster = |numbers: &[f32]| Raster::stacked(1, [numbers]);
            run.hold(about, bound, &raster(&expected), &raster(&found))?;
        }
    }
    Ok(())
}

/// The range of ordinary arguments and results: beyond it, devices may replace denormal numbers by 0, and treat infinite ones and NaN
/// in their own way. Products of two or three arguments, and their quotients, stay within the normal numbers.
const ORDINARY: RangeInclusive<f32> = 1e-12..=1e12;
/// The range of ordinary results. Below 2⁻¹⁸, the results of `half` come from denormal numbers.
const ORDINARY_RESULT: RangeInclusive<f32> = 3.814_697_3e-6..=1e30;

/// The results that count on devices that are not exact, and their counterparts: those that are ordinary, as their arguments are, of the
/// components that the function has.
fn ordinary(arguments: &[f32], expected: &[f32], found: &[f32]) -> (Vec<f32>, Vec<f32>) {
    let count = expected.len() / probe::SIZE;
    let within = |number: f32, range: &RangeInclusive<f32>| number == 0.0 || range.contains(&number.abs());
    let is_ordinary =
        |input: usize| (0..probe::ARGUMENTS).all(|argument| within(arguments[argument * count + input], &ORDINARY));
    let inputs: Vec<usize> = (0..count).filter(|&input| is_ordinary(input)).collect();
    let mut pairs = (Vec::new(), Vec::new());
    for (expected, found) in expected.chunks(count).zip(found.chunks(count)) {
        if expected.iter().all(|&result| result == 0.0) {
            continue;
        }
        let counts = inputs.iter().filter(|&&input| within(expected[input], &ORDINARY_RESULT));
        pairs.extend(counts.map(|&input| (expected[input], found[input])));
    }
    pairs
}

/// The results of every function.
fn results(rows: u32, arguments: &[f32], backend: &mut dyn Backend) -> Result<Vec<Vec<f32>>, Failure> {
    let count = rows as usize * WIDTH as usize;
    let inputs = backend.create("arguments", Contents::Bytes(bytemuck::cast_slice(arguments)))?;
    let outputs = backend.create("results", Contents::Zeros((count * probe::SIZE * 4) as u64))?;
    let buffers = [inputs, outputs];
    (0..NAMES.len() as u32).map(|function| apply(function, rows, &buffers, backend)).collect()
}

fn apply(function: u32, rows: u32, buffers: &[Buffer; 2], backend: &mut dyn Backend) -> Result<Vec<f32>, Failure> {
    let uniforms = ProbeUniforms { dispatch: Dispatch { width: WIDTH, height: rows, mode: 0 }, function };
    let pass = Pass {
        kernel: &kernels::probe_apply_function,
        uniforms: bytemuck::bytes_of(&uniforms).to_vec(),
        buffers: buffers.to_vec(),
        width: WIDTH,
        height: rows,
        start: 0,
        window: Window::whole(WIDTH, rows),
    };
    backend.run(&PassList { passes: vec![pass], ..PassList::default() }, &mut |_| true)?;
    let mut numbers: Vec<f32> = backend.read_all(&buffers[1])?;
    numbers.iter_mut().filter(|number| number.is_nan()).for_each(|number| *number = NOT_A_NUMBER);
    Ok(numbers)
}

/// Arguments for `count` inputs, planar: in turn small numbers, numbers of all sizes, random bits and edges.
fn arguments(count: u32) -> Vec<f32> {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    // The generator of Vigna 2016, xorshift64*.
    let mut random = move || {
        state ^= state >> 12;
        state ^= state << 25;
        state ^= state >> 27;
        (state.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 32) as u32
    };
    let mut one = |index: usize| {
        let bits = random();
        let unit = f64::from(bits) / f64::from(u32::MAX);
        match index % 4 {
            0 => (unit * 8.0 - 4.0) as f32,
            1 => (10.0f64.powf(unit * 24.0 - 12.0) * if bits & 1 == 0 { 1.0 } else { -1.0 }) as f32,
            2 => f32::from_bits(bits),
            _ => EDGES[bits as usize % EDGES.len()],
        }
    };
    (0..count as usize * probe::ARGUMENTS).map(|index| one(index % count as usize)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_ordinary_numbers_count_where_devices_are_not_exact() {
        let mut arguments = vec![1.0; 5 * probe::ARGUMENTS];
        arguments[1] = 1e-42;
        arguments[2 * 5 + 2] = f32::NAN;
        let mut expected = vec![0.0; 5 * probe::SIZE];
        let mut found = expected.clone();
        expected[..5].copy_from_slice(&[1.0, 2.0, 3.0, 1e-40, 4.0]);
        found[..5].copy_from_slice(&[1.5, 0.0, 0.0, 0.0, 4.0]);
        assert_eq!(ordinary(&arguments, &expected, &found), (vec![1.0, 4.0], vec![1.5, 4.0]));
    }
}
