//! Voxels of several numbers that lie in planes: all first components, then all second ones.

use std::io::Read;

use crate::components::Components;
use crate::error::{Error, Place, Report};
use crate::memory;
use crate::samples::read_up_to;
use crate::shared::Shared;
use crate::stored::{OPAQUE, Stored};
use crate::stream;

/// Reads one number for each of `count` voxels. In front of each plane are `before` bytes, and `between` behind it.
pub(crate) fn read(
    report: Report,
    reader: &mut dyn Read,
    count: usize,
    components: Components,
    (before, between): (u64, u64),
) -> Result<Stored, Error> {
    // A multiple of every sample size.
    const CHUNK: usize = 64 * 1024;
    let size = components.sample_size();
    let mut numbers: Vec<f32> = memory::reserve(report, Shared::<f32>::room(count))?;
    numbers.resize(count, 0.0);
    let mut colors: Option<Vec<u32>> =
        if components.are_colors() { Some(memory::reserve(report, Shared::<u32>::room(count))?) } else { None };
    if let Some(colors) = &mut colors {
        colors.resize(count, OPAQUE);
    }
    let mut bytes = vec![0; CHUNK];
    for index in 0..components.needed() {
        stream::skip(report, reader, if index == 0 { before } else { before + between })?;
        let mut first = 0;
        for voxels in numbers.chunks_mut(CHUNK / size) {
            let chunk = &mut bytes[..voxels.len() * size];
            let (found, outcome) = read_up_to(reader, chunk);
            outcome.map_err(|error| stream::broken(report, found as u64, error))?;
            if found < chunk.len() {
                let problem = format!("the data ends in component {index} of the voxels' {}", components.count);
                return Err(report.invalid(Place::File, problem, "correct the sizes, or get the whole file"));
            }
            for (number, sample) in voxels.iter_mut().zip(chunk.chunks_exact(size)) {
                *number = components.gathered(*number, index, sample);
            }
            if let Some(words) = colors.as_mut().and_then(|colors| colors.get_mut(first..first + voxels.len())) {
                for (word, sample) in words.iter_mut().zip(chunk.chunks_exact(size)) {
                    *word = components.with_channel(*word, index, sample);
                }
            }
            first += voxels.len();
        }
    }
    Ok(Stored { voxels: numbers.into(), colors: colors.map(Into::into), paged: None })
}
