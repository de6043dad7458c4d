//! The physical values of a volume as files hold them: of the smallest type that is exact.

use std::io::{self, Write};

use crate::samples::SampleType;
use crate::volume::Volume;
use crate::voxels::Voxels;

/// The smallest type that holds the physical values exactly.
pub(crate) fn sample_type(volume: &Volume) -> SampleType {
    let whole = volume.value_scale.fract() == 0.0 && volume.value_offset.fract() == 0.0;
    if !whole || matches!(volume.voxels, Voxels::F32(_)) {
        return SampleType::F32;
    }
    let [low, high] = volume.range;
    let fits = |least: f32, most: f32| low >= least && high <= most;
    // A volume that was stored in 16 bits stays there, so that a series of them has one type.
    let small = matches!(volume.voxels, Voxels::U8(_));
    match () {
        () if small && fits(0.0, 255.0) => SampleType::U8,
        () if small && fits(-128.0, 127.0) => SampleType::I8,
        () if fits(-32768.0, 32767.0) && volume.value_offset != 0.0 => SampleType::I16,
        () if fits(0.0, 65535.0) => SampleType::U16,
        () if fits(-32768.0, 32767.0) => SampleType::I16,
        () => SampleType::F32,
    }
}

/// Writes the physical values of a volume in its [`sample_type`], x fastest, little-endian.
pub(crate) fn write_values(sink: &mut dyn Write, volume: &Volume) -> io::Result<()> {
    let sample = sample_type(volume);
    let mut chunk = Vec::new();
    for index in 0..volume.voxels.len() {
        let stored = volume.voxels.stored(index).unwrap_or_default();
        let value = stored * volume.value_scale + volume.value_offset;
        match sample {
            SampleType::U8 => chunk.push(value as u8),
            SampleType::I8 => chunk.extend((value as i8).to_le_bytes()),
            SampleType::U16 => chunk.extend((value as u16).to_le_bytes()),
            SampleType::I16 => chunk.extend((value as i16).to_le_bytes()),
            _ => chunk.extend(value.to_le_bytes()),
        }
        if chunk.len() >= 64 * 1024 {
            sink.write_all(&chunk)?;
            chunk.clear();
        }
    }
    sink.write_all(&chunk)
}
