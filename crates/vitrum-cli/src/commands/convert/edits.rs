//! The changes that `vitrum convert` makes to a volume.

use super::Arguments;
use crate::failure::{Failure, Status};
use crate::volume::Spacing;
use std::ops::Range;
use std::str::FromStr;
use vitrum::io::{Error, Volume};

/// `--crop X0:X1,Y0:Y1,Z0:Z1`; what is left out is `None`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Crop([[Option<u32>; 2]; 3]);

impl FromStr for Crop {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let end = |text: &str| match text.trim() {
            "" => Some(None),
            number => number.parse().ok().map(Some),
        };
        let range = |text: &str| {
            let (start, stop) = text.split_once(':')?;
            Some([end(start)?, end(stop)?])
        };
        let ranges = text.split(',').map(range).collect::<Option<Vec<_>>>();
        ranges.and_then(|ranges| ranges.try_into().ok()).map(Self).ok_or_else(|| {
            "expected three ranges of indices, such as 10:50,0:64,: with the end behind the last voxel".to_owned()
        })
    }
}

/// `--labels 3,4,7`.
#[derive(Debug, Clone, PartialEq)]
pub struct Labels(Vec<f32>);

impl FromStr for Labels {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let labels = text.split(',').map(|label| label.trim().parse::<f32>().ok().filter(|label| label.is_finite()));
        labels.collect::<Option<_>>().map(Self).ok_or_else(|| "expected values, such as 3,4,7".to_owned())
    }
}

/// `--size X,Y,Z`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Voxels([u32; 3]);

impl FromStr for Voxels {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let numbers = text.split([',', 'x']).map(|number| number.trim().parse().ok().filter(|number| *number > 0));
        let numbers = numbers.collect::<Option<Vec<u32>>>().and_then(|numbers| numbers.try_into().ok());
        numbers.map(Self).ok_or_else(|| "expected three numbers of voxels, such as 128,128,64".to_owned())
    }
}

/// `--threshold LOW[,HIGH]`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Threshold([f32; 2]);

impl FromStr for Threshold {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let (low, high) = text.split_once(',').unwrap_or((text, "inf"));
        match [low, high].map(|end| end.trim().parse::<f32>()) {
            [Ok(low), Ok(high)] if low <= high => Ok(Self([low, high])),
            _ => Err("expected a value, or two with the lower one first, such as 300 or 300,1200".to_owned()),
        }
    }
}

/// The volume with the changes that the flags ask for, in the order in which the command's help describes them.
pub fn apply(arguments: &Arguments, mut volume: Volume) -> Result<Volume, Failure> {
    // What is wrong with a flag is a matter of use, and not of the input.
    let told = |error: Error| match error {
        error @ Error::Invalid { .. } => Failure::output(&error),
        error => error.into(),
    };
    if let Some(Crop(ranges)) = &arguments.crop {
        let sizes = volume.dimensions;
        let range = |axis: usize| -> Range<u32> {
            let [start, stop] = ranges[axis];
            start.unwrap_or(0)..stop.unwrap_or(sizes[axis])
        };
        volume = volume.cropped(&[range(0), range(1), range(2)]).map_err(told)?;
    }
    if let Some(Labels(labels)) = &arguments.labels {
        volume = volume.picked(labels).map_err(told)?;
        if volume.range == [0.0, 0.0] {
            let help = "`vitrum info` shows the range of the values";
            return Err(Failure::new(Status::WrongUse, "no voxel has one of the --labels", help));
        }
    }
    if let Some((dimensions, spacing)) = grid(arguments, &volume)? {
        volume = match arguments.labels {
            Some(_) => volume.resampled_nearest(dimensions, spacing),
            None => volume.resampled(dimensions, spacing),
        }
        .map_err(told)?;
    }
    if let Some(sigma) = arguments.blur {
        volume = volume.blurred(sigma).map_err(told)?;
    }
    if let Some(Threshold([low, high])) = arguments.threshold {
        volume = volume.thresholded(low, high).map_err(told)?;
    }
    Ok(volume)
}

/// Numbers and distances of voxels.
type Grid = ([u32; 3], [f32; 3]);

/// The grid that `--resample` or `--size` asks for.
fn grid(arguments: &Arguments, volume: &Volume) -> Result<Option<Grid>, Failure> {
    let extent = volume.extent();
    if let Some(Voxels(dimensions)) = arguments.size {
        return Ok(Some((dimensions, [0, 1, 2].map(|axis| extent[axis] / dimensions[axis] as f32))));
    }
    let Some(Spacing(spacing)) = arguments.resample else { return Ok(None) };
    let dimensions = [0, 1, 2].map(|axis| (extent[axis] / spacing[axis]).round().max(1.0));
    if dimensions.iter().any(|&size| size > 65536.0) {
        let message = format!("--resample gives {} x {} x {} voxels", dimensions[0], dimensions[1], dimensions[2]);
        return Err(Failure::new(Status::WrongUse, message, "choose larger distances, in the unit of `vitrum info`"));
    }
    Ok(Some((dimensions.map(|size| size as u32), spacing)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn flags_are_numbers_in_order() {
        assert_eq!("1:2, :5,:".parse(), Ok(Crop([[Some(1), Some(2)], [None, Some(5)], [None, None]])));
        assert_eq!("-3".parse(), Ok(Threshold([-3.0, f32::INFINITY])));
        assert_eq!("2,5".parse(), Ok(Threshold([2.0, 5.0])));
        assert_eq!("3, 4".parse(), Ok(Labels(vec![3.0, 4.0])));
        assert_eq!("3,4,5".parse(), Ok(Voxels([3, 4, 5])));
        assert!(["1:2", "1:2,3:4", "a:b,:,:", "1,2,3", "-1:2,:,:"].iter().all(|wrong| wrong.parse::<Crop>().is_err()));
        assert!(["", "a", "5,2", "nan"].iter().all(|wrong| wrong.parse::<Threshold>().is_err()));
        assert!(["", "3,", "inf"].iter().all(|wrong| wrong.parse::<Labels>().is_err()));
        assert!(["", "1,2", "0,1,1", "1,2,-3"].iter().all(|wrong| wrong.parse::<Voxels>().is_err()));
    }
}
