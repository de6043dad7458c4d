//! Changes to volumes, by the library: placement and values on grids that the program's tests do not write.

use vitrum_io::{Volume, Voxels};

#[test]
fn a_volume_of_one_voxel_stays_one() {
    let volume = || Volume::new("one", [1; 3], [2.0, 3.0, 4.0], Voxels::from(vec![7_u8])).expect("valid");
    let finer = volume().resampled([2, 3, 1], [1.0, 1.0, 4.0]).expect("valid");
    assert_eq!((finer.range, finer.origin), ([7.0, 7.0], [-0.5, -1.0, 0.0]));
    assert_eq!(volume().blurred(2.0).expect("valid").range, [7.0, 7.0]);
    let same = volume().cropped(&[0..1, 0..1, 0..1]).expect("valid");
    assert_eq!((same.range, same.origin, same.voxels), ([7.0, 7.0], [0.0; 3], Voxels::from(vec![7_u8])));
}

#[test]
fn scaled_values_stay_scaled() {
    let voxels: Vec<u16> = (0..27).collect();
    let volume = Volume::new("scaled", [3; 3], [1.0; 3], Voxels::from(voxels)).expect("valid");
    let volume = volume.with_value_mapping(2.0, -10.0).expect("valid");
    let crop = volume.clone().cropped(&[1..3, 0..3, 2..3]).expect("valid");
    assert_eq!((crop.value(0, 0, 0), crop.range), (2.0 * 19.0 - 10.0, [28.0, 42.0]));
    let mask = volume.clone().thresholded(0.0, f32::INFINITY).expect("valid");
    assert_eq!((mask.value(2, 1, 0), mask.value(1, 1, 0)), (1.0, 0.0), "5 is 0, 4 is -2");
    let picked = volume.picked(&[-10.0, 42.0]).expect("valid");
    assert_eq!((picked.range, picked.value(1, 1, 1)), ([-10.0, 42.0], 0.0));
}
