//! A volume that comes page by page gives the picture of the whole one, to the last bit: however the planes lie in it, whatever carries
//! the light, with empty space skipped or not, on both backends. Rays that the sweep cannot follow end in both.

use std::collections::BTreeSet;

use std::path::Path;
use std::sync::Arc;
use vitrum::backend::{Backend, BackendError, Buffer, CpuBackend};
use vitrum::io::{Shared, Volume, Voxels};
use vitrum::method::sweep::Sweep;
use vitrum::{Error, OutputRequest, Renderer, Subject};
use vitrum_conformance::Failure;
use vitrum_conformance::adapter::exact_for_test;
use vitrum_conformance::case::Case;

/// Pixels along an edge.
const EDGE: u32 = 24;

/// Voxels along the longest edge: four pages.
const RESOLUTION: u32 = 52;

/// The bits of a frame: its film and its light.
type Bits = (Vec<u32>, Vec<u32>);

/// Runs a frame; how many times pages came, too.
fn run(case: &Case, backend: &mut dyn Backend) -> Result<(Bits, usize), Failure> {
    let prepare = if case.streamed { Sweep::prepare_streamed } else { Sweep::prepare };
    let sweep = prepare(&case.scene, &case.assets, case.request, backend)?;
    let times: BTreeSet<usize> = sweep.passes.writes.iter().map(|write| write.before).collect();
    sweep.run(backend, &mut |_| true)?;
    let bits = |values: Vec<f32>| values.into_iter().map(f32::to_bits).collect();
    let made = (bits(sweep.film(backend)?), bits(sweep.irradiance(backend)?));
    Ok((made, times.len()))
}

/// Rays that turn back end: those of a volume that comes page by page are not followed, as they would go to and fro through all pages.
const TURNED_END: &str = "sweep.follow_turned_rays=false";

fn case(name: &str, settings: &[&str]) -> Result<Case, Failure> {
    Case::builtin(name, EDGE, Some(RESOLUTION), &[&["sweep.light=texels"][..], settings, &[TURNED_END]].concat())
}

const OBLIQUE: &str = "camera.azimuth=37";
const ISOSURFACES: &str = "isosurface=[{value=35,opacity=0.3,color='red'},{value=130}]";
const FROM_ABOVE: &str = "camera.elevation=41";

/// Scenes with planes across the voxels in all ways.
fn cases() -> Result<Vec<Case>, Failure> {
    let texels = "sweep.light=texels";
    let no_skipping = "sweep.empty_space_skipping=false";
    Ok(vec![
        case("ball", &[])?,
        case("ball", &[OBLIQUE, FROM_ABOVE, "light.0.angular_radius=3", "light.0.elevation=50"])?,
        case("ball", &[OBLIQUE, no_skipping, "sweep.gradient=chain"])?,
        case(
            "ball",
            &["camera.azimuth=45", "camera.elevation=35.26", "camera.roll=30", texels, "light.0.angular_radius=2"],
        )?,
        case("ball", &["camera.zoom=5", "camera.elevation=-30", "sweep.sample_distance=0.5"])?,
        case("phantom", &[OBLIQUE, FROM_ABOVE])?,
        case("phantom", &["camera.projection=orthographic", FROM_ABOVE, no_skipping])?,
        case("phantom", &["light.0.shadows=false", "sweep.refraction=false", OBLIQUE])?,
        case("phantom/translucent", &[OBLIQUE, "camera.elevation=-60", texels, "sweep.sample_distance=2"])?,
        case("phantom", &[OBLIQUE, "sweep.light=forward", ISOSURFACES])?,
        case("phantom", &[FROM_ABOVE, "sweep.refraction=false", ISOSURFACES])?,
        case("head", &["camera.azimuth=120", FROM_ABOVE, "sweep.integrator=euler", texels, "sweep.intensity=paper"])?,
        case("head", &[OBLIQUE, texels])?.in_bytes()?,
        noisy(case("phantom", &[OBLIQUE, FROM_ABOVE])?)?,
        noisy(case("phantom", &[FROM_ABOVE, "sweep.refraction=false", "camera.field_of_view=70"])?)?,
        case("luneburg", &[OBLIQUE, FROM_ABOVE])?,
        case("luneburg", &[OBLIQUE, texels, no_skipping, "sweep.gradient=chain"])?,
        case("luneburg", &["camera.elevation=-50", "light.0.shadows=false", "sweep.refraction=false"])?,
        case("combustion/mixture", &[OBLIQUE, FROM_ABOVE])?,
        case("combustion/mixture", &[FROM_ABOVE, texels, no_skipping])?,
        two_of_integers([RESOLUTION, 37], &[OBLIQUE, FROM_ABOVE])?,
        two_of_integers([RESOLUTION, 37], &["sweep.gradient=chain", "camera.azimuth=-30"])?,
        reshaped([3, 61, 40], [0.5, 0.04, 0.05])?,
        reshaped([70, 2, 35], [0.03, 0.4, 0.05])?,
        reshaped([33, 47, 1], [0.05, 0.05, 0.4])?,
    ])
}

