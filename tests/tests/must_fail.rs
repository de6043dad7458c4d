//! Checks that must fail: each tier gets a backend or a picture that is wrong in the last bit of one value, and each program gets
//! inputs that it has to refuse.

use std::process::Command;

use vitrum::backend::CpuBackend;
use vitrum_conformance::altered::AlteredCpu;
use vitrum_conformance::case::Case;
use vitrum_conformance::run::Run;
use vitrum_conformance::{Failure, frames, functions, golden, kernels};

/// The value that is wrong in every buffer.
const FAULT: usize = 77;

/// A CPU, and one that gets the last bit of one value wrong.
fn backends() -> Result<(CpuBackend, AlteredCpu), Failure> {
    Ok((CpuBackend::new(None)?, AlteredCpu::of_bytes(|bytes| bytes[4 * FAULT] ^= 1)?))
}

#[test]
fn a_wrong_bit_of_a_function_is_found() -> Result<(), Failure> {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let (mut cpu, mut faulty) = backends()?;
    let mut run = Run::new(folder.path().to_owned());
    functions::compare(2, &mut cpu, &mut faulty, &mut run)?;
    assert_eq!(run.breaches().len(), run.rows().len(), "{}", run.summary());
    Ok(())
}

#[test]
fn a_wrong_bit_of_a_kernel_is_found() -> Result<(), Failure> {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let (mut cpu, mut faulty) = backends()?;
    let mut run = Run::new(folder.path().to_owned());
    kernels::compare(&Case::builtin("ball", 24, Some(16), &["sweep.light=texels"])?, &mut cpu, &mut faulty, &mut run)?;
    assert_eq!(run.breaches().len(), run.rows().len(), "{}", run.summary());
    assert!(run.rows().iter().all(|row| row.comparison.ulps.first_difference == Some(FAULT)));
    assert!(
        folder.path().join("T1-ball_sweep_light_texels-sweep-sweep_initialize_light_at_plane_0/reference.exr").exists()
    );
    Ok(())
}

#[test]
fn a_wrong_bit_of_a_frame_is_found() -> Result<(), Failure> {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let (mut cpu, mut faulty) = backends()?;
    let mut run = Run::new(folder.path().to_owned());
    frames::compare(&Case::builtin("ball", 24, Some(16), &["sweep.light=texels"])?, &mut cpu, &mut faulty, &mut run)?;
    let wrong: Vec<String> = run.breaches().into_iter().map(|row| row.item).collect();
    assert_eq!(wrong, ["color", "light"], "the first values of both buffers that are read are shown there");
    assert!(folder.path().join("T2-ball_sweep_light_texels-sweep-color/difference.png").exists());
    Ok(())
}

#[test]
fn a_changed_scene_does_not_meet_its_golden_picture() -> Result<(), Failure> {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let mut run = Run::new(folder.path().to_owned());
    golden::bless(folder.path(), "ball")?;
    let mut case = golden::case("ball")?;
    case.scene.film.exposure = 1e-3;
    let frame = frames::render(&case, &mut CpuBackend::new(None)?)?;
    golden::hold(folder.path(), "ball", "brighter", &frame, &mut run)?;
    assert_eq!(run.breaches().len(), 1, "the colour is wrong, and the coverage is right: {}", run.summary());
    Ok(())
}

#[test]
fn a_missing_golden_picture_is_no_agreement() -> Result<(), Failure> {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let mut run = Run::new(folder.path().to_owned());
    let failure = golden::compare(folder.path(), "ball", &mut run).expect_err("there is no picture");
    assert!(failure.to_string().contains("--bless"), "{failure}");
    assert!(golden::bless(folder.path(), "ball")?, "it was not there before");
    assert!(!golden::bless(folder.path(), "ball")?, "blessing again changes nothing");
    golden::compare(folder.path(), "ball", &mut run)?;
    run.assert_passed();
    Ok(())
}

#[test]
fn without_an_adapter_there_is_advice() {
    for program in [env!("CARGO_BIN_EXE_conformance"), env!("CARGO_BIN_EXE_bench")] {
        let arguments = ["--adapter", "no such adapter", "--scene", "ball"];
        let output = Command::new(program).args(arguments).output().expect("the program starts");
        let message = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{message}");
        assert!(message.contains("install a Vulkan driver"), "{message}");
    }
}
