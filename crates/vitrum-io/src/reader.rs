//! The interface of volume file formats.

use crate::error::Error;
use crate::formats::Format;
use crate::input::Input;
use crate::options::{OpenOptions, Part};
use crate::volume::Volume;

/// One volume file format. A new one is a module of its own, an entry in `src/formats.rs` and a line in
/// [`crate::readers`].
pub trait VolumeReader: Sync {
    /// The format's name and extensions.
    fn format(&self) -> &'static Format;

    /// Whether a file is of this format by its first bytes, unpacked; of a folder, by the files in it.
    fn recognises(&self, input: &Input) -> bool;

    /// The parts of a file that [`OpenOptions`] can pick.
    fn parts(&self) -> &'static [Part] {
        &[]
    }

    /// Whether the reader unpacks files while it reads them; other readers get them unpacked.
    fn unpacks(&self) -> bool {
        false
    }

    /// Reads the volume.
    ///
    /// # Errors
    ///
    /// Those of [`crate::open`].
    fn read(&self, input: &Input, options: &OpenOptions) -> Result<Volume, Error>;
}
