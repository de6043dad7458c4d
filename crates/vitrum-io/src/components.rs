//! Voxels of several numbers, such as colours and vectors: one number is made of them.

use std::io::{self, BufRead, Read};

use half::f16;

use crate::error::{Error, Place, Report, clip};
use crate::memory;
use crate::samples::{Endian, SampleType, VoxelBuffer, read_up_to};
use crate::setting::Setting;
use crate::shared::Shared;
use crate::source::{Assumption, Assumptions};
use crate::stream;
use crate::text;

/// Rec. 709, of the code values, as most programs take it.
const LUMINANCE: [f64; 3] = [0.2126, 0.7152, 0.0722];

/// More components than these are a mistake.
const MOST: u64 = 64;

/// The components of a voxel, which lie side by side in the file, and what is made of them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Components {
    pub count: usize,
    pick: Pick,
    sample: SampleType,
    endian: Endian,
    /// Slope and intercept of each number.
    mapping: [f64; 2],
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Pick {
    /// The length of the vector.
    Norm,
    /// The luminance of the colour.
    Luminance,
    One(usize),
}

/// Fails where a part of voxels that have one number each is asked for.
pub(crate) fn refuse(report: Report, format: &str, asked: Option<&str>) -> Result<(), Error> {
    let Some(array) = asked else { return Ok(()) };
    let problem = format!(
        "the array `{}` is asked for, and the format {format} has no arrays with names; its voxels have one component",
        clip(array)
    );
    Err(report.unsupported(Place::File, problem, "leave out the array").with_setting(Setting::Array))
}

/// As [`stream::fill`], for voxels that may have several components: `size` is that of a voxel in the file.
pub(crate) fn fill(
    report: Report,
    voxels: &mut VoxelBuffer,
    reader: &mut dyn Read,
    count: usize,
    size: usize,
    components: Option<Components>,
) -> Result<(), Error> {
    match components {
        None => stream::fill(report, voxels, reader, count, size),
        Some(components) => {
            let mut reduced = components.reduced(reader);
            if components.are_colors() {
                // A volume of several files has those of the files before.
                reduced.colors = Some(match voxels.colors.take() {
                    Some(colors) => colors,
                    None => memory::reserve(report, Shared::<u32>::room(count))?,
                });
            }
            stream::fill(report, voxels, &mut reduced, count, 4)?;
            voxels.colors = reduced.colors;
            Ok(())
        }
    }
}

/// Bytes of a voxel in memory, colours included, of the type to which it is [decoded](decoded_as).
pub(crate) fn stored_bytes(sample: SampleType, components: Option<Components>) -> u64 {
    let colors = if components.is_some_and(Components::are_colors) { size_of::<u32>() as u64 } else { 0 };
    sample.stored_size() as u64 + colors
}

/// As [`text::read_numbers`], for voxels that may have several components; nothing may follow where the numbers are the `last`.
pub(crate) fn read_numbers(
    report: Report,
    voxels: &mut VoxelBuffer,
    reader: &mut impl BufRead,
    count: usize,
    (sample, components): (SampleType, Option<Components>),
    last: bool,
) -> Result<(), Error> {
    match components {
        None => text::read_numbers(report, voxels, reader, count, sample)?,
        Some(components) => components.read_numbers(report, voxels, reader, count)?,
    }
    if !last {
        return Ok(());
    }
    match text::next_word(reader).map_err(|error| report.unreadable(error))? {
        None => Ok(()),
        Some(word) => Err(text::surplus(report, &word, count * components.map_or(1, |several| several.count))),
    }
}

/// The type and the byte order in which voxels come to a buffer, and their size in the file.
pub(crate) fn decoded_as(
    sample: SampleType,
    endian: Endian,
    components: Option<Components>,
) -> (SampleType, Endian, usize) {
    match components {
        None => (sample, endian, sample.size()),
        Some(components) => (SampleType::F32, Endian::Little, components.size()),
    }
}

