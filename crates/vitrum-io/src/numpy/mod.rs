//! NumPy's `.npy`, one array with a small header, and `.npz`, an archive of them.
//!
//! The format: <https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html>.

mod archive;
mod array;
mod header;
mod literal;
mod write;

pub(crate) use self::archive::Npz;
pub(crate) use self::write::write_npy;
use crate::error::{Error, Report};
use crate::formats::{self, Format};
use crate::input::Input;
use crate::options::{OpenOptions, Part};
use crate::reader::VolumeReader;
use crate::volume::Volume;

/// The reader of `.npy` files.
pub(crate) struct Numpy;

impl VolumeReader for Numpy {
    fn format(&self) -> &'static Format {
        &formats::NUMPY
    }

    fn recognises(&self, input: &Input) -> bool {
        self.format().begins(&input.head)
    }

    fn parts(&self) -> &'static [Part] {
        &[Part::Array, Part::Time]
    }

    fn read(&self, input: &Input, options: &OpenOptions) -> Result<Volume, Error> {
        let report = Report::new(&input.name);
        let part = options.array.as_deref();
        let (mut volume, _) =
            array::read(&mut input.open()?, input.length, "raw", part, report, options, Some(input.storage()))?;
        volume.source.format = self.format().name;
        Ok(volume)
    }
}
