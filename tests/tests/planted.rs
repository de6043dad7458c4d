//! A stranger's kernel with a mistake is caught, and named.
//!
//! Here a stranger writes the light filter and a building block anew, without the tree's helpers. Without a mistake the copies pass
//! every tier to the last bit. With one (a border that is a texel off, a sum that is taken from the other end) each tier says so,
//! and the first row of T1 that differs is the kernel that has it.

use bytemuck::{cast_slice, from_bytes};
use vitrum::backend::{Backend, CpuBackend, Pass};
use vitrum::scene::{MethodName, Transport};
use vitrum_conformance::altered::AlteredCpu;
use vitrum_conformance::case::Case;
use vitrum_conformance::run::Run;
use vitrum_conformance::{Failure, adapter, frames, functions, kernels};
use vitrum_kernels::abi::probe::ProbeUniforms;
use vitrum_kernels::abi::record::{light, probe};
use vitrum_kernels::abi::sweep::SweepUniforms;
use vitrum_kernels::kernel::{Chunk, InstructionSet, Kernel, kernels as the_tree};
use vitrum_kernels::probe::functions::{NAMES, apply};

/// No mistake.
const NONE: u32 = 0;
/// The last column and row count as having a neighbour.
const BORDER: u32 = 1;
/// Terms are added from the last to the first.
const REVERSED: u32 = 2;

/// The light filter, [`vitrum_kernels::sweep::filter_light`], a texel at a time.
fn filter_light<const MISTAKE: u32>(_: InstructionSet, chunk: &mut Chunk<'_>) -> bool {
    let u: &SweepUniforms = from_bytes(chunk.uniforms);
    let behind: &[f32] = cast_slice(chunk.reads[0]);
    let [width, height] = [u.light_grid.width as i32, u.light_grid.height as i32];
    let last = if MISTAKE == BORDER { [width, height] } else { [width - 1, height - 1] };
    let outside: [f32; light::SIZE] =
        [1.0, 1.0, 1.0, u.light.direction.x, u.light.direction.y, u.light.direction.z, 0.0, 0.0, 1.0];
    let offsets =
        [[u.taps.first_x, u.taps.first_y], [u.taps.second_x, u.taps.second_y], [u.taps.third_x, u.taps.third_y]];
    let inside = |row: &u32, column: &u32| chunk.inside.contains(row) && chunk.columns.contains(column);
    let texels = (0..chunk.rows).flat_map(|row| (0..chunk.width).map(move |column| (row, column)));
    for (row, column) in texels.filter(|(row, column)| inside(row, column)) {
        let (x, y) = (column as i32, (chunk.first_row + row) as i32);
        let index = (row * chunk.width + column) as usize;
        for (component, outside) in outside.into_iter().enumerate() {
            let texel = |i: i32, j: i32| {
                let at = component as i32 * width * height + j * width + i;
                behind[at.clamp(0, behind.len() as i32 - 1) as usize]
            };
            let tap = |[across, up]: [f32; 2]| {
                let (i, j) = (x + across.floor() as i32, y + up.floor() as i32);
                if i < 0 || i >= last[0] || j < 0 || j >= last[1] {
                    return outside;
                }
                let (s, t) = (across - across.floor(), up - up.floor());
                let near = texel(i, j) + (texel(i + 1, j) - texel(i, j)) * s;
                let far = texel(i, j + 1) + (texel(i + 1, j + 1) - texel(i, j + 1)) * s;
                near + (far - near) * t
            };
            let [a, b, c] = offsets.map(tap);
            let [a, b, c] = if MISTAKE == REVERSED { [c, b, a] } else { [a, b, c] };
            chunk.output[component][index] = a + ((b - a) + (c - a)) * (1.0 / 3.0);
        }
    }
    true
}

/// The building blocks, [`vitrum_kernels::probe::apply_function`], with a dot product written anew.
fn apply_function<const MISTAKE: u32>(_: InstructionSet, chunk: &mut Chunk<'_>) -> bool {
    let u: &ProbeUniforms = from_bytes(chunk.uniforms);
    let arguments: &[f32] = cast_slice(chunk.reads[0]);
    let count = (u.dispatch.width * u.dispatch.height) as usize;
    for index in 0..(chunk.rows * chunk.width) as usize {
        let at = (chunk.first_row * chunk.width) as usize + index;
        let a: [f32; probe::ARGUMENTS] = std::array::from_fn(|argument| arguments[argument * count + at]);
        let results = match (NAMES[u.function as usize], MISTAKE) {
            ("dot_product", REVERSED) => [(a[2] * a[5] + a[1] * a[4]) + a[0] * a[3], 0.0, 0.0, 0.0],
            ("dot_product", _) => [(a[0] * a[3] + a[1] * a[4]) + a[2] * a[5], 0.0, 0.0, 0.0],
            _ => apply(u.function, a),
        };
        for (component, result) in chunk.output.iter_mut().zip(results) {
            component[index] = result;
        }
    }
    true
}

/// The stranger's kernels: declared as the tree's are, with another body.
macro_rules! strangers {
    ($($name:ident = $kernel:ident, $body:ident, $mistake:ident;)*) => {
        $(static $name: Kernel = Kernel { declaration: the_tree::$kernel.declaration, run: $body::<$mistake> };)*
    };
}

