//! Gradient noise and sums of its octaves.
//!
//! Only additions, multiplications and integer operations are used, so that every machine computes the same numbers.

use glam::Vec3;

/// Gradient noise (Perlin 2002) at a position: smooth, about −1 to 1, and 0 at every lattice point.
pub(super) fn gradient(position: Vec3, seed: u32) -> f32 {
    // The casts truncate; `f32::floor` would be a function call where the target has no instruction for it.
    let below = |value: f32| value as i32 - i32::from(value < (value as i32) as f32);
    let cell = position.to_array().map(below);
    let [x, y, z] = [0, 1, 2].map(|axis| position[axis] - cell[axis] as f32);
    let [u, v, w] = [x, y, z].map(|t| t * t * t * (t * (t * 6.0 - 15.0) + 10.0));
    // The hash of a corner starts with a sum over the axes, so that the eight corners share its terms.
    let terms = |axis: usize, factor: u32| {
        let term = cell[axis].cast_unsigned().wrapping_mul(factor);
        [term, term.wrapping_add(factor)]
    };
    let (along_x, along_y, along_z) = (terms(0, 0x9e37_79b1), terms(1, 0x85eb_ca77), terms(2, 0xc2b2_ae3d));
    let corner = |i: usize, j: usize, k: usize| {
        let sum = along_x[i].wrapping_add(along_y[j]).wrapping_add(along_z[k]).wrapping_add(seed);
        let slope = &SLOPES[(scatter(sum) >> 28) as usize];
        slope[0] * (x - i as f32) + slope[1] * (y - j as f32) + slope[2] * (z - k as f32)
    };
    let mix = |a: f32, b: f32, t: f32| a + (b - a) * t;
    let edge = |j: usize, k: usize| mix(corner(0, j, k), corner(1, j, k), u);
    let face = |k: usize| mix(edge(0, k), edge(1, k), v);
    mix(face(0), face(1), w)
}

/// Three independent noises as a vector.
pub(super) fn vector(position: Vec3, seed: u32) -> Vec3 {
    Vec3::new(gradient(position, seed), gradient(position, seed ^ 0x68bc_21eb), gradient(position, seed ^ 0x02e5_be93))
}

/// Fractional Brownian motion: octaves of doubling frequency and halving amplitude, the first of amplitude 1.
pub(super) fn fbm(position: Vec3, octaves: u32, seed: u32) -> f32 {
    octave_sum(position, octaves, seed, |noise| noise)
}

/// Like [`fbm`] of 1 − 2|noise|: sharp crests, as of flames and folded tissue.
pub(super) fn ridged(position: Vec3, octaves: u32, seed: u32) -> f32 {
    octave_sum(position, octaves, seed, |noise| 1.0 - 2.0 * noise.abs())
}

fn octave_sum(mut position: Vec3, octaves: u32, seed: u32, shape: impl Fn(f32) -> f32) -> f32 {
    let mut amplitude = 1.0;
    let mut sum = 0.0;
    for octave in 0..octaves {
        sum += amplitude * shape(gradient(position, seed.wrapping_add(octave)));
        amplitude *= 0.5;
        // The shift keeps the octaves' lattice points, where all noise is 0, apart.
        position = position * 2.0 + Vec3::new(17.13, 5.71, 31.37);
    }
    sum
}

/// Scatters a number over all 32 bits.
fn scatter(mut h: u32) -> u32 {
    h = (h ^ (h >> 15)).wrapping_mul(0x2c1b_3c6d);
    h = (h ^ (h >> 12)).wrapping_mul(0x297a_2d39);
    h ^ (h >> 15)
}

/// The directions to the edges of a cube, four of them twice to make sixteen.
#[rustfmt::skip]
const SLOPES: [[f32; 3]; 16] = [
    [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0], [1.0, -1.0, 0.0], [-1.0, -1.0, 0.0],
    [1.0, 0.0, 1.0], [-1.0, 0.0, 1.0], [1.0, 0.0, -1.0], [-1.0, 0.0, -1.0],
    [0.0, 1.0, 1.0], [0.0, -1.0, 1.0], [0.0, 1.0, -1.0], [0.0, -1.0, -1.0],
    [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0], [0.0, -1.0, 1.0], [0.0, -1.0, -1.0],
];

#[cfg(test)]
mod tests {
    use super::*;

    fn samples() -> impl Iterator<Item = Vec3> {
        (0..20_000).map(|i| Vec3::new(i as f32 * 0.371, i as f32 * -0.113, i as f32 * 0.0517))
    }

    #[test]
    fn gradient_noise_is_bounded_and_centred() {
        let values: Vec<f32> = samples().map(|position| gradient(position, 7)).collect();
        let mean = values.iter().sum::<f32>() / values.len() as f32;
        assert!(values.iter().all(|value| value.abs() <= 1.05), "{:?}", values.iter().copied().reduce(f32::max));
        assert!(values.iter().any(|&value| value > 0.5) && values.iter().any(|&value| value < -0.5));
        assert!(mean.abs() < 0.02, "{mean}");
    }

    #[test]
    fn gradient_noise_is_zero_at_lattice_points_and_continuous() {
        assert_eq!(gradient(Vec3::new(-3.0, 5.0, 11.0), 1), 0.0);
        for position in samples().step_by(10) {
            let step = gradient(position + Vec3::splat(1e-3), 3) - gradient(position, 3);
            assert!(step.abs() < 1e-2, "{position}: {step}");
        }
    }

    #[test]
    fn seeds_give_different_noise() {
        let differ = samples().filter(|&p| (gradient(p, 1) - gradient(p, 2)).abs() > 0.05).count();
        assert!(differ > 15_000, "{differ}");
    }

    #[test]
    fn ridges_are_where_noise_vanishes() {
        assert_eq!(ridged(Vec3::new(2.0, 3.0, 4.0), 1, 9), 1.0);
    }
}