impl Components {
    /// What `asked` names: `norm`, `rgb`, or the number of a component, counted from 0. If absent, the luminance of colours, and the length of
    /// vectors. Both are told.
    pub fn choose(
        (report, place): (Report, Place),
        count: u64,
        colors: bool,
        (sample, endian): (SampleType, Endian),
        asked: Option<&str>,
        assumptions: &mut Assumptions,
    ) -> Result<Self, Error> {
        if !(2..=MOST).contains(&count) {
            let problem = format!("the voxels have {count} components, and from 1 to {MOST} are read");
            return Err(report.unsupported(place, problem, "pick out one component first"));
        }
        let pick = match asked.map(str::trim) {
            None if colors && count >= 3 => Pick::Luminance,
            None | Some("norm") => Pick::Norm,
            Some("rgb") if count >= 3 => Pick::Luminance,
            Some(other) => match other.parse::<usize>() {
                Ok(index) if (index as u64) < count => Pick::One(index),
                _ => {
                    let problem = format!("`{}` is asked for of voxels with {count} components", clip(other));
                    let last = count - 1;
                    let advice = format!("give `norm`, `rgb` of colours, or the number of a component, 0 to {last}");
                    return Err(report.unsupported(place, problem, advice).with_setting(Setting::Array));
                }
            },
        };
        let made = match pick {
            Pick::Norm => "the length of the vector was taken".to_owned(),
            Pick::Luminance if shows_colors(sample) => {
                "their colours are shown, and opacity goes by the luminance".to_owned()
            }
            Pick::Luminance => format!("colours of {} are not shown: the luminance was taken", sample.name()),
            Pick::One(index) => format!("component {index} was taken"),
        };
        let others = format!("`norm`, {}0 to {}", if count >= 3 { "`rgb`, " } else { "" }, count - 1);
        let fact = format!("the voxels have {count} components: {made}");
        assumptions.push(Assumption::replaceable(fact, Setting::Array, others));
        // `count` is at most 64.
        Ok(Self { count: count as usize, pick, sample, endian, mapping: [1.0, 0.0] })
    }

    /// As [`Self::choose`], for an array with a name, of which `part` is asked for; `None` where it has one component.
    pub fn of_array(
        (report, place): (Report, Place),
        name: &str,
        count: u64,
        colors: bool,
        decoding: (SampleType, Endian),
        part: Option<&str>,
        assumptions: &mut Assumptions,
    ) -> Result<Option<Self>, Error> {
        match part {
            _ if count != 1 => Self::choose((report, place), count, colors, decoding, part, assumptions).map(Some),
            None => Ok(None),
            Some(part) => {
                let problem = format!("`{}` is asked for of `{}`, which has one component", clip(part), clip(name));
                Err(report.unsupported(place, problem, "leave it out").with_setting(Setting::Array))
            }
        }
    }

    /// Whether a text asks for a part of voxels, as far as no array has that name.
    pub fn is_part(asked: &str) -> bool {
        matches!(asked, "norm" | "rgb") || asked.parse::<u64>().is_ok_and(|index| index < MOST)
    }

    /// The components whose numbers are mapped before anything is made of them.
    pub fn mapped(self, slope: f32, intercept: f32) -> Self {
        Self { mapping: [slope, intercept].map(f64::from), ..self }
    }

    /// The index behind the last component that is looked at.
    pub fn needed(self) -> usize {
        match self.pick {
            Pick::Norm => self.count,
            Pick::Luminance if self.are_colors() => self.count.min(4),
            Pick::Luminance => 3,
            Pick::One(index) => index + 1,
        }
    }

    /// The number that a voxel has once its component `index` is taken in, where `before` was made of the ones before; it begins with 0.
    pub fn gathered(self, before: f32, index: usize, bytes: &[u8]) -> f32 {
        let number = self.value(bytes);
        let gathered = match self.pick {
            Pick::Norm => libm::hypot(before.into(), number),
            Pick::Luminance => f64::from(before) + LUMINANCE.get(index).copied().unwrap_or(0.0) * number,
            Pick::One(wanted) if wanted == index => number,
            Pick::One(_) => before.into(),
        };
        gathered as f32
    }

    /// Whether the colours are shown: those of bytes, of 16 bits, and of floats from 0 to 1.
    pub fn are_colors(self) -> bool {
        self.pick == Pick::Luminance && shows_colors(self.sample)
    }

