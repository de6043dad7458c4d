//! NumPy's archives: every array of them, packed or not.

mod common;

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use common::{Folder, npy, npy_with, npz, values};
use vitrum_io::{Error, OpenOptions, Setting, Volume};
use zip::CompressionMethod::{Deflated, Stored};

/// The archive that `numpy.savez_compressed` writes of the arrays `names`, two texts, `density`, uint8 from 0 to 11, and `heat`,
/// big-endian float16 from -1 to 1.75 in quarters, both of the shape (2, 2, 3).
const OF_NUMPY: &str = concat!(
    "UEsDBC0AAAAIAAAAIQCnL+Ds//////////8JABQAbmFtZXMubnB5AQAQAIgAAAAAAAAASwAAAAAAAACb7BfqGxDJyFDGUK2eklqc",
    "XKRupaBuE2qorqOgnpZfVFKUmBefX5SSChJ3S8wpTgWKF2ckFqQC+RpGOpo6CrUKFACuRAYGhiQgBgBQSwMELQAAAAgAAAAhAMUi",
    "hKD//////////wsAFABkZW5zaXR5Lm5weQEAEACMAAAAAAAAAFQAAAAAAAAAm+wX6hsQychQxlCtnpJanFykbqWgXlNqqK6joJ6W",
    "X1RSlJgXn1+UkgoSd0vMKU4FihdnJBakAvkaRjoKQGSsqaNQq0Ae4GJgZGJmYWVj5+Dk4gYAUEsDBC0AAAAIAAAAIQDy497Y////",
    "//////8IABQAaGVhdC5ucHkBABAAmAAAAAAAAABgAAAAAAAAAJvsF+obEMnIUMZQrZ6SWpxcpG6loG6XZqSuo6Cell9UUpSYF59f",
    "lJIKEndLzClOBYoXZyQWpAL5GkY6CkBkrKmjUKtAHuDaw7CLYQfDFgYGBhMGCwYrBhsGWwY7BnsGAFBLAQItAy0AAAAIAAAAIQCn",
    "L+DsSwAAAIgAAAAJAAAAAAAAAAAAAACAAQAAAABuYW1lcy5ucHlQSwECLQMtAAAACAAAACEAxSKEoFQAAACMAAAACwAAAAAAAAAA",
    "AAAAgAGGAAAAZGVuc2l0eS5ucHlQSwECLQMtAAAACAAAACEA8uPe2GAAAACYAAAACAAAAAAAAAAAAAAAgAEXAQAAaGVhdC5ucHlQ",
    "SwUGAAAAAAMAAwCmAAAAsQEAAAAA",
);

fn open(folder: &Folder, name: &str, array: &str) -> Result<Volume, Error> {
    let array = Some(array.to_owned());
    vitrum_io::open(&folder.path(name), &OpenOptions { array, ..OpenOptions::default() })
}

#[test]
fn what_numpy_writes_is_read() {
    let folder = Folder::new();
    let file = BASE64_STANDARD.decode(OF_NUMPY).unwrap();
    for name in ["a.npz", "no extension"] {
        // The first that can be a volume.
        let volume = folder.open(name, &file).unwrap();
        assert_eq!(values(&volume), (0..12).map(|value| value as f32).collect::<Vec<_>>());
        assert_eq!((volume.dimensions, volume.name.as_str()), ([3, 2, 2], folder.shown(name).as_str()));
        assert_eq!((volume.source.format, volume.source.encoding.as_str()), ("NumPy archive", "deflate"));
        let taken = volume.source.assumptions.iter().find(|note| note.setting == Some(Setting::Array)).unwrap();
        assert_eq!(taken.to_string(), "the array `density` was taken; others are: `names`, `heat`");
        let heat = open(&folder, name, "heat").unwrap();
        assert_eq!(values(&heat), (0..12).map(|value| value as f32 / 4.0 - 1.0).collect::<Vec<_>>());
        assert_eq!(
            (heat.source.sample_type.as_str(), heat.source.encoding.as_str()),
            ("float16", "deflate, big-endian")
        );
        assert!(heat.source.assumptions.iter().all(|note| note.setting != Some(Setting::Array)));
        assert_eq!(values(&open(&folder, name, "heat.npy").unwrap()), values(&heat));
    }
    let message = open(&folder, "a.npz", "densty").unwrap_err().to_string();
    assert!(message.contains("no array `densty`; did you mean `density`?"), "{message}");
    let message = open(&folder, "a.npz", "names").unwrap_err().to_string();
    assert!(message.starts_with(&folder.shown("a.npz, array names, byte 10: the samples are `<U1`")), "{message}");
}

#[test]
fn times_are_those_of_the_array() {
    let folder = Folder::new();
    let array = npy_with(
        (1, 0),
        "{'descr': '|u1', 'fortran_order': False, 'shape': (3, 2, 2, 3)}",
        &[[1; 12], [2; 12], [3; 12]].concat(),
    );
    for packing in [Stored, Deflated] {
        let path = folder.write("a.npz", npz(&[("a.npy", packing, &array)]));
        for time in [0, 1, 2] {
            let volume = vitrum_io::open(&path, &OpenOptions { time: Some(time), ..OpenOptions::default() }).unwrap();
            assert_eq!(values(&volume), [time as f32 + 1.0; 12]);
        }
    }
}

#[test]
fn the_limit_is_on_decoded_bytes() {
    let folder = Folder::new();
    let path = folder.write("a.npz", npz(&[("a.npy", Deflated, &npy("<f8", &[0; 96]))]));
    let open =
        |max_bytes| vitrum_io::open(&path, &OpenOptions { max_bytes: Some(max_bytes), ..OpenOptions::default() });
    assert_eq!(values(&open(48).unwrap()), [0.0; 12]);
    assert!(matches!(open(47), Err(Error::TooLarge { needed: 48, limit: 47, .. })));
}
