//! The tables of the beams' paper (Hu et al. 2010), taken anew: Table 1, times of stages; Table 2, the volume caustics' time by the sizes of the
//! caustics buffer and of the picture; and frame rates with one to four lights (§6.3).
//!
//! The paper's scenes are not at hand. The built-in ring and gem are of its kind, and the statue, an angel of glass, stands for its Buddha. The paper's
//! times are of a GeForce GTX 280, by Table 1 for a caustics buffer of 1024 × 1024 rays.

use vitrum::Frame;
use vitrum::backend::Backend;
use vitrum::method::{Cache, Job};
use vitrum::scene::Light;

use super::stages::Stage;
use crate::Failure;
use crate::bench::median;
use crate::case::Case;
use crate::table;

/// A scene of the tables.
pub struct Subject {
    /// The built-in scene.
    pub scene: &'static str,
    /// The paper's milliseconds of airlight with shadows, surface caustics, volume caustics and composition, in its Table 1.
    paper_ms: Option<[f64; 4]>,
    /// Milliseconds of volume caustics that counts of fragments and rays let a fast graphics card (H100) take for a picture of 1024 × 1024 pixels, with 128² and with
    /// 256² rays: 100 G fragments and 1 G rays a second, and 0.2 ms of dispatches.
    floor_ms: Option<[f64; 2]>,
}

/// The scenes of Table 1, then two that the paper has no times of.
#[rustfmt::skip]
pub const SUBJECTS: [Subject; 5] = [
    Subject { scene: "ring", paper_ms: Some([4.5, 15.0, 10.0, 4.0]), floor_ms: Some([0.65, 2.5]) },
    Subject { scene: "statue", paper_ms: Some([5.0, 13.0, 9.0, 4.0]), floor_ms: Some([0.5, 1.9]) },
    Subject { scene: "gem", paper_ms: Some([5.0, 28.0, 21.0, 4.0]), floor_ms: Some([0.6, 2.0]) },
    Subject { scene: "ball-in-fog", paper_ms: None, floor_ms: Some([0.5, 1.9]) },
    Subject { scene: "ocean", paper_ms: None, floor_ms: None },
];

/// The rays of the floors.
const FLOOR_RAYS: [u32; 2] = [128, 256];
/// The picture's edge of the floors.
const FLOOR_EDGE: u32 = 1024;

/// Edges of caustics buffers and of pictures of Table 2.
const EDGES: [u32; 3] = [256, 512, 1024];

/// Frames a second of Table 2: by the rays along an edge, then the pixels along an edge. It is of the volume caustics alone, with the Buddha.
const TABLE_2: [[f64; 3]; 3] = [[193.0, 173.0, 171.0], [163.0, 140.0, 115.0], [93.0, 74.0, 62.0]];

/// The scene of Table 2.
const BUDDHA: &str = "statue";

/// Frames a second with one to four lights (§6.3).
const LIGHTS: [f64; 4] = [37.0, 21.5, 9.25, 2.9];

/// The rays along an edge of references, at most: the most that a scene may have.
const MOST_RAYS: u32 = 1024;

/// The part of the brightest pixel below which a pixel counts for no error.
const DARK: f64 = 0.01;

/// The sizes of a run.
#[derive(Debug, Clone)]
pub struct Sizes {
    /// Pixels along an edge.
    pub edges: Vec<u32>,
    /// Rays along an edge of the caustics buffer.
    pub rays: Vec<u32>,
    /// Timed frames.
    pub frames: usize,
}

impl Sizes {
    /// Rays of the reference of errors.
    fn reference(&self) -> u32 {
        (4 * self.rays.iter().copied().max().unwrap_or(MOST_RAYS)).min(MOST_RAYS)
    }
}

/// The times of a scene with one buffer and picture.
#[derive(Debug, Clone)]
struct Timing {
    frame_ms: f64,
    stages: [f64; 5],
    caustics: Vec<f32>,
}

impl Timing {
    /// Times `frames` frames after one that is not counted; data that does not change stays on the backend.
    fn new(case: &Case, backend: &mut dyn Backend, frames: usize) -> Result<Self, Failure> {
        let job = Job { scene: &case.scene, assets: &case.assets, request: case.request, chosen: None };
        let mut cache = Cache::default();
        let mut frame = || vitrum::frame(&job, &mut cache, backend, &mut |_| true);
        let caustics = caustics(&frame()?);
        let (mut frame_ms, mut stages) = (Vec::new(), <[Vec<f64>; 5]>::default());
        for _ in 0..frames {
            let statistics = frame()?.statistics;
            frame_ms.extend(&statistics.frame_ms);
            for (times, ms) in stages.iter_mut().zip(Stage::times(&statistics.kernels)) {
                times.push(ms);
            }
        }
        let middle = |times: &Vec<f64>| median(times).unwrap_or(f64::NAN);
        Ok(Self { frame_ms: middle(&frame_ms), stages: stages.each_ref().map(middle), caustics })
    }

