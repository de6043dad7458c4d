//! Frame times of several backends, interleaved.
//!
//! What runs at the same time, heat and clocks change from minute to minute; rounds in which every backend renders one
//! frame spread that over all of them. A backend is timed after its picture was found right.

use vitrum::Frame;
use vitrum::backend::{Backend, CpuBackend};
use vitrum_compare::Verdict;
use vitrum_kernels::kernel::InstructionSet;

use crate::Failure;
use crate::bounds;
use crate::case::Case;
use crate::frames::render;
use crate::machine::forget_peak_memory;
use crate::raster;
use crate::table;

/// A backend that is timed.
pub struct Contender {
    /// The backend.
    pub backend: Box<dyn Backend>,
    /// The worker threads it was given, if it has any.
    pub threads: Option<usize>,
    /// The instruction set of the build, where builds are compared.
    pub build: Option<InstructionSet>,
}

impl Contender {
    /// The CPU with so many threads.
    ///
    /// # Errors
    /// If they cannot be started.
    pub fn cpu(threads: usize) -> Result<Self, Failure> {
        let backend = Box::new(CpuBackend::new(Some(threads))?);
        Ok(Self { backend, threads: Some(threads), build: None })
    }

    /// The CPU's build for an instruction set that the machine has.
    ///
    /// # Errors
    /// If threads cannot be started.
    pub fn build(threads: usize, set: InstructionSet) -> Result<Self, Failure> {
        let backend = Box::new(CpuBackend::with_instruction_set(Some(threads), set)?);
        Ok(Self { backend, threads: Some(threads), build: Some(set) })
    }
}

/// The measurements of one backend on one case.
#[derive(Debug, Clone)]
pub struct Timing {
    scene: String,
    size: [u32; 2],
    planes: u32,
    light_texels: [u32; 2],
    rays: u64,
    backend: String,
    threads: Option<usize>,
    /// Whether the picture was right; else nothing was timed.
    verdict: Verdict,
    frame_ms: Vec<f64>,
    upload_ms: Vec<f64>,
    peak_bytes: Option<u64>,
    /// The median frame time, over the median frame time of the first backend.
    relative: Option<f64>,
}

/// Times `frames` frames of a case on each backend. The pictures of all backends are compared with the first one's.
///
/// # Errors
/// If a backend fails.
pub fn measure(case: &Case, contenders: &mut [Contender], frames: usize) -> Result<Vec<Timing>, Failure> {
    let mut first = None;
    let mut timings = Vec::new();
    for contender in &mut *contenders {
        // The warm-up, which also compiles what a device needs.
        let frame = render(case, contender.backend.as_mut())?;
        let verdict = verdict(case, first.get_or_insert_with(|| frame.clone()), &frame, contender)?;
        timings.push(Timing::new(case, &frame, contender, verdict));
    }
    for _ in 0..frames {
        for (contender, timing) in contenders.iter_mut().zip(&mut timings) {
            if timing.verdict.passed() {
                timing.add(case, contender.backend.as_mut())?;
            }
        }
    }
    let reference = timings.first().and_then(|timing| median(&timing.frame_ms));
    for timing in &mut timings {
        timing.relative = median(&timing.frame_ms).zip(reference).map(|(this, first)| this / first);
    }
    Ok(timings)
}

fn verdict(case: &Case, reference: &Frame, frame: &Frame, contender: &Contender) -> Result<Verdict, Failure> {
    let (reference, other) = (color(reference), color(frame));
    let what = || format!("{} on {}", case.name, contender.backend.adapter());
    let comparison = reference.compare(&other).map_err(|error| Failure::Compare { what: what(), error })?;
    Ok(bounds::of_backend(contender.backend.as_ref(), reference.is_shown()).check(&comparison))
}

fn color(frame: &Frame) -> raster::Raster {
    raster::of_frame(frame).swap_remove(0).1
}

#[rustfmt::skip]
const HEADER: [&str; 12] = [
    "scene", "pixels", "light", "planes", "backend", "threads",
    "frame ms", "range", "ns/ray·plane", "upload ms", "peak MiB", "relative",
];

