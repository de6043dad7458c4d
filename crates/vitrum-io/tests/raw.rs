//! Headerless voxels: every type and byte order comes back by its name, plain and gzipped.

mod common;

use common::{Folder, check, gzip, samples};
use vitrum_io::Voxels;

#[test]
fn every_type_and_endian_comes_back() {
    let folder = Folder::new();
    for sample in samples() {
        for (order, data) in [("_le", &sample.little), ("_be", &sample.big)] {
            let name = format!("name_3x2x2_{}{order}", sample.name);
            check(&folder.open(&format!("{name}.raw"), data).unwrap(), &sample);
            check(&folder.open(&format!("{name}.BIN"), data).unwrap(), &sample);
            check(&folder.open(&format!("{name}.raw.gz"), gzip(data)).unwrap(), &sample);
            // The content decides: gzip without `.gz` is no obstacle.
            check(&folder.open(&format!("{name}.raw"), gzip(data)).unwrap(), &sample);
        }
        let volume = folder.open(&format!("name_3x2x2_{}.raw", sample.name), &sample.little).unwrap();
        check(&volume, &sample);
        let noted = volume.source.assumptions.iter().any(|note| note.fact.contains("little-endian was taken"));
        assert_eq!(noted, sample.size > 1);
    }
}

#[test]
fn the_type_may_be_guessed_where_a_voxel_is_a_byte() {
    let volume = Folder::new().open("head3x2x2.raw", [7; 12]).unwrap();
    assert_eq!(volume.voxels, Voxels::U8(vec![7; 12].into()));
    assert_eq!((volume.spacing, volume.origin), ([1.0; 3], [-1.0, -0.5, -0.5]));
    assert_eq!((volume.source.format, volume.source.encoding.as_str()), ("raw voxels", "raw"));
    assert!(volume.source.assumptions.iter().any(|note| note.fact.contains("uint8 was taken")));
}
