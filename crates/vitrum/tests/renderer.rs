//! A renderer keeps unchanged data on the backend, and a failed frame leaves no buffer there.

mod common;

use common::{Watch, Watched, cpu, lost, small};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use vitrum::backend::{BackendError, Contents, PassList};
use vitrum::io::{Volume, Voxels};
use vitrum::scene::{Attachment, Light, Scene};
use vitrum::{Error, OutputRequest, Renderer, render_requested};

/// Counts the bytes that the host hands to a backend for buffers, without the uniform blocks of passes.
struct Uploads(Arc<AtomicU64>);

impl Watch for Uploads {
    fn creates(&mut self, contents: &Contents<'_>) -> Result<(), BackendError> {
        let bytes = if matches!(contents, Contents::Zeros(_)) { 0 } else { contents.bytes() };
        self.0.fetch_add(bytes, Ordering::Relaxed);
        Ok(())
    }

    fn writes(&mut self, words: usize) -> Result<(), BackendError> {
        self.0.fetch_add(4 * words as u64, Ordering::Relaxed);
        Ok(())
    }
}

#[test]
fn a_renderer_can_be_sent_to_another_thread() {
    fn is_send<T: Send>() {}
    is_send::<Renderer>();
}

#[test]
fn a_turn_of_the_camera_uploads_nothing_but_uniforms() {
    for name in ["ball", "glass", "combustion/mixture", "vase", "still-life"] {
        let (mut scene, assets) = small(name);
        // Light that is attached to the camera turns with it, and casts its shadow on a mesh anew.
        let light = &mut scene.light[0];
        light.attachment = Some(Attachment::World);
        (light.azimuth, light.elevation) = (scene.camera.azimuth + 20.0, 30.0);
        assert!(vitrum::check(&scene, &assets).is_ok(), "{name}: the light does not shine away from the camera");
        let uploaded = Arc::new(AtomicU64::new(0));
        let backend = Box::new(Watched::new(Uploads(Arc::clone(&uploaded))));
        let mut renderer = Renderer::new(backend, assets.clone());
        let request = OutputRequest { light: false, ..OutputRequest::default() };
        renderer.render(&scene, request, &mut |_| true).expect("a picture");
        assert!(uploaded.swap(0, Ordering::Relaxed) > 1000, "{name}: nothing was uploaded for the first frame");
        scene.camera.azimuth += 3.0;
        let frame = renderer.render(&scene, request, &mut |_| true).expect("a picture");
        let again = uploaded.swap(0, Ordering::Relaxed);
        assert_eq!(again, 0, "{name}: bytes were uploaded again");
        let fresh = render_requested(&scene, &assets, request, &mut cpu(), &mut |_| true).expect("a picture");
        assert!(frame.layers == fresh.layers, "{name}: the picture is another one");
    }
}

#[test]
fn exposures_of_several_lights_share_what_is_uploaded() {
    for name in ["ball", "vase"] {
        let (mut scene, assets) = small(name);
        let uploaded = Arc::new(AtomicU64::new(0));
        let mut renderer = Renderer::new(Box::new(Watched::new(Uploads(Arc::clone(&uploaded)))), assets);
        let request = OutputRequest { light: false, ..OutputRequest::default() };
        renderer.render(&scene, request, &mut |_| true).expect("a picture");
        let of_one = uploaded.swap(0, Ordering::Relaxed);
        let other = Light { azimuth: 20.0, ..scene.light[0].clone() };
        scene.light.push(other);
        renderer.render(&scene, request, &mut |_| true).expect("a picture");
        let of_another = uploaded.swap(0, Ordering::Relaxed);
        // Through a mesh each light has a shadow map of its own; in a volume the table of the bricks in which its light is kept.
        let tables = of_one / 50;
        assert!(of_one > 1000 && (of_another < tables || name == "vase"), "{name}: {of_one}, then {of_another} bytes");
    }
}