/// A case with noise in the air, as scans have it: no page has one value, and some are empty all the same.
fn noisy(mut case: Case) -> Result<Case, Failure> {
    let mut volume = case.volume().clone();
    let Voxels::U8(voxels) = &mut volume.voxels else { return Ok(case) };
    for (index, voxel) in voxels.make_mut().iter_mut().enumerate() {
        let noise = (index as u32).wrapping_mul(2_654_435_761) >> 29;
        *voxel = voxel.saturating_add(noise as u8);
    }
    case.assets.subject = volume.into();
    case.name.push_str(" with noise");
    Ok(case)
}

/// A head of 16 bits that bends light as a phantom of 8 bits and another grid says.
fn two_of_integers([shown, bending]: [u32; 2], settings: &[&str]) -> Result<Case, Failure> {
    let bends = "transfer.ior=[{value=0,ior=1},{value=200,ior=1.2}]";
    let mut both = Case::builtin("head", EDGE, Some(shown), &[settings, &[bends, TURNED_END]].concat())?;
    let bending = Case::builtin("phantom", EDGE, Some(bending), &[])?;
    let [shown, ior] = [&both, &bending].map(|case| Arc::new(case.volume().clone()));
    both.assets.subject = Subject::Volumes { shown, ior };
    both.name.push_str(" and a phantom");
    Ok(both)
}

/// A phantom's look on a grid of another shape.
fn reshaped(dimensions: [u32; 3], spacing: [f32; 3]) -> Result<Case, Failure> {
    let mut case = case("phantom", &[OBLIQUE, FROM_ABOVE])?;
    let count = dimensions.iter().product::<u32>();
    let voxels: Shared<u8> = (0..count).map(|index| (index.wrapping_mul(2_654_435_761) >> 24) as u8).collect();
    let volume = Volume::new("a block", dimensions, spacing, Voxels::U8(voxels)).map_err(Error::from)?;
    case.assets.subject = volume.into();
    case.name = format!("a block of {dimensions:?} voxels");
    Ok(case)
}

#[test]
fn a_streamed_frame_is_that_of_the_whole_volume() -> Result<(), Failure> {
    let mut cpu = CpuBackend::new(None)?;
    let mut gpu = exact_for_test();
    let mut most = 0;
    for case in cases()? {
        let name = case.name.clone();
        let (whole, _) = run(&case, &mut cpu)?;
        let case = case.streamed();
        let (streamed, times) = run(&case, &mut cpu)?;
        assert!(whole == streamed, "{name}: {} values differ", differing(&whole, &streamed));
        most = most.max(times);
        if let Some(gpu) = &mut gpu {
            let (found, _) = run(&case, gpu)?;
            assert!(whole == found, "{name}: {} values differ on the adapter", differing(&whole, &found));
        }
    }
    // Four pages lie one behind the other.
    assert!(most >= 5, "pages came {most} times at most: nothing was streamed");
    Ok(())
}

fn differing(a: &Bits, b: &Bits) -> usize {
    let count = |a: &[u32], b: &[u32]| a.iter().zip(b).filter(|(a, b)| a != b).count();
    count(&a.0, &b.0) + count(&a.1, &b.1)
}

/// A frame with at most `limit` bytes of voxels on the device, and the bytes of all its buffers.
fn within(case: &Case, limit: Option<u64>) -> Result<Vec<f32>, Error> {
    let mut cpu = CpuBackend::new(None)?;
    cpu.set_volume_limit(limit);
    let mut renderer = Renderer::new(Box::new(cpu), case.assets.clone());
    // The second frame finds what the first one left.
    renderer.render(&case.scene, OutputRequest::default(), &mut |_| true)?;
    let frame = renderer.render(&case.scene, OutputRequest::default(), &mut |_| true)?;
    Ok(frame.layers.into_iter().flat_map(|layer| layer.channels).flat_map(|channel| channel.data).collect())
}

#[test]
fn a_limit_streams_what_is_larger_and_says_when_it_is_too_small() -> Result<(), Failure> {
    let case = Case::builtin("phantom", EDGE, Some(128), &[OBLIQUE, "sweep.sample_distance=4", TURNED_END])?;
    let whole = case.volume().bytes() as u64;
    let expected = within(&case, None)?;
    assert_eq!(expected, within(&case, Some(whole))?);
    assert_eq!(expected, within(&case, Some(whole - 1))?);
    let failure = within(&case, Some(1 << 16)).expect_err("a plane needs more than that");
    let Error::Backend(BackendError::VolumeLimit { whole: told, needed, limit, .. }) = &failure else {
        panic!("another failure: {failure}");
    };
    assert_eq!((*told, *limit), (whole, 1 << 16));
    assert!(failure.to_string().contains(&needed.to_string()), "{failure}");
    // The limit that the error names is enough, and one byte less is not.
    assert_eq!(expected, within(&case, Some(*needed))?);
    assert!(within(&case, Some(needed - 1)).is_err());
    Ok(())
}

