//! Frame times as functions of a scene's quantities, such as pixels, planes and light texels.

use vitrum::Frame;
use vitrum::backend::CpuBackend;

use crate::Failure;
use crate::accuracy::{Axis, Corner, Plot, Scale, Series};
use crate::bench::median;
use crate::case::Case;
use crate::frames::render;
use crate::table;

/// Pixels along an edge, and voxels along the volume's, where nothing is varied.
const EDGE: u32 = 256;
const RESOLUTION: u32 = 128;

/// A frame, by what differs from the one in the middle.
#[derive(Debug, Clone, Copy)]
struct Setup {
    edge: u32,
    resolution: u32,
    /// Sample distance in voxels of [`RESOLUTION`].
    sample_distance: f32,
    light_cells: u32,
    threads: usize,
}

impl Setup {
    fn case(self) -> Result<Case, Failure> {
        // The planes stay where they are when voxels become finer.
        let distance = self.sample_distance * self.resolution as f32 / RESOLUTION as f32;
        let settings = [format!("sweep.sample_distance={distance}"), format!("sweep.light_cells={}", self.light_cells)];
        Case::builtin("glass", self.edge, Some(self.resolution), &settings.each_ref().map(String::as_str))
            .map(Case::without_light)
    }
}

/// A quantity that is varied.
struct Quantity {
    name: &'static str,
    setups: Vec<Setup>,
    /// The amount of the quantity in a frame.
    amount: fn(&Setup, &Frame) -> f64,
}

fn quantities(threads: usize) -> Vec<Quantity> {
    let base = Setup { edge: EDGE, resolution: RESOLUTION, sample_distance: 1.0, light_cells: 256, threads };
    let powers = |to: usize| (0..).map(|power| 1 << power).take_while(move |&count| count <= to);
    vec![
        Quantity {
            name: "pixels",
            setups: [128, 256, 512, 1024].map(|edge| Setup { edge, ..base }).to_vec(),
            amount: |_, frame| f64::from(frame.width) * f64::from(frame.height),
        },
        Quantity {
            name: "planes",
            setups: [4.0, 2.0, 1.0, 0.5].map(|sample_distance| Setup { sample_distance, ..base }).to_vec(),
            amount: |_, frame| f64::from(frame.statistics.planes.unwrap_or_default()),
        },
        Quantity {
            name: "voxels",
            setups: [32, 64, 128, 256].map(|resolution| Setup { resolution, ..base }).to_vec(),
            amount: |setup, _| f64::from(setup.resolution).powi(3),
        },
        Quantity {
            name: "cells of light",
            setups: [64, 128, 256, 512].map(|light_cells| Setup { light_cells, ..base }).to_vec(),
            amount: |_, frame| frame.statistics.light_texels.unwrap_or_default().map(f64::from).iter().product(),
        },
        Quantity {
            name: "threads",
            setups: powers(threads).map(|threads| Setup { threads, ..base }).collect(),
            amount: |setup, _| setup.threads as f64,
        },
    ]
}

/// The table and the plot: medians of `frames` frames, each quantity's interleaved.
///
/// # Errors
/// If a backend fails.
pub fn measure(threads: usize, frames: usize) -> Result<(String, Plot), Failure> {
    let mut rows = Vec::new();
    let mut series = Vec::new();
    for quantity in quantities(threads) {
        eprintln!("{}", quantity.name);
        let mut amounts = Vec::new();
        let mut times = vec![Vec::new(); quantity.setups.len()];
        let mut prepared = Vec::new();
        for setup in &quantity.setups {
            let (case, mut backend) = (setup.case()?, CpuBackend::new(Some(setup.threads))?);
            // The warm-up.
            amounts.push((quantity.amount)(setup, &render(&case, &mut backend)?));
            prepared.push((case, backend));
        }
        for _ in 0..frames {
            for ((case, backend), times) in prepared.iter_mut().zip(&mut times) {
                times.extend(render(case, backend)?.statistics.frame_ms);
            }
        }
        let medians: Vec<f64> = times.iter().filter_map(|times| median(times)).collect();
        for (index, (amount, ms)) in amounts.iter().zip(&medians).enumerate() {
            let exponent = index.checked_sub(1).map(|before| {
                let slope = (ms / medians[before]).ln() / (amount / amounts[before]).ln();
                format!("{slope:.2}")
            });
            rows.push([
                quantity.name.to_owned(),
                format!("{amount}"),
                format!("{ms:.0}"),
                exponent.unwrap_or_else(|| "–".to_owned()),
            ]);
        }
        let points = amounts.iter().zip(&medians).map(|(amount, ms)| (amount / amounts[0], ms / medians[0]));
        series.push(Series::new(quantity.name, points.collect()));
    }
    let header = ["varied", "how much", "frame ms", "exponent"].map(str::to_owned);
    let plot = Plot {
        title: "Frame time against what a frame is made of",
        x: Axis { label: "how many times as much", scale: Scale::Logarithmic },
        y: Axis { label: "how many times as long", scale: Scale::Logarithmic },
        series,
        legend: Corner::UpperLeft,
    };
    Ok((table::aligned(header, rows), plot))
}
