//! The rendering thread: the newest view wins, pictures get better, and the last one is the scene's own.

use std::sync::Arc;
use vitrum::backend::Choice;
use vitrum_viewer::document::Document;
use vitrum_viewer::worker::{DeviceOptions, Reply, View, Worker};

fn worker() -> Worker {
    let options = DeviceOptions { threads: Some(1), ..DeviceOptions::default() };
    Worker::start(options, Arc::new(|| ())).expect("a thread")
}

fn view(document: &Document, number: u64, moving: bool) -> View {
    let (scene, data) = (document.scene.clone(), document.data.clone());
    View { number, scene, data, moving, backend: Choice::Cpu }
}

fn ball(size: [u32; 2]) -> Document {
    Document::open("builtin:ball", Some(size)).expect("the ball")
}

#[test]
fn a_view_at_rest_ends_with_its_whole_picture() {
    let document = ball([48, 36]);
    let worker = worker();
    worker.show(view(&document, 1, false));
    loop {
        match worker.wait().expect("the thread lives") {
            Reply::Picture { number: 1, shown, complete: true, .. } => {
                assert_eq!((shown.size, shown.pixels.len()), ([48, 36], 48 * 36));
                return;
            }
            Reply::Picture { complete: false, .. } => {}
            other => panic!("{other:?}"),
        }
    }
}

#[test]
fn the_newest_view_wins() {
    let mut document = ball([300, 300]);
    let worker = worker();
    for number in 1..=40 {
        document.scene.camera.azimuth += 1.0;
        worker.show(view(&document, number, false));
    }
    let mut pictures = Vec::new();
    loop {
        match worker.wait().expect("the thread lives") {
            Reply::Picture { number, complete, .. } => {
                pictures.push(number);
                if number == 40 && complete {
                    break;
                }
            }
            other => panic!("{other:?}"),
        }
    }
    assert!(pictures.len() < 20, "each view was rendered, though newer ones waited: {pictures:?}");
    assert!(pictures.is_sorted());
}

#[test]
fn a_scene_without_a_picture_says_why_and_the_next_one_is_shown() {
    let mut document = ball([32, 24]);
    let worker = worker();
    let good = view(&document, 2, true);
    document.scene.camera.zoom = -1.0;
    worker.show(view(&document, 1, true));
    let Some(Reply::Failed { number: 1, trouble }) = worker.wait() else { panic!("it cannot be rendered") };
    assert!(trouble.message.contains("zoom") && !trouble.help.is_empty(), "{trouble:?}");
    worker.show(good);
    assert!(matches!(worker.wait(), Some(Reply::Picture { number: 2, .. })));
}
