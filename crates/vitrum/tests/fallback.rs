//! A device that fails in the middle of a frame: an error of its own kind, or the same picture from another backend.

mod common;

use common::{Watch, Watched, cpu, lost, small};
use std::sync::{Arc, Mutex};
use vitrum::backend::{Backend, BackendError, PassList};
use vitrum::{Error, Frame, OutputRequest, Renderer, render};

/// A card that runs so many frames, then half of one, and fails.
struct Failing {
    frames: usize,
    failure: fn() -> BackendError,
}

impl Watch for Failing {
    fn runs(&mut self, passes: &PassList) -> Result<(), (usize, BackendError)> {
        if self.frames > 0 {
            self.frames -= 1;
            return Ok(());
        }
        Err((passes.passes.len() / 2, (self.failure)()))
    }
}

fn card(frames: usize, failure: fn() -> BackendError) -> Box<dyn Backend> {
    Box::new(Watched::new(Failing { frames, failure }))
}

fn go_on(_: vitrum::Progress) -> bool {
    true
}

fn color(frame: &Frame) -> &[f32] {
    frame.channel("color", "R").expect("every frame has a color")
}

#[test]
fn a_lost_device_is_an_error_of_the_device() {
    let (scene, assets) = small("ball");
    let mut renderer = Renderer::new(card(0, lost), assets);
    let error = renderer.render(&scene, OutputRequest::default(), &mut go_on).expect_err("the device is lost");
    assert!(matches!(&error, Error::Backend(BackendError::DeviceLost { .. })), "{error:?}");
}

#[test]
fn another_backend_makes_the_same_picture() {
    let (scene, assets) = small("ball");
    let expected = render(&scene, &assets, &mut cpu(), &mut go_on).expect("a picture");
    for failure in [lost, || BackendError::OutOfMemory { adapter: "a card".to_owned(), what: "light".to_owned() }] {
        let told = Arc::new(Mutex::new(Vec::new()));
        let tells = Arc::clone(&told);
        let fallback = Box::new(move |failure: &BackendError| {
            tells.lock().expect("nobody panics").push(failure.to_string());
            Ok(Box::new(cpu()) as Box<dyn Backend>)
        });
        // A frame is a run, and its light as an output another one.
        let mut renderer = Renderer::new(card(2, failure), assets.clone()).with_fallback(fallback);
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
    let (scene, assets) = small("ball");
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
    let (scene, assets) = small("ball");
    let never = |_: &BackendError| -> Result<Box<dyn Backend>, BackendError> { panic!("no device failed") };
    let mut renderer = Renderer::new(card(9, lost), assets).with_fallback(Box::new(never));
    let error = renderer.render(&scene, OutputRequest::default(), &mut |_| false).expect_err("cancelled");
    assert!(error.is_cancelled());
    let mut wrong = scene.clone();
    wrong.film.width = 0;
    renderer.render(&wrong, OutputRequest::default(), &mut go_on).expect_err("no pixels");
    renderer.render(&scene, OutputRequest::default(), &mut go_on).expect("the renderer goes on");
}
