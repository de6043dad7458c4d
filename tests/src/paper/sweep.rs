//! Table 1 of the plane sweep's paper (Magnus & Bruckner 2017), taken anew.
//!
//! The data sets are not at hand. A built-in volume of similar occupancy is stretched to the dimensions of each, with one byte a voxel, and
//! shown by its own scene: planes a voxel apart, refraction, soft shadows and coloured light, as in the paper.

use vitrum::backend::Backend;
use vitrum_io::{Volume, Voxels};

use crate::Failure;
use crate::bench::median;
use crate::case::Case;
use crate::frames::render;
use crate::table;

/// Picture edges of the paper's columns.
pub const EDGES: [u32; 3] = [512, 768, 1024];

/// A row of the paper's table.
pub struct DataSet {
    /// Name of the data set in the paper.
    pub name: &'static str,
    dimensions: [u32; 3],
    /// The built-in scene in its place.
    scene: &'static str,
    /// Milliseconds at [`EDGES`] on a GeForce GTX 1080.
    paper_ms: [f64; 3],
}

/// The rows of the paper's table.
#[rustfmt::skip]
pub const DATA_SETS: [DataSet; 8] = [
    DataSet { name: "Visible Human", dimensions: [587, 341, 1878], scene: "head", paper_ms: [43.0, 83.0, 130.0] },
    DataSet { name: "Supernova", dimensions: [432, 432, 432], scene: "supernova", paper_ms: [71.0, 95.0, 132.0] },
    DataSet { name: "Piggy bank", dimensions: [512, 512, 134], scene: "glass", paper_ms: [68.0, 128.0, 207.0] },
    DataSet { name: "Glass", dimensions: [768, 768, 800], scene: "glass", paper_ms: [95.0, 166.0, 186.0] },
    DataSet { name: "Head", dimensions: [512, 512, 333], scene: "head", paper_ms: [64.0, 110.0, 174.0] },
    DataSet { name: "Hand", dimensions: [244, 124, 257], scene: "head", paper_ms: [14.0, 26.0, 45.0] },
    DataSet { name: "Fly", dimensions: [498, 498, 226], scene: "supernova", paper_ms: [55.0, 109.0, 183.0] },
    DataSet { name: "Combustion", dimensions: [480, 720, 120], scene: "combustion", paper_ms: [17.0, 32.0, 52.0] },
];

impl DataSet {
    /// The stand-in of the data set, as a picture of `edge` × `edge` pixels.
    ///
    /// # Errors
    /// None that these scenes cause.
    pub fn case(&self, edge: u32) -> Result<Case, Failure> {
        let mut case = Case::builtin(self.scene, edge, None, &[])?.without_light();
        case.name = self.name.to_owned();
        case.assets.subject = stretched(case.volume(), self.dimensions)?.into();
        Ok(case)
    }

    /// Milliseconds in the paper for a picture of `edge` × `edge` pixels, where it has one.
    fn paper_ms(&self, edge: u32) -> Option<f64> {
        EDGES.iter().position(|&other| other == edge).map(|column| self.paper_ms[column])
    }
}

/// `volume`, resampled at other dimensions: the nearest voxels at the middles of cubic voxels of a volume of the same size along its
/// longest edge.
fn stretched(volume: &Volume, dimensions: [u32; 3]) -> Result<Volume, Failure> {
    let [low, high] = volume.range;
    let to_byte = 255.0 / (high - low);
    let columns: [Vec<u32>; 3] = std::array::from_fn(|axis| {
        let (from, to) = (u64::from(volume.dimensions[axis]), u64::from(dimensions[axis]));
        (0..to).map(|i| ((2 * i + 1) * from / (2 * to)) as u32).collect()
    });
    let [across, up, back] = &columns;
    // The cast saturates.
    let byte = |x, y, z| ((volume.value(x, y, z) - low) * to_byte).round() as u8;
    let slice = |&z: &u32| up.iter().flat_map(move |&y| across.iter().map(move |&x| byte(x, y, z)));
    let voxels = Voxels::U8(back.iter().flat_map(slice).collect());
    let longest = |edges: [u32; 3]| edges.into_iter().max().unwrap_or(1) as f32;
    let spacing = volume.spacing[0] * longest(volume.dimensions) / longest(dimensions);
    let stretched = Volume::new(volume.name.clone(), dimensions, [spacing; 3], voxels)?;
    let origin = dimensions.map(|n| -0.5 * spacing * (n - 1) as f32);
    Ok(Volume { origin, ..stretched.with_value_mapping((high - low) / 255.0, low)? })
}