    /// Milliseconds of what the paper calls volume caustics: rays of light, and beams on the picture.
    fn volume_caustics(&self) -> f64 {
        self.stages[0] + self.stages[1]
    }
}

/// Red, green and blue of the caustics of a frame.
fn caustics(frame: &Frame) -> Vec<f32> {
    ["R", "G", "B"].map(|channel| frame.channel("caustics", channel).unwrap_or_default()).concat()
}

/// The root of the mean square difference from a reference, in parts of its brightest value, over the values above [`DARK`].
fn error(found: &[f32], reference: &[f32]) -> f64 {
    let peak = f64::from(reference.iter().copied().fold(0.0, f32::max));
    let bright = found.iter().zip(reference).filter(|(_, value)| f64::from(**value) > DARK * peak);
    let (sum, count) = bright.fold((0.0, 0.0), |(sum, count), (found, reference)| {
        (sum + (f64::from(*found) - f64::from(*reference)).powi(2), count + 1.0)
    });
    (sum / count).sqrt() / peak
}

fn case(subject: &Subject, edge: u32, rays: u32, settings: &[&str]) -> Result<Case, Failure> {
    let rays = format!("beams.rays={rays}");
    Case::builtin(subject.scene, edge, None, &[&[rays.as_str()], settings].concat())
}

fn squared(edge: u32) -> String {
    format!("{edge} × {edge}")
}

fn digits(value: Option<f64>, digits: usize) -> String {
    value.map_or("–".to_owned(), |value| format!("{value:.digits$}"))
}

/// Table 1: a row for each buffer and picture of each subject.
///
/// # Errors
/// If the backend fails.
pub fn stages(subjects: &[&Subject], sizes: &Sizes, backend: &mut dyn Backend) -> Result<String, Failure> {
    let mut rows = Vec::new();
    for subject in subjects {
        for &edge in &sizes.edges {
            eprintln!("{} at {edge} x {edge}: reference", subject.scene);
            let fine = case(subject, edge, sizes.reference(), &["beams.pyramid=false"])?;
            let reference = Timing::new(&fine, backend, 0)?.caustics;
            for &rays in &sizes.rays {
                eprintln!("{} at {edge} x {edge}: {rays} x {rays} rays", subject.scene);
                let timing = Timing::new(&case(subject, edge, rays, &[])?, backend, sizes.frames)?;
                let off = (rays < sizes.reference()).then(|| 100.0 * error(&timing.caustics, &reference));
                rows.push(row(subject, [rays, edge], &timing, off));
            }
        }
    }
    let [trace, scatter, view, surfaces, compose] = Stage::ALL.map(|stage| format!("{} ms", stage.name()));
    let named = |names: [&str; 3]| names.map(str::to_owned);
    let [scene, rays, pixels] = named(["scene", "rays", "pixels"]);
    let [frame, per_ray, rms] = named(["frame ms", "trace ns/ray", "rms error, % of the peak"]);
    let [paper, all, floor] = named(["paper: VC ms", "paper: AL + SC + VC + Comp. ms", "VC floor ms"]);
    let header = [scene, rays, pixels, trace, scatter, view, surfaces, compose, frame, per_ray, rms, paper, all, floor];
    Ok(table::aligned(header, rows))
}

fn row(subject: &Subject, [rays, edge]: [u32; 2], timing: &Timing, off: Option<f64>) -> [String; 14] {
    let [trace, scatter, view, surfaces, compose] = timing.stages.map(|ms| format!("{ms:.1}"));
    let floor = FLOOR_RAYS.iter().position(|other| *other == rays).filter(|_| edge == FLOOR_EDGE);
    [
        subject.scene.to_owned(),
        squared(rays),
        squared(edge),
        trace,
        scatter,
        view,
        surfaces,
        compose,
        format!("{:.1}", timing.frame_ms),
        format!("{:.0}", timing.stages[0] * 1e6 / f64::from(rays).powi(2)),
        digits(off, 2),
        digits(subject.paper_ms.map(|ms| ms[2]), 0),
        digits(subject.paper_ms.map(|ms| ms.iter().sum()), 1),
        digits(floor.and_then(|at| subject.floor_ms.map(|ms| ms[at])), 2),
    ]
}

