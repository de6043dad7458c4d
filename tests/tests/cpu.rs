//! The CPU against itself: what must not change the picture does not.

use vitrum::backend::{Backend as _, Contents, CpuBackend, Pass, PassList, ReadBack as _};
use vitrum::method::sweep::Sweep;
use vitrum_compare::Bound;
use vitrum_conformance::case::Case;
use vitrum_conformance::run::Run;
use vitrum_conformance::{Failure, evidence, frames, kernels, raster};
use vitrum_kernels::abi::dispatch::Dispatch;
use vitrum_kernels::abi::probe::ProbeUniforms;
use vitrum_kernels::abi::record::probe;
use vitrum_kernels::kernel::{InstructionSet, Window, kernels as tree};
use vitrum_kernels::probe::functions::NAMES;

const EDGE: u32 = 48;
const RESOLUTION: u32 = 32;

#[test]
fn instruction_sets_give_the_same_bits() -> Result<(), Failure> {
    let mut run = Run::new(evidence::folder());
    let mut baseline = CpuBackend::with_instruction_set(None, InstructionSet::Baseline)?;
    let others = InstructionSet::ALL.into_iter().filter(|&set| set != InstructionSet::Baseline && set.is_available());
    for set in others {
        let mut other = CpuBackend::with_instruction_set(None, set)?;
        for mut case in kernels::cases(EDGE, RESOLUTION)? {
            case.name.push_str(&format!(" {set:?}"));
            kernels::compare(&case, &mut baseline, &mut other, &mut run)?;
            frames::compare(&case, &mut baseline, &mut other, &mut run)?;
        }
    }
    if InstructionSet::best() != InstructionSet::Baseline {
        run.assert_passed();
    }
    Ok(())
}

#[test]
fn threads_do_not_change_the_picture() -> Result<(), Failure> {
    let mut run = Run::new(evidence::folder());
    let (mut one, mut two) = (CpuBackend::new(Some(1))?, CpuBackend::new(Some(2))?);
    for name in ["glass", "head"] {
        let mut case = Case::builtin(name, EDGE, Some(RESOLUTION), &[])?;
        case.name.push_str(" threads");
        frames::compare(&case, &mut one, &mut two, &mut run)?;
    }
    run.assert_passed();
    Ok(())
}

#[test]
fn a_frame_does_not_depend_on_what_was_rendered_before() -> Result<(), Failure> {
    let mut run = Run::new(evidence::folder());
    let (mut fresh, mut used) = (CpuBackend::new(None)?, CpuBackend::new(None)?);
    frames::render(&Case::builtin("glass", 2 * EDGE, Some(RESOLUTION), &[])?, &mut used)?;
    let mut case = Case::builtin("ball", EDGE, Some(RESOLUTION), &[])?;
    case.name.push_str(" second");
    frames::compare(&case, &mut fresh, &mut used, &mut run)?;
    run.assert_passed();
    Ok(())
}

#[test]
fn skipping_empty_space_does_not_change_the_picture() -> Result<(), Failure> {
    let mut run = Run::new(evidence::folder());
    let mut cpu = CpuBackend::new(None)?;
    for name in ["ball", "glass", "glass/straight", "supernova", "head", "combustion", "combustion/mixture", "luneburg"]
    {
        let mut frame = |skipping: bool| {
            let setting = format!("sweep.empty_space_skipping={skipping}");
            frames::render(&Case::builtin(name, EDGE, Some(RESOLUTION), &[&setting])?, &mut cpu)
        };
        let (all, skipped) = (raster::of_frame(&frame(false)?), raster::of_frame(&frame(true)?));
        run.hold_all(("T2", &format!("{name} skipping")), |_| Bound::BitEqual, &all, &skipped)?;
    }
    run.assert_passed();
    Ok(())
}

#[test]
fn a_frame_that_ends_with_its_rays_is_the_same() -> Result<(), Failure> {
    // Opaque and close up, so that every ray ends long before the last plane.
    let opaque = [
        "sweep.light=texels",
        "camera.zoom=8",
        "transfer.opacity=[{ value = 0, opacity = 1 }]",
        "sweep.sample_distance=0.2",
    ];
    let case = Case::builtin("combustion/opaque", EDGE, Some(RESOLUTION), &opaque)?;
    let mut cpu = CpuBackend::new(None)?;
    let all = frames::render(&case, &mut cpu)?;
    let case = case.without_light();
    let ended = frames::render(&case, &mut cpu)?;
    assert!(ended.light.is_none() && all.light.is_some());
    assert_eq!(all.layers, ended.layers);

    let passes = |prefix: &str| {
        let times = ended.statistics.kernels.iter().find(|times| times.kernel.starts_with(prefix));
        times.map_or(0, |times| times.passes)
    };
    let planes = ended.statistics.planes.expect("it sweeps");
    let (rays, light) = (passes("sweep_propagate_rays"), passes("sweep_gather_light"));
    assert!(0 < rays && rays < planes / 2, "{rays} passes for {planes} planes although no ray was left");
    assert!(light <= rays + 1, "light went on although no ray was left");
    Ok(())
}