impl Timing {
    fn new(case: &Case, frame: &Frame, contender: &Contender, verdict: Verdict) -> Self {
        let statistics = &frame.statistics;
        let supersampling = u64::from(case.scene.film.supersampling);
        Self {
            scene: case.name.clone(),
            size: [statistics.width, statistics.height],
            planes: statistics.planes.unwrap_or_default(),
            light_texels: statistics.light_texels.unwrap_or_default(),
            rays: u64::from(statistics.width) * u64::from(statistics.height) * supersampling * supersampling,
            backend: match contender.build {
                Some(set) => format!("{}, {set:?}", statistics.backend),
                None => statistics.backend.clone(),
            },
            threads: contender.threads,
            verdict,
            frame_ms: Vec::new(),
            upload_ms: Vec::new(),
            peak_bytes: None,
            relative: None,
        }
    }

    fn add(&mut self, case: &Case, backend: &mut dyn Backend) -> Result<(), Failure> {
        let forgotten = forget_peak_memory();
        let statistics = render(case, backend)?.statistics;
        self.frame_ms.extend(statistics.frame_ms);
        self.upload_ms.extend(statistics.upload_ms);
        self.peak_bytes = self.peak_bytes.max(statistics.peak_rss_bytes.filter(|_| forgotten));
        Ok(())
    }

    /// Whether the picture was right, so that it was timed.
    #[must_use]
    pub fn passed(&self) -> bool {
        self.verdict.passed()
    }

    fn cells(&self) -> [String; 12] {
        let size = |[width, height]: [u32; 2]| format!("{width} × {height}");
        let number =
            |value: Option<f64>, digits: usize| value.map_or("–".to_owned(), |value| format!("{value:.digits$}"));
        let frame_ms = median(&self.frame_ms);
        let steps = self.rays as f64 * f64::from(self.planes);
        let least = self.frame_ms.iter().copied().reduce(f64::min);
        let most = self.frame_ms.iter().copied().reduce(f64::max);
        let range = if self.passed() {
            format!("{}…{}", number(least, 1), number(most, 1))
        } else {
            format!("not timed, the picture is wrong: {}", self.verdict)
        };
        [
            self.scene.clone(),
            size(self.size),
            size(self.light_texels),
            self.planes.to_string(),
            self.backend.clone(),
            self.threads.map_or("–".to_owned(), |threads| threads.to_string()),
            number(frame_ms, 1),
            range,
            number(frame_ms.map(|ms| ms * 1e6 / steps), 2),
            number(median(&self.upload_ms), 1),
            number(self.peak_bytes.map(|bytes| bytes as f64 / f64::from(1 << 20)), 0),
            number(self.relative, 2),
        ]
    }
}

/// The timings as a Markdown table.
#[must_use]
pub fn markdown(timings: &[Timing]) -> String {
    table::aligned(HEADER.map(str::to_owned), timings.iter().map(Timing::cells))
}

/// The middle value, or the mean of the two in the middle.
pub(crate) fn median(values: &[f64]) -> Option<f64> {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let upper = *sorted.get(sorted.len() / 2)?;
    let lower = sorted[(sorted.len() - 1) / 2];
    Some(0.5 * (lower + upper))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn medians_are_those_of_the_textbook() {
        assert_eq!(median(&[]), None);
        assert_eq!(median(&[3.0, 1.0, 2.0]), Some(2.0));
        assert_eq!(median(&[4.0, 1.0, 2.0, 3.0]), Some(2.5));
    }

    #[test]
    fn two_backends_are_timed_against_each_other() {
        let cpu = |threads| Contender::cpu(threads).expect("threads start");
        let case = Case::builtin("ball", 24, Some(16), &[]).unwrap();
        let timings = measure(&case, &mut [cpu(1), cpu(2)], 2).unwrap();
        assert!(timings.iter().all(|timing| timing.passed() && timing.frame_ms.len() == 2));
        assert_eq!(timings[0].relative, Some(1.0));
        let table = markdown(&timings);
        assert!(table.lines().count() == 4 && table.contains("| cpu     | 2       |"), "{table}");
    }
}
