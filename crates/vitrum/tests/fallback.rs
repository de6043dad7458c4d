//! A device that fails in the middle of a frame: an error of its own kind, or the same picture from another backend.

use std::ops::Range;
use std::path::Path;
use std::sync::{Arc, Mutex};
use vitrum::backend::{Backend, BackendError, Buffer, Contents, CpuBackend, PassList};
use vitrum::scene::Scene;
use vitrum::{Assets, Error, Frame, OutputRequest, Renderer, builtin, render};

/// The CPU in the role of a card that runs so many frames, then half of one, and is lost.
struct Failing {
    cpu: CpuBackend,
    frames: usize,
    failure: fn() -> BackendError,
}

fn lost() -> BackendError {
    BackendError::DeviceLost { adapter: "a card".to_owned(), reason: "the driver was reset".to_owned() }
}

impl Backend for Failing {
    fn name(&self) -> &'static str {
        "gpu"
    }

    fn adapter(&self) -> String {
        "a card".to_owned()
    }

    fn largest_buffer(&self) -> u64 {
        self.cpu.largest_buffer()
    }

    fn create(&mut self, label: &str, contents: Contents<'_>) -> Result<Buffer, BackendError> {
        self.cpu.create(label, contents)
    }

    fn write(
        &mut self,
        buffer: &Buffer,
        words: usize,
        fill: &mut (dyn FnMut(&mut [u32]) + Send),
    ) -> Result<(), BackendError> {
        self.cpu.write(buffer, words, fill)
    }

    fn clear(&mut self, buffer: &Buffer) -> Result<(), BackendError> {
        self.cpu.clear(buffer)
    }

    fn run(&mut self, passes: &PassList, progress: &mut dyn FnMut(usize) -> bool) -> Result<(), BackendError> {
        if self.frames > 0 {
            self.frames -= 1;
            return self.cpu.run(passes, progress);
        }
        let half = passes.passes.len() / 2;
        let stopped = self.cpu.run(passes, &mut |done| done < half && progress(done));
        assert!(matches!(stopped, Err(BackendError::Cancelled)), "half a frame was run: {stopped:?}");
        Err((self.failure)())
    }

    fn read(
        &mut self,
        buffer: &Buffer,
        range: Range<u64>,
        see: &mut (dyn FnMut(&[u8]) + Send),
    ) -> Result<(), BackendError> {
        self.cpu.read(buffer, range, see)
    }

    fn bytes(&self, buffer: &Buffer) -> Result<u64, BackendError> {
        self.cpu.bytes(buffer)
    }

    fn device_bytes(&self) -> Option<u64> {
        Some(0)
    }
}

fn cpu() -> CpuBackend {
    CpuBackend::new(Some(1)).expect("a thread")
}

fn card(frames: usize, failure: fn() -> BackendError) -> Box<dyn Backend> {
    Box::new(Failing { cpu: cpu(), frames, failure })
}

/// A ball, small enough to be quick in a debugger.
fn ball() -> (Scene, Assets) {
    let mut scene = builtin::scene("ball").expect("it is built in");
    scene.volume.resolution = Some(16);
    (scene.film.width, scene.film.height) = (24, 16);
    let assets = Assets::load(&scene, Path::new("")).expect("it needs no file");
    (scene, assets)
}

fn go_on(_: vitrum::Progress) -> bool {
    true
}

fn color(frame: &Frame) -> &[f32] {
    frame.channel("color", "R").expect("every frame has a color")
}

#[test]
fn a_lost_device_is_an_error_of_the_device() {
    let (scene, assets) = ball();
    let mut renderer = Renderer::new(card(0, lost), assets);
    let error = renderer.render(&scene, OutputRequest::default(), &mut go_on).expect_err("the device is lost");
    assert!(matches!(&error, Error::Backend(BackendError::DeviceLost { .. })), "{error:?}");
    assert_eq!(error.exit_code(), 4);
    assert!(error.help().is_some_and(|help| help.contains("--backend cpu")));
}

#[test]
fn another_backend_makes_the_same_picture() {
    let (scene, assets) = ball();
    let expected = render(&scene, &assets, &mut cpu(), &mut go_on).expect("a picture");
    for failure in [lost, || BackendError::OutOfMemory { adapter: "a card".to_owned(), what: "light".to_owned() }] {
        let told = Arc::new(Mutex::new(Vec::new()));
        let tells = Arc::clone(&told);
        let fallback = Box::new(move |failure: &BackendError| {
            tells.lock().expect("nobody panics").push(failure.to_string());
            Ok(Box::new(cpu()) as Box<dyn Backend>)
        });
        let mut renderer = Renderer::new(card(1, failure), assets.clone()).with_fallback(fallback);
        for backend in ["gpu", "cpu", "cpu"] {
            let frame = renderer.render(&scene, OutputRequest::default(), &mut go_on).expect("a picture");
            assert_eq!(frame.statistics.backend, backend);
            assert_eq!(color(&frame), color(&expected));
        }
        assert_eq!(*told.lock().expect("nobody panics"), [failure().to_string()], "the user is told once");
    }
}

#[test]
fn a_fallback_that_fails_too_is_the_error() {
    let (scene, assets) = ball();
    let none = || BackendError::Threads { threads: 9, reason: "there are none".to_owned() };
    let mut renderer = Renderer::new(card(0, lost), assets).with_fallback(Box::new(move |_| Err(none())));
    let error = renderer.render(&scene, OutputRequest::default(), &mut go_on).expect_err("both failed");
    assert!(matches!(error, Error::Backend(BackendError::Threads { .. })), "{error:?}");
    // And there is no third one.
    let error = renderer.render(&scene, OutputRequest::default(), &mut go_on).expect_err("the card is still lost");
    assert!(matches!(error, Error::Backend(BackendError::DeviceLost { .. })), "{error:?}");
}

#[test]
fn what_is_not_the_device_stays_an_error() {
    let (scene, assets) = ball();
    let never = |_: &BackendError| -> Result<Box<dyn Backend>, BackendError> { panic!("no device failed") };
    let mut renderer = Renderer::new(card(9, lost), assets).with_fallback(Box::new(never));
    let error = renderer.render(&scene, OutputRequest::default(), &mut |_| false).expect_err("cancelled");
    assert!(error.is_cancelled());
    let mut wrong = scene.clone();
    wrong.film.width = 0;
    renderer.render(&wrong, OutputRequest::default(), &mut go_on).expect_err("no pixels");
    renderer.render(&scene, OutputRequest::default(), &mut go_on).expect("the renderer goes on");
}