strangers! {
    FILTER = sweep_filter_light, filter_light, NONE;
    FILTER_BORDER = sweep_filter_light, filter_light, BORDER;
    FILTER_REVERSED = sweep_filter_light, filter_light, REVERSED;
    PROBE = probe_apply_function, apply_function, NONE;
    PROBE_REVERSED = probe_apply_function, apply_function, REVERSED;
}

/// A CPU that runs a stranger's kernel in the place of the tree's.
fn stranger(kernel: &'static Kernel) -> Result<AlteredCpu, Failure> {
    AlteredCpu::of_passes(move |list| {
        let replaced = |pass: &&mut Pass| pass.kernel.declaration.name == kernel.declaration.name;
        list.passes.iter_mut().filter(replaced).for_each(|pass| pass.kernel = kernel);
    })
}

/// The result of a tier's comparison, with the evidence in a temporary folder.
fn run(compare: impl FnOnce(&mut Run) -> Result<(), Failure>) -> Result<Run, Failure> {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let mut run = Run::new(folder.path().to_owned());
    compare(&mut run)?;
    Ok(run)
}

/// The first row of T1 that differs, by the name of its kernel, when a stranger's kernel is held against `other`; case by case.
fn blamed(kernel: &'static Kernel, other: &mut dyn Backend) -> Result<Vec<Option<String>>, Failure> {
    let of_case = |case: Case| {
        let run = run(|run| kernels::compare(&case, &mut stranger(kernel)?, other, run))?;
        let first = run.breaches().into_iter().next();
        println!("{}: {}", case.name, first.as_ref().map_or("passes".to_owned(), |row| row.cells()[3..].join(" | ")));
        Ok(first.and_then(|row| row.item.split(' ').next().map(str::to_owned)))
    };
    // Elsewhere light on texels is not filtered, and the stranger is the tree's own CPU, which tests of conformance hold.
    let filters = |case: &Case| {
        case.scene.method == MethodName::Sweep
            && case.scene.sweep.light == Transport::Texels
            && !case.name.ends_with("hard")
    };
    kernels::cases(48, 32)?.into_iter().filter(filters).map(of_case).collect()
}

/// At least one case sees the mistake, and none blames another kernel.
fn assert_blames(kernel: &'static Kernel, other: &mut dyn Backend) -> Result<(), Failure> {
    let found: Vec<String> = blamed(kernel, other)?.into_iter().flatten().collect();
    assert!(!found.is_empty() && found.iter().all(|name| name == kernel.declaration.name), "{found:?}");
    Ok(())
}

#[test]
fn a_kernel_with_a_mistake_is_named_by_its_first_row() -> Result<(), Failure> {
    let mut cpu = CpuBackend::new(None)?;
    assert_blames(&FILTER_BORDER, &mut cpu)?;
    assert_blames(&FILTER_REVERSED, &mut cpu)
}

#[test]
fn a_kernel_with_a_mistake_is_named_against_an_adapter() -> Result<(), Failure> {
    let Some(mut gpu) = adapter::exact_for_test() else { return Ok(()) };
    assert_blames(&FILTER_BORDER, &mut gpu)?;
    assert_blames(&FILTER_REVERSED, &mut gpu)
}

#[test]
fn a_kernel_without_a_mistake_passes() -> Result<(), Failure> {
    let mut cpu = CpuBackend::new(None)?;
    assert!(blamed(&FILTER, &mut cpu)?.iter().all(Option::is_none));
    let Some(mut gpu) = adapter::exact_for_test() else { return Ok(()) };
    assert!(blamed(&FILTER, &mut gpu)?.iter().all(Option::is_none));
    Ok(())
}

#[test]
fn a_frame_shows_the_mistake() -> Result<(), Failure> {
    let case = Case::builtin("head", 48, Some(32), &["sweep.light=texels"])?;
    let outputs = |kernel: &'static Kernel| {
        let run = run(|run| frames::compare(&case, &mut CpuBackend::new(None)?, &mut stranger(kernel)?, run))?;
        Ok::<_, Failure>(run.breaches().into_iter().map(|row| row.item).collect::<Vec<_>>())
    };
    // Light has to do with how rays look, not with where they go; and none of them comes near the light grid's border.
    assert_eq!(outputs(&FILTER_REVERSED)?, ["color", "light"]);
    assert_eq!(outputs(&FILTER_BORDER)?, ["light"]);
    assert!(outputs(&FILTER)?.is_empty());
    Ok(())
}

#[test]
fn a_building_block_with_a_mistake_is_named() -> Result<(), Failure> {
    let names = |kernel: &'static Kernel, other: &mut dyn Backend| {
        let run = run(|run| functions::compare(4, &mut stranger(kernel)?, other, run))?;
        Ok::<_, Failure>(run.breaches().into_iter().map(|row| row.item).collect::<Vec<_>>())
    };
    let mut others: Vec<Box<dyn Backend>> = vec![Box::new(CpuBackend::new(None)?)];
    others.extend(adapter::exact_for_test().map(|gpu| Box::new(gpu) as Box<dyn Backend>));
    for mut other in others {
        assert_eq!(names(&PROBE_REVERSED, other.as_mut())?, ["dot_product"]);
        assert!(names(&PROBE, other.as_mut())?.is_empty());
    }
    Ok(())
}
