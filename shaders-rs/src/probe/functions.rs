//! The functions that [`super::apply_function`] knows. Adding one is a line.

use crate::abi::record::probe;
use crate::field::sums::{quantise, to_number};
use crate::field::tables::Segment;
use crate::math::{
    absolute, asin, atan2, clamp, dot, exp, floor_to_int, half_to_f32, length, lerp, log2, max, min, select, sqrt,
};
use crate::optics::composite::{Gathered, Layer, layer, over};
use crate::optics::specular::{cook_torrance, fresnel};
use crate::optics::step::{Kicked, flight, kick, kick_euler};
use spirv_std::glam::Vec3;

type Arguments = [f32; probe::ARGUMENTS];
type Results = [f32; probe::SIZE];

/// Names the functions and gives each the expression that computes its results from the arguments.
macro_rules! functions {
    ($($name:ident($a:ident) = $results:expr;)*) => {
        #[derive(Clone, Copy)]
        #[allow(non_camel_case_types)]
        enum Function {
            $($name,)*
        }

        /// The functions' names, by number.
        pub const NAMES: &[&str] = &[$(stringify!($name)),*];

        /// Function number `function`, applied to the arguments; zeros if there is none of that number.
        #[inline(always)]
        pub fn apply(function: u32, arguments: Arguments) -> Results {
            let mut results = [0.0; probe::SIZE];
            $(if function == Function::$name as u32 {
                let $a = arguments;
                results = $results;
            })*
            results
        }
    };
}

functions! {
    add(a) = one(a[0] + a[1]);
    multiply(a) = one(a[0] * a[1]);
    multiply_add(a) = one(a[0] * a[1] + a[2]);
    divide(a) = one(a[0] / a[1]);
    square_root(a) = one(sqrt(a[0]));
    absolute_value(a) = one(absolute(a[0]));
    minimum(a) = one(min(a[0], a[1]));
    maximum(a) = one(max(a[0], a[1]));
    clamped(a) = one(clamp(a[0], a[1], a[2]));
    selected(a) = one(select(a[0] < a[1], a[2], a[3]));
    linear(a) = one(lerp(a[0], a[1], a[2]));
    floored(a) = one(floor_to_int(a[0], -8_388_608.0, 8_388_608.0) as f32);
    half(a) = [half_to_f32(a[0].to_bits(), 4), half_to_f32(a[0].to_bits() >> 16, 0), 0.0, 0.0];
    quantised(a) = one(quantise(a[0], a[1]) as f32);
    sum_of_words(a) = one(to_number(a[0].to_bits(), a[1].to_bits()));
    exponential(a) = one(exp(a[0]));
    binary_logarithm(a) = one(log2(a[0]));
    arc_tangent(a) = one(atan2(a[0], a[1]));
    arc_sine(a) = one(asin(a[0]));
    dot_product(a) = one(dot(first(a), second(a)));
    vector_length(a) = one(length(first(a)));
    fresnel_reflectance(a) = one(fresnel(a[0], a[1], a[2]));
    reflected_radiance(a) = one(cook_torrance(first(a), second(a), Vec3::new(a[6], a[7], 1.0), 0.25, 1.0, 1.5));
    straight_flight(a) = one(flight(first(a), a[3]));
    symplectic_kick(a) = kicked(&kick(first(a), second(a), a[6], a[7], 0.5, 0.017_452));
    euler_kick(a) = kicked(&kick_euler(first(a), second(a), a[6], 0.017_452));
    segment_layer(a) = of_layer(&layer(&segment(a), a[6], a[7]));
    composited(a) = of_gathered(&over(gathered(a), &layer(&segment(a), 1.0, 1.0), second(a), first(a)));
}

#[inline(always)]
fn one(result: f32) -> Results {
    [result, 0.0, 0.0, 0.0]
}

#[inline(always)]
fn first(a: Arguments) -> Vec3 {
    Vec3::new(a[0], a[1], a[2])
}

#[inline(always)]
fn second(a: Arguments) -> Vec3 {
    Vec3::new(a[3], a[4], a[5])
}

#[inline(always)]
fn kicked(k: &Kicked) -> Results {
    [k.direction.x, k.direction.y, k.direction.z, select(k.turned, 1.0, 0.0)]
}

#[inline(always)]
fn segment(a: Arguments) -> Segment {
    Segment { particles: a[0], medium: Vec3::new(a[1], a[2], a[3]), emission: Vec3::new(a[4], a[5], a[6]), moment: 0.0 }
}

#[inline(always)]
fn of_layer(layer: &Layer) -> Results {
    [layer.clear, layer.medium.x, layer.color.x, layer.opacity]
}

#[inline(always)]
fn gathered(a: Arguments) -> Gathered {
    Gathered { color: first(a), opacity: a[7], medium: second(a) }
}

#[inline(always)]
fn of_gathered(g: &Gathered) -> Results {
    [g.color.x, g.color.y, g.medium.z, g.opacity]
}
