//! Offsets and widths of the fields of both versions of the NIfTI header.

use crate::samples::Endian;

/// Byte offsets in a header.
#[derive(Debug)]
pub(super) struct Layout {
    /// The format's name.
    pub name: &'static str,
    /// Bytes of the header itself, which is also its first field.
    pub length: usize,
    /// Whether numbers have the widths of NIfTI-2.
    wide: bool,
    pub magic: usize,
    pub dim: usize,
    pub datatype: usize,
    /// The meaning of the values.
    pub intent: usize,
    pub pixdim: usize,
    pub vox_offset: usize,
    pub slope: usize,
    pub intercept: usize,
    pub time_offset: usize,
    pub units: usize,
    pub qform_code: usize,
    pub sform_code: usize,
    pub quaternion: usize,
    pub qoffset: usize,
    pub srow: usize,
}

/// <https://nifti.nimh.nih.gov/pub/dist/src/niftilib/nifti1.h>
pub(super) const FIRST: Layout = Layout {
    name: "NIfTI-1",
    length: 348,
    wide: false,
    magic: 344,
    dim: 40,
    datatype: 70,
    intent: 68,
    pixdim: 76,
    vox_offset: 108,
    slope: 112,
    intercept: 116,
    time_offset: 136,
    units: 123,
    qform_code: 252,
    sform_code: 254,
    quaternion: 256,
    qoffset: 268,
    srow: 280,
};

/// <https://nifti.nimh.nih.gov/pub/dist/doc/nifti2.h>
pub(super) const SECOND: Layout = Layout {
    name: "NIfTI-2",
    length: 540,
    wide: true,
    magic: 4,
    dim: 16,
    datatype: 12,
    intent: 504,
    pixdim: 104,
    vox_offset: 168,
    slope: 176,
    intercept: 184,
    time_offset: 216,
    units: 500,
    qform_code: 344,
    sform_code: 348,
    quaternion: 352,
    qoffset: 376,
    srow: 400,
};

impl Layout {
    /// Least offset of the samples in a `.nii` file: the header, and the 4 bytes that say whether extensions follow.
    pub fn first_data_byte(&self) -> u64 {
        self.length as u64 + 4
    }

    /// Offset of `dim[index]`.
    pub fn dim(&self, index: usize) -> usize {
        self.dim + index * if self.wide { 8 } else { 2 }
    }
}

/// The bytes of a header, with the layout and byte order in which fields are read.
pub(super) struct Fields<'a> {
    /// Bytes of the header, as many as the layout has.
    pub bytes: &'a [u8],
    pub endian: Endian,
    pub layout: &'static Layout,
}

impl Fields<'_> {
    /// `at` is one of [`Layout`]'s and small steps on: always inside.
    fn word<const SIZE: usize>(&self, at: usize) -> [u8; SIZE] {
        let mut word = std::array::from_fn(|index| self.bytes.get(at + index).copied().unwrap_or_default());
        if self.endian == Endian::Big {
            word.reverse();
        }
        word
    }

    /// `dim[index]`: the number of dimensions, then their sizes.
    pub fn dim(&self, index: usize) -> i64 {
        let at = self.layout.dim(index);
        if self.layout.wide { i64::from_le_bytes(self.word(at)) } else { self.short(at).into() }
    }

    /// A 2-byte number in both versions.
    pub fn short(&self, at: usize) -> i16 {
        i16::from_le_bytes(self.word(at))
    }

    /// The code of the qform or the sform.
    pub fn code(&self, at: usize) -> i32 {
        if self.layout.wide { i32::from_le_bytes(self.word(at)) } else { self.short(at).into() }
    }

    pub fn units(&self) -> i32 {
        let at = self.layout.units;
        if self.layout.wide { i32::from_le_bytes(self.word(at)) } else { u8::from_le_bytes(self.word(at)).into() }
    }

    /// The float of an index in the row of them that starts at `at`.
    pub fn float(&self, at: usize, index: usize) -> f64 {
        if self.layout.wide {
            f64::from_le_bytes(self.word(at + 8 * index))
        } else {
            f32::from_le_bytes(self.word(at + 4 * index)).into()
        }
    }

    /// Offset of the samples, which NIfTI-1 stores as a float.
    pub fn vox_offset(&self) -> f64 {
        let at = self.layout.vox_offset;
        if self.layout.wide { i64::from_le_bytes(self.word(at)) as f64 } else { self.float(at, 0) }
    }
}
