//! A device that fails in the middle of a frame: an error of its own kind, or the same picture from another backend.

use std::cell::RefCell;
use std::path::Path;
use std::rc::Rc;
use vitrum::backend::{Backend, BackendError, Buffer, CpuBackend, PassList};
use vitrum::scene::Scene;
use vitrum::{Error, Frame, Inputs, Session, Wanted, builtin, render};

/// The CPU in the role of a card that runs so many frames, then half of one, and is lost.
struct Failing {
    cpu: CpuBackend,
    frames: usize,
    failure: fn() -> BackendError,
    /// Buffers that are in use.
    buffers: Rc<RefCell<i64>>,
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

    fn create(&mut self, label: &str, contents: &[u8]) -> Result<Buffer, BackendError> {
        *self.buffers.borrow_mut() += 1;
        self.cpu.create(label, contents)
    }

    fn create_zeroed(&mut self, label: &str, bytes: u64) -> Result<Buffer, BackendError> {
        *self.buffers.borrow_mut() += 1;
        self.cpu.create_zeroed(label, bytes)
    }

    fn overwrite(
        &mut self,
        buffer: Buffer,
        words: usize,
        fill: &mut (dyn FnMut(&mut [u32]) + Send),
    ) -> Result<(), BackendError> {
        self.cpu.overwrite(buffer, words, fill)
    }

    fn clear(&mut self, buffer: Buffer) -> Result<(), BackendError> {
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

    fn read(&mut self, buffer: Buffer) -> Result<Vec<u8>, BackendError> {
        self.cpu.read(buffer)
    }

    fn free(&mut self, buffer: Buffer) {
        *self.buffers.borrow_mut() -= 1;
        self.cpu.free(buffer);
    }

    fn device_bytes(&self) -> Option<u64> {
        Some(0)
    }
}

fn cpu() -> CpuBackend {
    CpuBackend::new(Some(1)).expect("a thread")
}

fn card(frames: usize, failure: fn() -> BackendError) -> (Box<dyn Backend>, Rc<RefCell<i64>>) {
    let buffers = Rc::new(RefCell::new(0));
    (Box::new(Failing { cpu: cpu(), frames, failure, buffers: buffers.clone() }), buffers)
}

/// A ball, small enough to be quick in a debugger.
fn ball() -> (Scene, Inputs) {
    let mut scene = builtin::scene("ball").expect("it is built in");
    scene.volume.resolution = Some(16);
    (scene.film.width, scene.film.height) = (24, 16);
    let inputs = Inputs::load(&scene, Path::new("")).expect("it needs no file");
    (scene, inputs)
}

fn go_on(_: vitrum::Progress) -> bool {
    true
}

fn color(frame: &Frame) -> &[f32] {
    frame.channel("color", "R").expect("every frame has a color")
}

#[test]
fn a_lost_device_is_an_error_of_the_device() {
    let (scene, inputs) = ball();
    let (card, buffers) = card(0, lost);
    let mut session = Session::owning(&inputs, card, None).expect("it fails later");
    let error = session.render(&scene, Wanted::default(), &mut go_on).expect_err("the device is lost");
    assert!(matches!(&error, Error::Backend(BackendError::DeviceLost { .. })), "{error:?}");
    assert_eq!(error.exit_code(), 4);
    assert!(error.help().is_some_and(|help| help.contains("--backend cpu")));
    drop(session);
    assert_eq!(*buffers.borrow(), 0, "buffers were left on the device");
}

#[test]
fn another_backend_makes_the_same_picture() {
    let (scene, inputs) = ball();
    let expected = render(&scene, &inputs, &mut cpu(), &mut go_on).expect("a picture");
    for failure in [lost, || BackendError::OutOfMemory { adapter: "a card".to_owned(), what: "light".to_owned() }] {
        let told = RefCell::new(Vec::new());
        let (card, buffers) = card(1, failure);
        let fallback = Box::new(|failure: &BackendError| {
            told.borrow_mut().push(failure.to_string());
            Ok(Box::new(cpu()) as Box<dyn Backend>)
        });
        let mut session = Session::owning(&inputs, card, Some(fallback)).expect("it fails later");
        for backend in ["gpu", "cpu", "cpu"] {
            let frame = session.render(&scene, Wanted::default(), &mut go_on).expect("a picture");
            assert_eq!(frame.statistics.backend, backend);
            assert_eq!(color(&frame), color(&expected));
        }
        drop(session);
        assert_eq!(*told.borrow(), [failure().to_string()], "the user is told once");
        assert_eq!(*buffers.borrow(), 0, "buffers were left on the device");
    }
}

#[test]
fn a_fallback_that_fails_too_is_the_error() {
    let (scene, inputs) = ball();
    let none = || BackendError::Threads { threads: 9, reason: "there are none".to_owned() };
    let mut session = Session::owning(&inputs, card(0, lost).0, Some(Box::new(move |_| Err(none())))).expect("later");
    let error = session.render(&scene, Wanted::default(), &mut go_on).expect_err("both failed");
    assert!(matches!(error, Error::Backend(BackendError::Threads { .. })), "{error:?}");
    // And there is no third one.
    let error = session.render(&scene, Wanted::default(), &mut go_on).expect_err("the card is still lost");
    assert!(matches!(error, Error::Backend(BackendError::DeviceLost { .. })), "{error:?}");
}

#[test]
fn what_is_not_the_device_stays_an_error() {
    let (scene, inputs) = ball();
    let never = |_: &BackendError| -> Result<Box<dyn Backend>, BackendError> { panic!("no device failed") };
    let mut session = Session::owning(&inputs, card(9, lost).0, Some(Box::new(never))).expect("it works");
    let error = session.render(&scene, Wanted::default(), &mut |_| false).expect_err("cancelled");
    assert!(error.is_cancelled());
    let mut wrong = scene.clone();
    wrong.film.width = 0;
    session.render(&wrong, Wanted::default(), &mut go_on).expect_err("no pixels");
    session.render(&scene, Wanted::default(), &mut go_on).expect("the session goes on");
}
