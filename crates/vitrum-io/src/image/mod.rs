//! Pictures: linear channels in memory, and the files that they come from and go to.

#[cfg(all(feature = "animations", not(target_family = "wasm")))]
mod animation;
mod check;
#[cfg(feature = "exr")]
mod exr;
mod format;
#[cfg(feature = "hdr")]
mod hdr;
#[cfg(feature = "jpeg")]
mod jpeg;
mod options;
mod picture;
#[cfg(feature = "png")]
mod png;
#[cfg(any(feature = "png", feature = "hdr", feature = "jpeg", feature = "tiff"))]
mod raster;
mod read;
mod size;
mod srgb;
#[cfg(feature = "tiff")]
mod tiff;
#[cfg(all(feature = "animations", not(target_family = "wasm")))]
mod video;
mod write;

#[cfg(all(feature = "animations", not(target_family = "wasm")))]
pub use self::animation::Animation;
pub use self::format::PictureFormat;
pub use self::options::WriteOptions;
pub use self::picture::{Channel, Layer, Picture};
pub use self::read::{read_picture, read_picture_bytes, read_picture_with};
pub use self::srgb::{linear_to_srgb, srgb_to_linear};
pub use self::write::{
    check_holds_lengths, check_holds_vectors, check_writable, encode_picture, stage_picture_with, write_picture,
    write_picture_with,
};
