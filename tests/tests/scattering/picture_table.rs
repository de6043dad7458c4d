//! Radiance that fog scatters once, around a clear ball and out of the ball's light, as a picture.
//!
//! A ball of radius 1 and index 1.5 around the origin; fog of σ_s = 0.1, σ_a = 0.02 and g = 0 in |x|, |y| ≤ 12, −3 ≤ z
//! ≤ 12; a lamp of 40 W at (0, 0, 4); seen from (0, −9, 0.5) towards (0, 0, −0.3), 40° high. Viewing rays end at the
//! ball. The sum of airlight in closed form, less the ball's shadow, and light that the ball refracts twice, or mirrors
//! outside, once or twice inside, each integrated by quadrature as a mean over the area of 128 × 128 pixels.

/// Pixels along each edge: means over 8 × 8 of those.
pub const EDGE: usize = 16;

/// The unit of the numbers below, in W / (sr · world unit²).
pub const UNIT: f64 = 1e-7;

/// Row by row from the top. The picture is its own mirror image, and this is its left half.
#[rustfmt::skip]
pub const LEFT: [[u32; EDGE / 2]; EDGE] = [
    [41641, 48863, 58138, 70288, 86149, 106040, 127820, 143835],
    [38216, 44151, 51521, 60538, 71357, 83468, 95018, 102486],
    [34793, 39516, 45253, 51856, 59199, 66747, 73325, 77275],
    [31476, 35221, 39541, 44462, 49504, 54346, 58331, 60624],
    [28386, 31318, 34563, 38135, 41775, 45023, 47637, 46801],
    [25581, 27871, 30329, 32877, 35591, 37789, 29042, 22120],
    [23072, 24859, 26732, 28624, 30513, 28661, 19214, 18569],
    [20849, 22248, 23684, 25111, 26485, 23062, 16807, 16394],
    [18895, 19994, 21103, 22188, 23203, 21002, 15109, 14644],
    [17179, 18045, 18906, 19733, 20388, 18382, 16393, 19139],
    [15588, 16262, 16922, 17542, 17664, 15812, 15176, 27396],
    [14038, 14545, 15036, 15496, 15117, 13734, 13677, 23678],
    [12523, 12890, 13245, 13587, 12791, 11940, 12288, 19936],
    [11095, 11348, 11597, 11804, 10782, 10501, 11168, 16777],
    [9813, 9977, 10138, 10193, 9686, 9603, 9893, 11611],
    [8707, 8807, 8901, 8986, 8924, 8795, 8732, 8718],
];
