//! T0: building blocks by themselves, over random and edge inputs.

use vitrum::backend::{Backend, Buffer, Pass, PassList};
use vitrum_kernels::abi::probe::ProbeUniforms;
use vitrum_kernels::abi::record::probe;
use vitrum_kernels::glam::UVec4;
use vitrum_kernels::kernel::kernels;
use vitrum_kernels::probe::functions::NAMES;

use crate::Failure;
use crate::bounds;
use crate::raster::Raster;
use crate::run::{About, Run};

/// Inputs in a row of the dispatch.
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

/// Stands for every NaN: whether a result is one must agree, its payload is nobody's business.
const NOT_A_NUMBER: f32 = -1.234_567_9e-30;

/// Compares every building block over `rows` · 1024 inputs, the CPU's results first.
///
/// # Errors
/// If a backend fails, or evidence cannot be written.
pub fn compare(rows: u32, cpu: &mut dyn Backend, other: &mut dyn Backend, run: &mut Run) -> Result<(), Failure> {
    let arguments = arguments(rows * WIDTH);
    let expected = results(rows, &arguments, cpu)?;
    let found = results(rows, &arguments, other)?;
    let bound = bounds::of_backend(other, "functions", false);
    for ((name, expected), found) in NAMES.iter().zip(&expected).zip(&found) {
        run.hold(About { tier: "T0", scene: "functions", item: name }, bound, expected, found)?;
    }
    Ok(())
}

/// The results of every function.
fn results(rows: u32, arguments: &[f32], backend: &mut dyn Backend) -> Result<Vec<Raster>, Failure> {
    let count = rows as usize * WIDTH as usize;
    let inputs = backend.create("arguments", bytemuck::cast_slice(arguments))?;
    let outputs = backend.create_zeroed("results", (count * probe::SIZE * 4) as u64)?;
    let all = (0..NAMES.len() as u32).map(|function| apply(function, rows, [inputs, outputs], backend)).collect();
    backend.free(inputs);
    backend.free(outputs);
    all
}

fn apply(function: u32, rows: u32, buffers: [Buffer; 2], backend: &mut dyn Backend) -> Result<Raster, Failure> {
    let uniforms = ProbeUniforms { dispatch: UVec4::new(WIDTH, rows, 0, function) };
    let pass = Pass {
        kernel: &kernels::probe_apply_function,
        uniforms: bytemuck::bytes_of(&uniforms).to_vec(),
        buffers: buffers.to_vec(),
        width: WIDTH,
        height: rows,
    };
    backend.run(&PassList { passes: vec![pass], ..PassList::default() }, &mut |_| true)?;
    let mut numbers: Vec<f32> = bytemuck::pod_collect_to_vec(&backend.read(buffers[1])?);
    numbers.iter_mut().filter(|number| number.is_nan()).for_each(|number| *number = NOT_A_NUMBER);
    Ok(Raster::stacked(WIDTH, [numbers.as_slice()]))
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
