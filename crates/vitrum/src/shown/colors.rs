//! The colours of voxels, and the factors of opacity at the gradient's magnitude.

use crate::error::Error;
use crate::preset::GradientMagnitudes;
use crate::scene::GradientFunction;
use glam::Vec3;
use rayon::prelude::*;
use vitrum_io::{Volume, linear_to_srgb, require_memory};

/// The word of a voxel without a colour of its own, as [`Volume::colors`] has it.
const NONE: u32 = u32::MAX;

/// A volume whose voxels have the factors of two-dimensional transfer functions, and the colours that it has.
///
/// # Errors
/// Where the memory does not suffice.
pub(super) fn with_gradients(volume: &Volume, functions: &[GradientFunction]) -> Result<Volume, Error> {
    let count = volume.voxel_count();
    require_memory(&format!("{}, for `transfer.gradient`", volume.name), count as u64 * 4)?;
    let [width, height, _] = volume.dimensions.map(|size| size as usize);
    let tints: Vec<Vec3> = functions.iter().map(|function| Vec3::from(function.color.map(linear_to_srgb))).collect();
    let mut colors = vec![NONE; count];
    if let Some(own) = &volume.colors {
        colors.copy_from_slice(own);
    }
    let magnitudes = GradientMagnitudes::new(volume);
    colors.par_chunks_mut(width).enumerate().for_each(|(row, colors)| {
        let (y, z) = (row % height, row / height);
        for (x, color) in colors.iter_mut().enumerate() {
            let value = magnitudes.value([x, y, z]);
            let mut applying =
                functions.iter().zip(&tints).filter(|(function, _)| function.applies_to(value)).peekable();
            if applying.peek().is_none() {
                continue;
            }
            let magnitude = magnitudes.at([x, y, z]);
            let (mut factor, mut tint) = (1.0, Vec3::ONE);
            for (function, color) in applying {
                factor *= function.factor(magnitude);
                tint *= *color;
            }
            *color = multiplied(*color, tint, factor);
        }
    });
    Ok(Volume { colors: Some(colors.into()), ..volume.clone() })
}

/// A voxel's word with factors of its colour, in sRGB, and of its opacity.
fn multiplied(word: u32, tint: Vec3, factor: f32) -> u32 {
    let factors = [tint.x, tint.y, tint.z, factor];
    let mut channels = word.to_le_bytes();
    channels
        .iter_mut()
        .zip(factors)
        .for_each(|(channel, factor)| *channel = (f32::from(*channel) * factor + 0.5) as u8);
    u32::from_le_bytes(channels)
}

/// The colours on a grid that is finer by `factors`, linear in between.
pub(super) fn refined(colors: &[u32], sizes: [u32; 3], factors: [u32; 3]) -> Vec<u32> {
    let finer = [0, 1, 2].map(|axis| sizes[axis] * factors[axis]);
    // The voxel before a new one, and the share of the way to the next.
    let place = |axis: usize, index: usize| {
        let at = ((index as f32 + 0.5) / factors[axis] as f32 - 0.5).clamp(0.0, (sizes[axis] - 1) as f32);
        (at as usize, at - libm::floorf(at))
    };
    let [width, height, _] = sizes.map(|size| size as usize);
    let channels = |[x, y, z]: [usize; 3]| {
        let [x, y, z] = [x.min(width - 1), y.min(height - 1), z.min(sizes[2] as usize - 1)];
        glam::Vec4::from(colors[(z * height + y) * width + x].to_le_bytes().map(f32::from))
    };
    let mut found = vec![NONE; finer.iter().map(|&size| size as usize).product()];
    found.par_chunks_mut(finer[0] as usize).enumerate().for_each(|(row, found)| {
        let (y, ty) = place(1, row % finer[1] as usize);
        let (z, tz) = place(2, row / finer[1] as usize);
        for (x, found) in found.iter_mut().enumerate() {
            let (x, tx) = place(0, x);
            let along = |y, z| channels([x, y, z]).lerp(channels([x + 1, y, z]), tx);
            let across = |z| along(y, z).lerp(along(y + 1, z), ty);
            let mixed = across(z).lerp(across(z + 1), tz);
            *found = u32::from_le_bytes(mixed.to_array().map(|channel| (channel + 0.5) as u8));
        }
    });
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::GradientPoint;
    use vitrum_io::Voxels;

    /// A ramp along x with 3 a voxel, on voxels that are twice as long along y.
    fn ramp() -> Volume {
        let voxels: Vec<f32> = (0..60).map(|index| (index % 5) as f32 * 3.0).collect();
        Volume::new("a ramp", [5, 4, 3], [1.0, 2.0, 1.0], Voxels::from(voxels)).expect("a volume")
    }

    #[test]
    fn factors_are_those_of_the_functions_that_apply() {
        let point = |magnitude, factor| GradientPoint { magnitude, factor };
        let of = |values, factor| GradientFunction {
            values,
            color: [1.0, 0.5, 0.0],
            opacity: vec![point(0.0, 0.0), point(8.0, factor)],
        };
        let functions = [of(Some([3.0, 6.0]), 1.0), of(Some([6.0, 9.0]), 0.5)];
        let made = with_gradients(&ramp(), &functions).expect("there is memory");
        let colors = made.colors.expect("there are factors");
        let row: Vec<[u8; 4]> = colors[..5].iter().map(|color| color.to_le_bytes()).collect();
        // A linear half is 188 of 255 in sRGB; two of them are multiplied as they are coded.
        assert_eq!(row, [[255; 4], [255, 188, 0, 128], [255, 138, 0, 32], [255, 188, 0, 64], [255; 4]]);
    }

    #[test]
    fn colors_of_a_file_stay() {
        let colors = vec![u32::from_le_bytes([10, 20, 30, 200]); 60];
        let volume = ramp().with_colors(colors).expect("as many");
        let function = GradientFunction::of_opacity(vec![GradientPoint { magnitude: 0.0, factor: 0.5 }]);
        let made = with_gradients(&volume, &[function]).expect("there is memory");
        assert_eq!(made.colors.expect("colours")[7].to_le_bytes(), [10, 20, 30, 100]);
    }

    #[test]
    fn finer_colors_are_between_those_that_were() {
        let colors = [0_u32, 200].map(|red| u32::from_le_bytes([red as u8, 0, 0, 255]));
        let found = refined(&colors, [2, 1, 1], [2, 1, 1]);
        assert_eq!(found.iter().map(|color| color & 0xff).collect::<Vec<_>>(), [0, 50, 150, 200]);
    }
}