#[test]
fn a_limit_is_shared_by_two_volumes() -> Result<(), Failure> {
    // Planes across an oblique light cut through nearly all pages of small volumes.
    let case = two_of_integers([128, 112], &["sweep.light=texels"])?;
    let volumes = case.assets.subject.volumes().expect("it shows volumes");
    let voxels: usize = volumes.iter().map(|volume| volume.voxels.len()).sum();
    let whole = voxels as u64 * 4;
    let expected = within(&case, None)?;
    assert_eq!(expected, within(&case, Some(whole))?);
    let failure = within(&case, Some(1 << 14)).expect_err("a plane needs more than that");
    assert!(matches!(&failure, Error::Backend(error) if error.is_usage_error()), "a limit is a matter of use");
    let Error::Backend(BackendError::VolumeLimit { whole: told, needed, .. }) = &failure else {
        panic!("another failure: {failure}");
    };
    assert_eq!(*told, whole);
    assert!(*needed < whole, "{needed} of {whole} bytes");
    for limit in [*needed, (needed + whole) / 2] {
        let mut cpu = CpuBackend::new(None)?;
        cpu.set_volume_limit(Some(limit));
        let sweep = Sweep::prepare(&case.scene, &case.assets, case.request, &mut cpu)?;
        let mut voxels: Vec<Buffer> = Vec::new();
        for write in &sweep.passes.writes {
            if !voxels.contains(&write.buffer) {
                voxels.push(write.buffer.clone());
            }
        }
        assert_eq!(voxels.len(), 2, "both volumes are streamed");
        let mut taken = 0;
        for buffer in voxels {
            taken += cpu.bytes(&buffer)?;
        }
        assert!(taken <= limit, "{taken} of {limit} bytes");
        assert_eq!(expected, within(&case, Some(limit))?);
    }
    Ok(())
}

/// Pages of a small volume take more memory than the whole volume: the limit that the error names is enough.
#[test]
fn what_a_small_volume_needs_is_all_of_it_at_most() -> Result<(), Failure> {
    for case in [two_of_integers([24, 24], &[OBLIQUE])?, case("luneburg", &[OBLIQUE])?] {
        let failure = within(&case, Some(1000)).expect_err("a plane needs more than that");
        let Error::Backend(BackendError::VolumeLimit { needed, .. }) = failure else {
            panic!("another failure: {failure}");
        };
        within(&case, Some(needed))?;
    }
    Ok(())
}

/// A volume that stays in a file of raw voxels.
fn paged(volume: &Volume, role: &str, folder: &Path) -> Result<Arc<Volume>, Failure> {
    let (kind, bytes) = match &volume.voxels {
        Voxels::U8(voxels) => ("uint8", voxels.to_vec()),
        Voxels::U16(voxels) => ("uint16", voxels.iter().flat_map(|voxel| voxel.to_le_bytes()).collect()),
        Voxels::F32(voxels) => ("float32", voxels.iter().flat_map(|voxel| voxel.to_le_bytes()).collect()),
    };
    let [x, y, z] = volume.dimensions;
    let path = folder.join(format!("{role}_{x}x{y}x{z}_{kind}_le.raw"));
    std::fs::write(&path, bytes).map_err(|error| Failure::Setup(error.to_string()))?;
    let options = vitrum::io::OpenOptions { paged: true, ..Default::default() };
    let opened = vitrum::io::open(&path, &options).map_err(Error::from)?;
    assert!(opened.paged.is_some(), "{}: the file was read whole", path.display());
    Ok(Arc::new(Volume { voxels: opened.voxels, paged: opened.paged, ..volume.clone() }))
}

#[test]
fn a_volume_that_stays_in_its_file_gives_the_picture_of_the_whole_one() -> Result<(), Failure> {
    let folder = tempfile::tempdir().map_err(|error| Failure::Setup(error.to_string()))?;
    let mut cpu = CpuBackend::new(None)?;
    let mut gpu = exact_for_test();
    for case in [
        case("ball", &[OBLIQUE, FROM_ABOVE])?,
        noisy(case("phantom", &[OBLIQUE, FROM_ABOVE])?)?,
        case("head", &[OBLIQUE])?,
        case("combustion/mixture", &[OBLIQUE, FROM_ABOVE])?,
        reshaped([3, 61, 40], [0.5, 0.04, 0.05])?,
        reshaped([33, 47, 1], [0.05, 0.05, 0.4])?,
    ] {
        let name = case.name.clone();
        let (whole, _) = run(&case.clone().streamed(), &mut cpu)?;
        let of = |volume: &Volume, role| paged(volume, role, folder.path());
        let mut case = case;
        case.assets.subject = match &case.assets.subject {
            Subject::Volumes { shown, ior } => Subject::Volumes { shown: of(shown, "shown")?, ior: of(ior, "ior")? },
            _ => Subject::Volume(of(case.volume(), "shown")?),
        };
        // It is streamed by itself.
        let (found, _) = run(&case, &mut cpu)?;
        assert!(whole == found, "{name}: {} values differ", differing(&whole, &found));
        if let Some(gpu) = &mut gpu {
            let (found, _) = run(&case, gpu)?;
            assert!(whole == found, "{name}: {} values differ on the adapter", differing(&whole, &found));
        }
    }
    Ok(())
}
