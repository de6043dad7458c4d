//! NumPy's archives with one thing wrong each, and the part of the message that says so.

mod common;

use common::{check_refused, npy, npz};
use zip::CompressionMethod::{Deflated, Stored};

#[test]
fn broken_archives() {
    let array = npy("|u1", &[1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12]);
    let stored = npz(&[("a.npy", Stored, &array)]);
    let deflated = npz(&[("a.npy", Deflated, &array)]);
    // Both places that say it: before the array and in the list at the end.
    let changed = |file: &[u8], at: [usize; 2], bytes: &[u8]| {
        let mut file = file.to_vec();
        let list = file.windows(4).position(|window| window == b"PK\x01\x02").expect("a list");
        file[at[0]..at[0] + bytes.len()].copy_from_slice(bytes);
        file[list + at[1]..list + at[1] + bytes.len()].copy_from_slice(bytes);
        file
    };
    let voxel = stored.windows(3).position(|window| window == [10, 11, 12]).expect("the voxels");
    let mut wrong_sum = stored.clone();
    wrong_sum[voxel] = 99;
    let cases = vec![
        (stored[..stored.len() - 30].to_vec(), "the archive is damaged"),
        (stored[..40].to_vec(), "the archive is damaged"),
        (b"".to_vec(), "the archive is damaged"),
        (npz(&[]), "the archive holds no arrays"),
        (npz(&[("a.txt", Stored, b"abc")]), "the archive holds no arrays, which are files ending in `.npy`"),
        (npz(&[("a.npy", Stored, b"abc")]), "a.npz, array a, byte 0: this does not start with"),
        (npz(&[("a.npy", Deflated, &npy("|u1", &[1; 11]))]), "array a, byte 128: the header promises 12 bytes of data"),
        (wrong_sum, "Invalid checksum"),
        (changed(&stored, [8, 10], &[12, 0]), "compressed by"),
        (changed(&stored, [6, 8], &[1, 0]), "Password required"),
        // Sizes of which the archive or its packing cannot hold as much.
        (changed(&stored, [18, 20], &[0, 0, 0, 1, 0, 0, 0, 1]), "the header promises 16777216 bytes of data from here"),
        (changed(&deflated, [22, 24], &[0, 0, 0, 64]), "the header promises 1073741824 bytes of data, and the"),
    ];
    check_refused("a.npz", cases);
}
