//! Runs one kernel over buffers of one's own, without a scene: the building block `exponential` over a list of numbers.

use vitrum::backend::{Backend, Contents, CpuBackend, Pass, PassList, ReadBack};
use vitrum_kernels::abi::dispatch::Dispatch;
use vitrum_kernels::abi::probe::ProbeUniforms;
use vitrum_kernels::abi::record::probe;
use vitrum_kernels::kernel::{Window, kernels};
use vitrum_kernels::probe::functions::NAMES;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    const COUNT: u32 = 64;
    let mut backend = CpuBackend::new(None)?;
    // Records are planar: the first argument of each, then the second of each, and so on.
    let mut arguments = vec![0.0f32; COUNT as usize * probe::ARGUMENTS];
    (0..COUNT).for_each(|index| arguments[index as usize] = index as f32 / 16.0);
    let inputs = backend.create("arguments", Contents::Bytes(bytemuck::cast_slice(&arguments)))?;
    let results = backend.create("results", Contents::Zeros(u64::from(COUNT) * probe::SIZE as u64 * 4))?;
    let function = NAMES.iter().position(|name| *name == "exponential").ok_or("the block exists")? as u32;
    let uniforms = ProbeUniforms { dispatch: Dispatch { width: COUNT, height: 1, mode: 0 }, function };
    let pass = Pass {
        kernel: &kernels::probe_apply_function,
        uniforms: bytemuck::bytes_of(&uniforms).to_vec(),
        buffers: vec![inputs, results.clone()],
        start: 0,
        width: COUNT,
        height: 1,
        window: Window::whole(COUNT, 1),
    };
    backend.run(&PassList { passes: vec![pass], ..PassList::default() }, &mut |_| true)?;
    let found: Vec<f32> = backend.read_all(&results)?;
    println!("exp(1) = {}, by libm {}", found[16], libm::expf(1.0));
    Ok(())
}
