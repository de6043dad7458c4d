//! Pictures: linear channels in memory, and the files that they come from and go to.

mod animation;
mod exr;
mod hdr;
mod jpeg;
mod picture;
mod png;
mod read;
mod srgb;
mod tiff;
mod video;
mod write;

pub use self::animation::Animation;
pub use self::picture::{Channel, Layer, Picture};
pub use self::read::{read_picture, read_picture_with};
pub use self::srgb::{linear_to_srgb, srgb_to_linear};
pub use self::write::{WriteOptions, check_holds_vectors, check_writable, write_picture, write_picture_with};