/// The measurements of a data set at one size.
pub struct Row {
    name: String,
    dimensions: [u32; 3],
    planes: u32,
    edge: u32,
    paper_ms: Option<f64>,
    frame_ms: f64,
    kernels_ms: f64,
}

/// Times `frames` frames of a data set's stand-in, after one that is not counted.
///
/// # Errors
/// If the backend fails.
pub fn measure(set: &DataSet, case: &Case, backend: &mut dyn Backend, frames: usize) -> Result<Row, Failure> {
    let first = render(case, backend)?.statistics;
    let (mut frame_ms, mut kernels_ms) = (Vec::new(), Vec::new());
    for _ in 0..frames {
        let statistics = render(case, backend)?.statistics;
        frame_ms.extend(&statistics.frame_ms);
        kernels_ms.push(statistics.kernels.iter().map(|kernel| kernel.ms).sum());
    }
    Ok(Row {
        name: case.name.clone(),
        dimensions: set.dimensions,
        planes: first.planes.unwrap_or_default(),
        edge: first.width,
        paper_ms: set.paper_ms(first.width),
        frame_ms: median(&frame_ms).unwrap_or(f64::NAN),
        kernels_ms: median(&kernels_ms).unwrap_or(f64::NAN),
    })
}

/// The table.
#[must_use]
pub fn markdown(rows: &[Row]) -> String {
    let header = [
        "data set",
        "voxels",
        "planes",
        "pixels",
        "paper ms",
        "frame ms",
        "kernels ms",
        "frames/s",
        "paper over frame",
    ]
    .map(str::to_owned);
    let cells = rows.iter().map(|row| {
        let [x, y, z] = row.dimensions;
        let paper = |show: &dyn Fn(f64) -> String| row.paper_ms.map_or("–".to_owned(), show);
        [
            row.name.clone(),
            format!("{x} × {y} × {z}"),
            row.planes.to_string(),
            format!("{0} × {0}", row.edge),
            paper(&|ms| format!("{ms:.0}")),
            format!("{:.1}", row.frame_ms),
            format!("{:.1}", row.kernels_ms),
            format!("{:.1}", 1e3 / row.frame_ms),
            paper(&|ms| format!("{:.2}", ms / row.frame_ms)),
        ]
    });
    table::aligned(header, cells)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stretched_volumes_have_the_same_occupancy() {
        let set = DataSet { name: "small", dimensions: [40, 24, 90], scene: "head", paper_ms: [1.0, 2.0, 3.0] };
        let before = Case::builtin("head", 16, None, &[]).unwrap().volume().clone();
        let after = set.case(16).unwrap().volume().clone();
        assert_eq!(after.dimensions, set.dimensions);
        let air = |volume: &Volume| f64::from(volume.histogram(50)[0] as u32) / volume.voxel_count() as f64;
        assert!((air(&before) - air(&after)).abs() < 0.02, "{} and {}", air(&before), air(&after));
        assert!(
            (after.spacing[0] * 90.0 - before.spacing[0] * before.dimensions.iter().copied().max().unwrap() as f32)
                .abs()
                < 1e-5
        );
        // Centred.
        assert!((after.origin[2] + after.spacing[2] * 89.0 / 2.0).abs() < 1e-6);
        assert_eq!((set.paper_ms(768), set.paper_ms(100)), (Some(2.0), None));
    }
}
