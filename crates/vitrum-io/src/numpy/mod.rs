//! NumPy's `.npy`, one array with a small header, and `.npz`, an archive of them.
//!
//! The format: <https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html>.

mod archive;
mod array;
mod header;
mod literal;

use std::path::Path;

pub(crate) use self::archive::Npz;
use self::header::MAGIC;
use crate::error::{Error, Report};
use crate::input::Input;
use crate::open::{OpenOptions, Part, VolumeReader};
use crate::volume::Volume;

/// The reader of `.npy` files.
pub(crate) struct Numpy;

impl VolumeReader for Numpy {
    fn name(&self) -> &'static str {
        "NumPy"
    }

    fn extensions(&self) -> &'static [&'static str] {
        &[".npy"]
    }

    fn recognises(&self, head: &[u8], _path: &Path) -> bool {
        head.starts_with(MAGIC)
    }

    fn parts(&self) -> &'static [Part] {
        &[Part::Time]
    }

    fn read(&self, input: &Input, options: &OpenOptions) -> Result<Volume, Error> {
        let report = Report::new(&input.name);
        let (mut volume, _) = array::read(&mut input.open()?, input.length, "raw", report, options)?;
        volume.source.format = self.name();
        Ok(volume)
    }
}
