//! The named outputs of a frame.

use crate::scene::Method;

/// A named output of a frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Output {
    /// Its name.
    pub name: &'static str,
    /// The methods whose frames have it.
    pub methods: &'static [Method],
    /// What it is, with its unit and range.
    pub description: &'static str,
    /// Whether it holds vectors, which may be negative.
    pub is_vector: bool,
}

const SWEEP: &[Method] = &[Method::Sweep];
const VOXELS: &[Method] = &[Method::Voxels];
const BOTH: &[Method] = &[Method::Sweep, Method::Voxels];

const fn output(name: &'static str, methods: &'static [Method], description: &'static str) -> Output {
    Output { name, methods, description, is_vector: false }
}

const fn vector(name: &'static str, methods: &'static [Method], description: &'static str) -> Output {
    Output { name, methods, description, is_vector: true }
}

/// Every output, in the order in which a picture has them.
pub(super) const ALL: &[Output] = &[
    output("color", BOTH, "linear radiance and coverage (RGBA)"),
    output("opacity", SWEEP, "opacity A of particles and receivers, 0 to 1"),
    output(
        "transmittance",
        BOTH,
        "share of light that is left on the way: of a volume behind its filter, of a mesh behind absorption and reflection, RGB, 0 to 1",
    ),
    output(
        "depth",
        BOTH,
        "opacity-weighted mean depth from the eye along the viewing direction, world units; 0 where nothing is opaque; of a mesh that of the first surface",
    ),
    vector("direction", BOTH, "final unit direction of the ray in view space (looking along -z)"),
    vector("position", SWEEP, "final position of the ray in view space, world units"),
    output(
        "status",
        BOTH,
        "0 the ray went through, 1 it became opaque or met a receiver, 2 it turned back or grazed; through a mesh: 1 it left, 2 it was still inside, 3 it met an opaque body or a receiver",
    ),
    vector("normal", VOXELS, "of a mesh: unit normal at the first surface in view space, 0 where there is none"),
    output("bounces", VOXELS, "of a mesh: surfaces at which the ray was refracted or reflected"),
    output("path_length", VOXELS, "of a mesh: length of the ray's way inside, world units"),
    output("reflectance", VOXELS, "of a mesh: share of the light that the first surface reflects, 0 to 1"),
    output("light", SWEEP, "light on the last plane, in the light grid's own texels, RGB"),
];