#[test]
fn the_light_of_several_sources_stays_while_the_camera_turns() {
    let (mut scene, assets) = small("ball");
    scene.light[0].attachment = Some(Attachment::World);
    (scene.light[0].azimuth, scene.light[0].elevation) = (20.0, 30.0);
    let other = Light { azimuth: -40.0, ..scene.light[0].clone() };
    scene.light.push(other);
    let mut renderer = Renderer::new(Box::new(cpu()), assets.clone());
    for light in [false, true] {
        let request = OutputRequest { light, ..OutputRequest::default() };
        renderer.render(&scene, request, &mut |_| true).expect("a picture");
        scene.camera.azimuth += 3.0;
        let frame = renderer.render(&scene, request, &mut |_| true).expect("a picture");
        let carries = |name: &str| name.starts_with("sweep_advance_nodes");
        let passes =
            frame.statistics.kernels.iter().filter(|kernel| carries(kernel.kernel)).map(|kernel| kernel.passes);
        // The light's own picture needs nodes, which the other light has overwritten.
        assert_eq!(passes.sum::<u32>() > 0, light, "with the light's picture: {light}");
        let fresh = render_requested(&scene, &assets, request, &mut cpu(), &mut |_| true).expect("a picture");
        assert!(frame.layers == fresh.layers, "with the light's picture: {light}");
    }
}

/// Fails the call with this number, counting each buffer, each pass and each read.
struct FailsAt {
    calls: u64,
    at: u64,
}

impl FailsAt {
    /// The number of calls, of `count`, before the one that fails, if the failing one is among them.
    fn count(&mut self, count: u64) -> Option<u64> {
        let before = self.at.checked_sub(self.calls).filter(|&before| before < count);
        self.calls += count;
        before
    }

    fn one(&mut self) -> Result<(), BackendError> {
        self.count(1).map_or(Ok(()), |_| Err(lost()))
    }
}

impl Watch for FailsAt {
    fn creates(&mut self, _contents: &Contents<'_>) -> Result<(), BackendError> {
        self.one()
    }

    fn writes(&mut self, _words: usize) -> Result<(), BackendError> {
        self.one()
    }

    fn runs(&mut self, passes: &PassList) -> Result<(), (usize, BackendError)> {
        let before = self.count(passes.passes.len() as u64);
        before.map_or(Ok(()), |before| Err((before as usize, lost())))
    }

    fn reads(&mut self) -> Result<(), BackendError> {
        self.one()
    }
}

#[test]
fn a_frame_that_fails_anywhere_leaves_no_buffer() {
    for name in ["ball", "combustion/mixture", "vase"] {
        let (scene, assets) = small(name);
        let mut failures = 0;
        for at in 0.. {
            let mut backend = Watched::new(FailsAt { calls: 0, at });
            let outcome = render_requested(&scene, &assets, OutputRequest::default(), &mut backend, &mut |_| true);
            assert_eq!(backend.cpu.buffer_bytes(), 0, "{name}: call {at} left buffers behind");
            match outcome {
                Ok(_) => break,
                Err(error) => assert!(matches!(error, Error::Backend(BackendError::DeviceLost { .. })), "{error}"),
            }
            failures += 1;
        }
        assert!(failures > 20, "{name}: only {failures} calls were failed");
    }
}

#[test]
fn data_in_memory_renders_without_a_file_name() {
    let voxels = Voxels::from((0..16u32.pow(3)).map(|index| (index % 251) as f32).collect::<Vec<f32>>());
    let volume = Volume::new("made", [16; 3], [1.0; 3], voxels).expect("a volume");
    let mut scene = Scene::default();
    (scene.film.width, scene.film.height) = (16, 16);
    let mut renderer = Renderer::new(Box::new(cpu()), volume);
    let frame = renderer.render(&scene, OutputRequest::default(), &mut |_| true).expect("a picture");
    let opacity = frame.channel("opacity", "Y").expect("it is listed");
    assert!(opacity.iter().any(|&opacity| opacity > 0.1), "nothing is to be seen");
}