    /// A channel as a byte. Floats are 1 at most, as VTK has it.
    fn channel(&self, value: f64) -> u8 {
        let of_255 = match self.sample {
            SampleType::U8 => value,
            SampleType::U16 => value / 257.0,
            _ => 255.0 * value,
        };
        (of_255 + 0.5) as u8
    }

    /// The word of a voxel's colour with its channel `index`.
    pub fn with_channel(self, word: u32, index: usize, bytes: &[u8]) -> u32 {
        let mut channels = word.to_le_bytes();
        if let Some(channel) = channels.get_mut(index) {
            *channel = self.channel(decoded(bytes, self.sample, self.endian));
        }
        u32::from_le_bytes(channels)
    }

    /// The word of the colour whose channels are these numbers; opaque without a fourth.
    fn color(&self, number: impl Fn(usize) -> Option<f64>) -> u32 {
        u32::from_le_bytes([0, 1, 2, 3].map(|index| number(index).map_or(u8::MAX, |number| self.channel(number))))
    }

    /// Bytes of a component.
    pub fn sample_size(self) -> usize {
        self.sample.size()
    }

    /// Reads the numbers of voxels that are written as text.
    fn read_numbers(
        self,
        report: Report,
        voxels: &mut VoxelBuffer,
        reader: &mut impl BufRead,
        count: usize,
    ) -> Result<(), Error> {
        let mut numbers = vec![0.0; self.count];
        let mut colors = match voxels.colors.take() {
            None if self.are_colors() => Some(memory::reserve(report, Shared::<u32>::room(count))?),
            before => before,
        };
        for voxel in 0..count {
            for (index, number) in numbers.iter_mut().enumerate() {
                let at = voxel * self.count + index;
                let Some(word) = text::next_word(reader).map_err(|error| report.unreadable(error))? else {
                    return Err(text::too_few(report, count.saturating_mul(self.count), at));
                };
                let value = self.sample.parse(&word).ok_or_else(|| text::no_number(report, at, &word, self.sample))?;
                *number = self.mapping[0] * value + self.mapping[1];
            }
            voxels.append_float(self.made_of(|index| numbers.get(index).copied().unwrap_or(f64::NAN)));
            if let Some(colors) = &mut colors {
                colors.push(self.color(|index| numbers.get(index).copied()));
            }
        }
        voxels.colors = colors;
        Ok(())
    }

    /// The type for people, such as `3 x uint8`.
    pub fn named(components: Option<Self>, sample: SampleType) -> String {
        components
            .map_or_else(|| sample.name().to_owned(), |components| format!("{} x {}", components.count, sample.name()))
    }

    /// Bytes of a voxel in the file.
    pub fn size(&self) -> usize {
        self.count * self.sample.size()
    }

    /// The numbers of the voxels, as float32, little-endian.
    pub fn reduced<'a>(self, inner: &'a mut (dyn Read + 'a)) -> Reduced<'a> {
        Reduced { components: self, inner, ready: Vec::new(), given: 0, colors: None }
    }

    fn made_of_bytes(&self, voxel: &[u8]) -> f32 {
        self.made_of(|index| self.sample_at(voxel, index).map_or(f64::NAN, |bytes| self.value(bytes)))
    }

    fn color_of_bytes(&self, voxel: &[u8]) -> u32 {
        self.color(|index| Some(decoded(self.sample_at(voxel, index)?, self.sample, self.endian)))
    }

    /// The bytes of a voxel's component.
    fn sample_at<'v>(&self, voxel: &'v [u8], index: usize) -> Option<&'v [u8]> {
        let size = self.sample.size();
        voxel.get(index * size..(index + 1) * size)
    }

    fn value(&self, bytes: &[u8]) -> f64 {
        self.mapping[0] * decoded(bytes, self.sample, self.endian) + self.mapping[1]
    }

    fn made_of(&self, number: impl Fn(usize) -> f64) -> f32 {
        let [red, green, blue] = LUMINANCE;
        match self.pick {
            Pick::One(index) => number(index) as f32,
            Pick::Luminance => (red * number(0) + green * number(1) + blue * number(2)) as f32,
            Pick::Norm => libm::sqrt((0..self.count).map(|index| number(index) * number(index)).sum()) as f32,
        }
    }
}

/// Whether colours of this type are shown.
fn shows_colors(sample: SampleType) -> bool {
    matches!(sample, SampleType::U8 | SampleType::U16 | SampleType::F32 | SampleType::F64)
}