/// Table 2: milliseconds of volume caustics, for the sizes of the run.
///
/// # Errors
/// If the backend fails.
pub fn sizes(sizes: &Sizes, backend: &mut dyn Backend) -> Result<String, Failure> {
    let subject = SUBJECTS.iter().find(|subject| subject.scene == BUDDHA);
    let subject = subject.ok_or_else(|| Failure::Setup(format!("there is no {BUDDHA}")))?;
    let mut rows = Vec::new();
    for &rays in &sizes.rays {
        for &edge in &sizes.edges {
            eprintln!("{BUDDHA} at {edge} x {edge}: {rays} x {rays} rays");
            let timing = Timing::new(&case(subject, edge, rays, &[])?, backend, sizes.frames)?;
            let place = |edge: u32| EDGES.iter().position(|other| *other == edge);
            let paper = place(rays).zip(place(edge)).map(|(row, column)| 1e3 / TABLE_2[row][column]);
            let ms = timing.volume_caustics();
            rows.push([
                squared(rays),
                squared(edge),
                format!("{ms:.1}"),
                digits(paper, 1),
                digits(paper.map(|paper| paper / ms), 2),
            ]);
        }
    }
    let header = ["rays", "pixels", "VC ms", "paper: VC ms", "paper over VC"].map(str::to_owned);
    Ok(table::aligned(header, rows))
}

/// Frame times with one to four lights, which are the scene's own turned about the vertical axis by quarters, with the most rays and pixels of the run.
///
/// # Errors
/// If the backend fails.
pub fn lights(subjects: &[&Subject], sizes: &Sizes, backend: &mut dyn Backend) -> Result<String, Failure> {
    let most = |of: &[u32]| of.iter().copied().max().unwrap_or(FLOOR_EDGE);
    let (edge, rays) = (most(&sizes.edges), most(&sizes.rays));
    let mut rows = Vec::new();
    for subject in subjects {
        let mut one = None;
        for (count, fps) in (1..).zip(LIGHTS) {
            eprintln!("{} at {edge} x {edge}: {count} lights", subject.scene);
            let mut case = case(subject, edge, rays, &[])?;
            let first = case.scene.light[0].clone();
            case.scene.light = (0..count).map(|quarters| turned(&first, quarters)).collect();
            let timing = Timing::new(&case, backend, sizes.frames)?;
            let one = *one.get_or_insert(timing.frame_ms);
            rows.push([
                subject.scene.to_owned(),
                squared(rays),
                squared(edge),
                count.to_string(),
                format!("{:.1}", timing.frame_ms),
                format!("{:.2}", timing.frame_ms / one),
                format!("{:.0}", 1e3 / fps),
                format!("{:.2}", LIGHTS[0] / fps),
            ]);
        }
    }
    let header =
        ["scene", "rays", "pixels", "lights", "frame ms", "over one light", "paper: frame ms", "paper: over one light"];
    Ok(table::aligned(header.map(str::to_owned), rows))
}

/// A light in the world, turned about the z axis by quarters of a turn.
fn turned(light: &Light, quarters: u32) -> Light {
    let turn = |[x, y, z]: [f32; 3]| [-y, x, z];
    let by = |vector: [f32; 3]| (0..quarters).fold(vector, |vector, _| turn(vector));
    Light { position: light.position.map(by), direction: light.direction.map(by), ..light.clone() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use vitrum::backend::CpuBackend;

    #[test]
    fn tables_have_a_row_for_each_size() {
        let mut backend = CpuBackend::new(None).expect("threads start");
        let run = Sizes { edges: vec![16, 24], rays: vec![4, 8], frames: 1 };
        let lines = |text: &str| text.lines().count() - 2;
        let subjects = [&SUBJECTS[0], &SUBJECTS[3]];
        let text = stages(&subjects, &run, &mut backend).unwrap();
        assert!(lines(&text) == 8 && text.contains("| ball-in-fog | 8 × 8 ") && text.contains("| 33.5 "), "{text}");
        assert_eq!(lines(&sizes(&run, &mut backend).unwrap()), 4);
        let text = lights(&subjects[1..], &run, &mut backend).unwrap();
        assert!(lines(&text) == 4 && text.contains("| 12.76 "), "{text}");
    }

    #[test]
    fn every_subject_is_a_scene_of_beams_with_a_light_in_the_world() {
        for subject in &SUBJECTS {
            let scene = vitrum::builtin::scene(subject.scene).expect(subject.scene);
            let light = &scene.light[0];
            assert!(
                scene.medium.is_some() && (light.position.is_some() || light.direction.is_some()),
                "{}",
                subject.scene
            );
        }
        let light = Light { position: Some([1.0, 2.0, 3.0]), ..Light::default() };
        assert_eq!(turned(&light, 1).position, Some([-2.0, 1.0, 3.0]));
        assert_eq!(turned(&light, 4).position, light.position);
    }

    #[test]
    fn errors_are_shares_of_the_brightest_value() {
        assert_eq!(error(&[1.0, 2.0, 0.0], &[1.0, 2.0, 0.0]), 0.0);
        // The value of 0.01 is too dark to count.
        assert!((error(&[3.0, 4.2, 1.0], &[3.0, 4.0, 0.01]) - (0.5 * 0.04f64).sqrt() / 4.0).abs() < 1e-6);
    }
}