#[test]
fn light_is_carried_where_rays_see_it() -> Result<(), Failure> {
    let mut cpu = CpuBackend::new(None)?;
    let names =
        ["head", "supernova", "luneburg", "combustion/mixture", "phantom", "phantom/translucent", "ball", "glass"];
    // Steep light; close up from a corner, so that much lies outside of the picture, with a wide filter.
    let steep: &[&str] = &["light.0.azimuth=60", "light.0.elevation=20", "light.0.angular_radius=0"];
    let near: &[&str] = &["camera.azimuth=40", "camera.elevation=35", "camera.zoom=2.5", "light.0.angular_radius=6"];
    for (name, settings) in names.iter().flat_map(|name| [(name, &[][..]), (name, steep), (name, near)]) {
        let mut case = Case::builtin(name, EDGE, Some(RESOLUTION), &[&["sweep.light=texels"][..], settings].concat())?;
        (case.scene.ground, case.scene.wall) = (None, None);
        let all = frames::render(&case, &mut cpu)?;
        let case = case.without_light();
        let seen = frames::render(&case, &mut cpu)?;
        assert!(seen.light.is_none() && all.light.is_some());
        assert!(all.layers == seen.layers, "{}: the picture is another one", case.name);

        let sweep = Sweep::prepare(&case.scene, &case.assets, case.request, &mut cpu)?;
        let run: u64 = sweep.passes.passes.iter().map(Pass::invocations).sum();
        let whole = |pass: &Pass| Pass { window: Window::whole(pass.width, pass.height), ..pass.clone() };
        let most: u64 = sweep.passes.passes.iter().map(|pass| whole(pass).invocations()).sum();
        assert!(run < most, "{}: all texels on every plane", case.name);
    }
    Ok(())
}

#[test]
fn light_goes_on_where_it_may_be_seen_again() -> Result<(), Failure> {
    let mut cpu = CpuBackend::new(None)?;
    let cases = [
        Case::builtin("ball", EDGE, Some(RESOLUTION), &["sweep.light=texels"])?,
        Case::builtin("glass", EDGE, Some(RESOLUTION), &["sweep.light=texels"])?.without_light(),
        // So oblique that texels do not follow it, and light moves on to those that were seen before.
        Case::builtin("head", EDGE, Some(RESOLUTION), &["sweep.light=texels", "light.0.azimuth=75"])?.without_light(),
    ];
    for case in cases {
        let sweep = Sweep::prepare(&case.scene, &case.assets, case.request, &mut cpu)?;
        let whole = |pass: &Pass| pass.window == Window::whole(pass.width, pass.height);
        assert!(sweep.passes.passes.iter().all(whole), "{}: not all texels", case.name);
    }
    Ok(())
}

#[test]
fn a_renderer_renders_what_a_fresh_start_renders() -> Result<(), Failure> {
    let mut case = Case::builtin("glass", EDGE, Some(RESOLUTION), &[])?;
    let mut fresh = CpuBackend::new(None)?;
    let mut renderer = vitrum::Renderer::new(Box::new(CpuBackend::new(None)?), case.assets.clone());
    for setting in
        ["camera.azimuth=20", "light.0.azimuth=-30", "transfer.ior=[{ value = 0, ior = 1 }]", "film.width=33"]
    {
        case.scene.set(setting)?;
        let (kept, anew) =
            (renderer.render(&case.scene, Default::default(), &mut |_| true)?, frames::render(&case, &mut fresh)?);
        assert_eq!(kept.layers, anew.layers, "{setting}");
    }
    case.scene.camera.zoom = -1.0;
    assert!(renderer.render(&case.scene, Default::default(), &mut |_| true).is_err());
    case.scene.camera.zoom = 1.0;
    assert!(renderer.render(&case.scene, Default::default(), &mut |_| true).is_ok());
    Ok(())
}

/// Blocks at the end of rows begin in the block before, and rows of fewer columns than a block has lanes are run apart.
#[test]
fn records_do_not_depend_on_the_width_of_rows() -> Result<(), Failure> {
    const RECORDS: u32 = 2 * 3 * 4 * 5 * 7;
    let function = NAMES.iter().position(|name| *name == "composited").expect("a function with several results") as u32;
    let count = RECORDS as usize * probe::ARGUMENTS;
    let arguments: Vec<f32> = (0..count).map(|index| (index * 37 % 101) as f32 / 101.0).collect();
    for set in InstructionSet::ALL.into_iter().filter(|set| set.is_available()) {
        let mut backend = CpuBackend::with_instruction_set(None, set)?;
        let inputs = backend.create("arguments", Contents::Bytes(bytemuck::cast_slice(&arguments)))?;
        let outputs = backend.create("results", Contents::Zeros(u64::from(RECORDS) * probe::SIZE as u64 * 4))?;
        let mut results = |width: u32| -> Result<Vec<u8>, Failure> {
            let height = RECORDS / width;
            let uniforms = ProbeUniforms { dispatch: Dispatch { width, height, mode: 0 }, function };
            let pass = Pass {
                kernel: &tree::probe_apply_function,
                uniforms: bytemuck::bytes_of(&uniforms).to_vec(),
                buffers: vec![inputs.clone(), outputs.clone()],
                width,
                height,
                start: 0,
                window: Window::whole(width, height),
            };
            backend.clear(&outputs)?;
            backend.run(&PassList { passes: vec![pass], ..PassList::default() }, &mut |_| true)?;
            Ok(backend.read_all(&outputs)?)
        };
        let one = results(1)?;
        for width in (2..=RECORDS).filter(|width| RECORDS.is_multiple_of(*width)) {
            assert!(results(width)? == one, "{set:?}, rows of {width}");
        }
    }
    Ok(())
}