fn decoded(bytes: &[u8], sample: SampleType, endian: Endian) -> f64 {
    let mut word = [0; 8];
    word[..bytes.len()].copy_from_slice(bytes);
    if endian == Endian::Big {
        word[..bytes.len()].reverse();
    }
    let [a, b, c, d, ..] = word;
    match sample {
        SampleType::I8 => f64::from(a as i8),
        SampleType::U8 => f64::from(a),
        SampleType::I16 => f64::from(i16::from_le_bytes([a, b])),
        SampleType::U16 => f64::from(u16::from_le_bytes([a, b])),
        SampleType::I32 => f64::from(i32::from_le_bytes([a, b, c, d])),
        SampleType::U32 => f64::from(u32::from_le_bytes([a, b, c, d])),
        SampleType::I64 => i64::from_le_bytes(word) as f64,
        SampleType::U64 => u64::from_le_bytes(word) as f64,
        SampleType::F16 => f64::from(f16::from_le_bytes([a, b])),
        SampleType::F32 => f64::from(f32::from_le_bytes([a, b, c, d])),
        SampleType::F64 => f64::from_le_bytes(word),
    }
}

/// Reads one float32 for each voxel of several components.
pub(crate) struct Reduced<'a> {
    components: Components,
    inner: &'a mut dyn Read,
    ready: Vec<u8>,
    given: usize,
    /// The colours so far, where they are asked for.
    pub colors: Option<Vec<u32>>,
}

impl Read for Reduced<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        const VOXELS: usize = 4096;
        if self.given == self.ready.len() {
            let size = self.components.size();
            let mut chunk = vec![0; VOXELS * size];
            // No more than is asked for, so that what lies behind stays to be looked at.
            let voxels = buffer.len().div_ceil(4).min(VOXELS);
            let (found, outcome) = read_up_to(self.inner, &mut chunk[..voxels * size]);
            let whole = chunk[..found].chunks_exact(size);
            if let Some(colors) = &mut self.colors {
                colors.extend(whole.clone().map(|voxel| self.components.color_of_bytes(voxel)));
            }
            self.ready = whole.flat_map(|voxel| self.components.made_of_bytes(voxel).to_le_bytes()).collect();
            self.given = 0;
            if self.ready.is_empty() {
                outcome?;
            }
        }
        let left = &self.ready[self.given..];
        let count = left.len().min(buffer.len());
        buffer[..count].copy_from_slice(&left[..count]);
        self.given += count;
        Ok(count)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn made(asked: Option<&str>, colors: bool, sample: SampleType, bytes: &[u8]) -> Result<Vec<f32>, Error> {
        let mut told = Assumptions::default();
        let at = (Report::new("a"), Place::File);
        let components = Components::choose(at, 3, colors, (sample, Endian::Big), asked, &mut told)?;
        let mut out = Vec::new();
        let mut bytes = bytes;
        components.reduced(&mut bytes).read_to_end(&mut out).expect("bytes in memory");
        assert_eq!(told.len(), 1);
        Ok(out.chunks_exact(4).map(|word| f32::from_le_bytes([word[0], word[1], word[2], word[3]])).collect())
    }

    #[test]
    fn a_number_is_made_of_each_voxel() {
        let vectors: Vec<u8> =
            [3.0_f32, 0.0, -4.0, 1.0, 2.0, 2.0].iter().flat_map(|value| value.to_be_bytes()).collect();
        assert_eq!(made(None, false, SampleType::F32, &vectors).ok(), Some(vec![5.0, 3.0]));
        assert_eq!(made(Some("2"), false, SampleType::F32, &vectors).ok(), Some(vec![-4.0, 2.0]));
        assert_eq!(made(None, true, SampleType::U8, &[200, 200, 200, 0, 0, 0]).ok(), Some(vec![200.0, 0.0]));
        // A voxel that is cut short is none.
        assert_eq!(made(Some("norm"), true, SampleType::U8, &[2, 3, 6, 1]).ok(), Some(vec![7.0]));
        let error = made(Some("3"), false, SampleType::U8, &[]).expect_err("there are three");
        assert!(error.to_string().contains("0 to 2"), "{error}");
    }
}
