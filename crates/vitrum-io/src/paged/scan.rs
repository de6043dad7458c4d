//! The pass over all voxels of a source, for the ranges of bricks and the overview.

use std::sync::Mutex;
use std::sync::PoisonError;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

use super::{BrickRanges, Stores, VoxelSource, brick_shift};
use crate::error::{Error, Place, Report};
use crate::voxels::Voxels;

/// The voxels of an overview, the ranges of the bricks, and the range of all.
pub(super) type Scanned = (Voxels, BrickRanges, [f32; 2]);

/// Reads all voxels of `source` once; every `stride`th along each axis is kept.
pub(super) fn scan(
    report: Report,
    source: &dyn VoxelSource,
    dimensions: [u32; 3],
    stride: u32,
) -> Result<Scanned, Error> {
    match source.read([0; 3], [1; 3])? {
        Voxels::U8(_) => of::<u8>(report, source, dimensions, stride),
        Voxels::U16(_) => of::<u16>(report, source, dimensions, stride),
        Voxels::F32(_) => of::<f32>(report, source, dimensions, stride),
    }
}

/// What a row of bricks gives: their ranges, and the kept voxels with the row of the overview in which each run of them lies.
type Row<T> = (Vec<(T, T)>, Vec<(usize, Vec<T>)>);

/// The ranges and the overview while rows of bricks come in, and the first failure.
type Gathered<T> = (Vec<(T, T)>, Vec<T>, Option<Error>);

fn of<T: Stores>(report: Report, source: &dyn VoxelSource, dimensions: [u32; 3], stride: u32) -> Result<Scanned, Error>
where
    Voxels: From<Vec<T>>,
{
    let edge = 1_u32 << brick_shift(dimensions);
    let [width, height, depth] = dimensions.map(|n| n.div_ceil(edge) as usize);
    let kept = dimensions.map(|n| n.div_ceil(stride) as usize);
    let next = AtomicUsize::new(0);
    let rows = height * depth;
    let all: Mutex<Gathered<T>> =
        Mutex::new((vec![(T::zeroed(), T::zeroed()); width * rows], vec![T::zeroed(); kept.iter().product()], None));
    let lock = || all.lock().unwrap_or_else(PoisonError::into_inner);
    let work = || {
        loop {
            let row = next.fetch_add(1, Ordering::Relaxed);
            if row >= rows || lock().2.is_some() {
                return;
            }
            let outcome =
                of_row::<T>(report, source, dimensions, [row % height, row / height].map(|n| n as u32), stride);
            let mut all = lock();
            match outcome {
                Ok((ranges, runs)) => {
                    all.0[row * width..][..width].copy_from_slice(&ranges);
                    runs.iter().for_each(|(at, run)| all.1[at * kept[0]..][..kept[0]].copy_from_slice(run));
                }
                Err(error) => all.2 = Some(error),
            }
        }
    };
    let threads = thread::available_parallelism().map_or(1, usize::from).min(rows);
    thread::scope(|scope| {
        (1..threads).for_each(|_| {
            // Without another thread this one does it all.
            let _ = thread::Builder::new().spawn_scoped(scope, work);
        });
        work();
    });
    let (ranges, overview, failure) = all.into_inner().unwrap_or_else(PoisonError::into_inner);
    if let Some(error) = failure {
        return Err(error);
    }
    let ends = ranges.iter().map(|&(low, high)| [low.into(), high.into()]);
    let extremes = ends.reduce(|[a, b]: [f32; 2], [low, high]| [a.min(low), b.max(high)]).unwrap_or_default();
    Ok((overview.into(), T::ranges(ranges), extremes))
}

/// A row of bricks along x, the one at `[y, z]` in bricks.
fn of_row<T: Stores>(
    report: Report,
    source: &dyn VoxelSource,
    dimensions: [u32; 3],
    [y, z]: [u32; 2],
    stride: u32,
) -> Result<Row<T>, Error> {
    let edge = 1_u32 << brick_shift(dimensions);
    let low = [0, y * edge, z * edge];
    let size = [dimensions[0], edge.min(dimensions[1] - low[1]), edge.min(dimensions[2] - low[2])];
    let read = source.read(low, size)?;
    let voxels = T::of(&read).filter(|voxels| voxels.len() == size.map(|n| n as usize).iter().product::<usize>());
    let Some(voxels) = voxels else {
        return Err(report.invalid(Place::File, "a block has other voxels than were asked for", "correct the source"));
    };
    let mut ranges: Vec<(T, T)> = voxels[..size[0] as usize].iter().step_by(edge as usize).map(|&v| (v, v)).collect();
    let mut runs = Vec::new();
    let floats = matches!(read, Voxels::F32(_));
    let overview_rows = dimensions[1].div_ceil(stride) as usize;
    for (index, line) in voxels.chunks_exact(size[0] as usize).enumerate() {
        for (range, part) in ranges.iter_mut().zip(line.chunks(edge as usize)) {
            for &value in part {
                range.0 = if value < range.0 { value } else { range.0 };
                range.1 = if value > range.1 { value } else { range.1 };
            }
        }
        if floats && line.iter().any(|&value| !Into::<f32>::into(value).is_finite()) {
            let problem = "some voxels are NaN or infinite, and they stay in the file";
            return Err(report.unsupported(Place::File, problem, "write finite values, or allow more memory"));
        }
        let at = [low[1] + index as u32 % size[1], low[2] + index as u32 / size[1]];
        if at.iter().all(|at| at % stride == 0) {
            let [y, z] = at.map(|at| (at / stride) as usize);
            runs.push((z * overview_rows + y, line.iter().copied().step_by(stride as usize).collect()));
        }
    }
    Ok((ranges, runs))
}
