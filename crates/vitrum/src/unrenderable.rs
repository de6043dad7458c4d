//! Why a valid scene and its data make no frame.

use crate::suggest::nearest;
use std::path::PathBuf;

/// Why a scene and its data, each valid by itself, make no frame together. The display states the fact and the limit;
/// [`advice`](Self::advice) says what to change.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Unrenderable {
    /// The environment is a map without a picture.
    #[error("environment.kind is \"map\" but environment.file is not given")]
    NoEnvironmentMap,
    /// A volume or a mesh is named twice.
    #[error("a {kind} has both a file and a builtin")]
    TwoSources {
        /// `volume` or `mesh`.
        kind: &'static str,
    },
    /// A volume or a mesh is not named.
    #[error("a {kind} has neither a file nor a builtin")]
    NoSource {
        /// `volume` or `mesh`.
        kind: &'static str,
    },
    /// Built-in data of an unknown name.
    #[error("there is no built-in {kind} `{name}`")]
    UnknownBuiltin {
        /// `volume` or `mesh`.
        kind: &'static str,
        /// The name that was asked for.
        name: String,
        /// The names of the built-in data of that kind.
        known: Vec<&'static str>,
    },
    /// Built-in data is not part of this build.
    #[error("the built-in {kind} `{name}` is not in this build (feature `builtin`)")]
    BuiltinLeftOut {
        /// `volume` or `mesh`.
        kind: &'static str,
        /// The name that was asked for.
        name: String,
    },
    /// A value in a small language of its own, such as `volume.raw`, cannot be understood.
    #[error("{problem}")]
    Syntax {
        /// The fact, and what was expected.
        problem: String,
    },
    /// The method shows a mesh.
    #[error("the method `{method}` shows a mesh, and volumes were given")]
    NeedsMesh {
        /// The method.
        method: &'static str,
    },
    /// The data for a sweep is no volume.
    #[error("a sweep goes through volumes, and a mesh was given")]
    NeedsVolume,
    /// A mesh of triangles without area.
    #[error("{name}: none of its {count} triangles has an area")]
    NoSurface {
        /// The mesh.
        name: String,
        /// The number of its triangles.
        count: usize,
    },
    /// A mesh whose vertices are all at one point.
    #[error("{name}: all vertices are at one point or too close to each other")]
    NoExtent {
        /// The mesh.
        name: String,
    },
    /// The mesh has more triangles than sums over them have room for.
    #[error("{name}: {count} triangles are too many to fill")]
    TooManyToFill {
        /// The mesh.
        name: String,
        /// The number of its triangles.
        count: usize,
    },
    /// Meshes that are shown together have more vertices than indices of 32 bits tell apart.
    #[error("{name}: {vertices} vertices, at most {limit} are possible")]
    TooManyVertices {
        /// The meshes.
        name: String,
        /// Their vertices.
        vertices: usize,
        /// The most that are possible.
        limit: u32,
    },
    /// The tree has no room for so many triangles.
    #[error("rays look for {count} triangles, and can tell {limit} apart")]
    TooManyTriangles {
        /// The triangles.
        count: usize,
        /// The most that are possible.
        limit: usize,
    },
    /// The mesh has more clear materials than rays can tell apart.
    #[error("{name}: {count} clear materials, at most {limit} are possible")]
    TooManyMaterials {
        /// The mesh.
        name: String,
        /// The number of its clear materials.
        count: usize,
        /// The most that are possible.
        limit: usize,
    },
    /// A grid of voxels is finer or more padded than possible.
    #[error("{resolution} voxels with {padding} around them, expected 1 to {most_voxels} and at most {most_padding}")]
    VoxelCount {
        /// Voxels along the longest edge.
        resolution: u32,
        /// Voxels around the mesh.
        padding: u32,
        /// The most along the longest edge.
        most_voxels: u32,
        /// The most around the mesh.
        most_padding: u32,
    },
    /// Voxels overlap by less than nothing or by more than themselves.
    #[error("an overlap of {overlap}, expected 0 to 1")]
    Overlap {
        /// The overlap, as a part of a voxel's edge.
        overlap: f32,
    },
    /// Voxels for which the host lacks the memory.
    #[error("there is no memory for {} x {} x {} voxels", dimensions[0], dimensions[1], dimensions[2])]
    NoMemory {
        /// Voxels along x, y and z.
        dimensions: [u32; 3],
    },
    /// The voxels of a mesh are more than a kernel can address.
    #[error(
        "{} x {} x {} voxels of {materials} clear materials take {bytes} bytes, rays can address 2^31",
        dimensions[0], dimensions[1], dimensions[2]
    )]
    TooManyVoxels {
        /// Voxels along x, y and z.
        dimensions: [u32; 3],
        /// Clear materials.
        materials: usize,
        /// Bytes of all.
        bytes: u64,
    },
    /// The shadow map is larger than a kernel can address.
    #[error(
        "a shadow map of {} x {} x {} voxels takes {bytes} bytes, rays can address 2^31",
        dimensions[0], dimensions[1], dimensions[2]
    )]
    ShadowMapTooLarge {
        /// Voxels along the light and across it.
        dimensions: [u32; 3],
        /// Bytes of all.
        bytes: u64,
    },
    /// A soft shadow takes more columns of the shadow map than a look-up may.
    #[error("shadow.filter_radius = {radius} is {voxels:.1} voxels of the shadow map, at most {limit} are possible")]
    ShadowTooSoft {
        /// The radius of the filter, in world units.
        radius: f64,
        /// The width in voxels.
        voxels: f64,
        /// The most voxels.
        limit: i32,
    },
    /// The beams of a light, the tree over them, or optical depths along them are larger than a kernel can address.
    #[error(
        "beams.rays = {rays}, beams.segments = {segments} and beams.adaptive = {adaptive} make records of beams of {bytes} bytes, kernels can address 2^33"
    )]
    TooManyBeams {
        /// Rays of light along each edge of the lattice.
        rays: u32,
        /// Straight pieces of a ray's ways that become beams.
        segments: u32,
        /// Whether texels of the lattice are split, which takes four times as much.
        adaptive: bool,
        /// Bytes of the largest of these.
        bytes: u64,
    },
    /// More clipping planes than a sweep can have.
    #[error("{count} clipping planes are given, at most {limit} are possible")]
    TooManyClips {
        /// The planes.
        count: usize,
        /// The most that are possible.
        limit: usize,
    },
    /// A crop box across the axes of the second volume.
    #[error("{name}: `crop` is a box along the axes of the volume that is shown, and those of `ior_volume` are others")]
    ObliqueCrop {
        /// The second volume.
        name: String,
    },
    /// A direction has no length.
    #[error("{key} has no length")]
    NoDirection {
        /// The scene key.
        key: String,
    },
    /// The planes of a sweep are too close together.
    #[error("sweep.sample_distance = {sample_distance} makes {planes} planes; at most {limit} are possible")]
    TooManyPlanes {
        /// The distance of the planes, in voxels.
        sample_distance: f32,
        /// The planes that this makes.
        planes: f64,
        /// The most that are possible.
        limit: f64,
    },
    /// A volume that is behind the camera as a whole.
    #[error("the whole volume is behind the camera")]
    BehindCamera,
    /// A point or spot that casts shadows stands in the box around the mesh, and perhaps in a body.
    #[error(
        "{} at {position:?} stands inside the box around the mesh, from {low:?} to {high:?}, or less than {distance:.2e} away from it: light that casts shadows comes from outside",
        light(.index)
    )]
    LightInMesh {
        /// The number of the light, where it is known.
        index: Option<usize>,
        /// The light's position, in the world.
        position: [f32; 3],
        /// The low corner of the box.
        low: [f32; 3],
        /// The high corner of the box.
        high: [f32; 3],
        /// The least distance from the box, in world units.
        distance: f32,
    },
    /// A point or spot that casts shadows in a sweep stands in the box around the volume, or next to it.
    #[error(
        "{} at {position:?} stands inside the box around the volume, or so close to it that parts are seen from there more than {limit}° off the middle: light that casts shadows comes from outside",
        light(.index)
    )]
    LightInVolume {
        /// The number of the light, where it is known.
        index: Option<usize>,
        /// The light's position, in the world.
        position: [f32; 3],
        /// The widest angle, in degrees.
        limit: f64,
    },
    /// A second volume gives the index of refraction of a volume with colours.
    #[error("{name} has colours, or factors by its gradient, and its index of refraction comes from another volume")]
    ColorsBeside {
        /// The volume with colours.
        name: String,
    },
    /// Bodies within a volume, and something that takes the place of their voxels.
    #[error("the bodies of {name} within the volume are not shown beside {beside}")]
    BodiesBeside {
        /// The mesh of the bodies.
        name: String,
        /// The other thing.
        beside: &'static str,
    },
    /// Opaque and clear bodies within a volume.
    #[error("{name} has opaque and clear bodies, and bodies within a volume are all opaque or all clear")]
    MixedBodies {
        /// The mesh of the bodies.
        name: String,
    },
    /// A volume with colours, or with two-dimensional transfer functions, is larger than what the device takes in one piece.
    #[error("{name}: {bytes} bytes of values, colours and bodies are more than the device takes in one piece")]
    ColorsTooLarge {
        /// The volume.
        name: String,
        /// Bytes of voxels and colours.
        bytes: u64,
    },
    /// Labels of parts are to be interpolated.
    #[error("volume.interpolation is \"cubic\", and the values of {name} are labels, which have nothing between them")]
    CubicLabels {
        /// The volume.
        name: String,
    },
    /// The picture that a spot projects is not among the assets.
    #[error("light.{index}.texture is {}, and the assets have no picture of that name", path.display())]
    NoTexture {
        /// The number of the light.
        index: usize,
        /// The path by which the scene names the picture.
        path: PathBuf,
    },
    /// The mask of a volume is not among the assets.
    #[error("volume.mask is given, and the assets have no volume for it")]
    NoMask,
    /// A mask lies beside the volume.
    #[error("volume.mask: {name}: the mask and the volume do not overlap")]
    MaskBeside {
        /// The mask.
        name: String,
    },
    /// A mask hides the whole volume.
    #[error("volume.mask: {name}: nothing of the volume is left; the mask's values are {labels}")]
    MaskHidesAll {
        /// The mask.
        name: String,
        /// Its values.
        labels: String,
    },
    /// There is no value that a hidden voxel could have.
    #[error(
        "volume.mask: {name}: the transfer function shows something at every value, so that no voxel can be hidden"
    )]
    NothingInvisible {
        /// The volume.
        name: String,
    },
    /// The volume of a medium's density is not among the assets.
    #[error("medium.density is given, and the assets have no volume for it")]
    NoDensity,
    /// The volume of a medium's density has an axis that is along none of the world's.
    #[error("medium.density: {name}: an axis of the volume is {angle:.2}° off the world's axes")]
    ObliqueDensity {
        /// The volume.
        name: String,
        /// The angle, in degrees.
        angle: f64,
    },
    /// The volume of a medium's density has a value that is NaN or infinite.
    #[error("medium.density: {name}: the value at voxel ({}, {}, {}) is {value}, expected a finite number", voxel[0], voxel[1], voxel[2])]
    DensityNotFinite {
        /// The volume.
        name: String,
        /// The first such voxel.
        voxel: [u32; 3],
        /// Its value.
        value: f32,
    },
    /// A medium's density is below 0.
    #[error(
        "medium.density: {name}: the value at voxel ({}, {}, {}) is {value}, and a density is at least 0; the values are from {} to {}",
        voxel[0], voxel[1], voxel[2], range[0], range[1]
    )]
    NegativeDensity {
        /// The volume.
        name: String,
        /// The first such voxel.
        voxel: [u32; 3],
        /// Its value.
        value: f32,
        /// The least and the greatest value of all voxels.
        range: [f32; 2],
    },
    /// The environment's picture and those that spots project are larger together than kernels can address.
    #[error("{}: with it the pictures of the environment and of spots have {texels} texels, kernels can address 715827882", path.display())]
    PicturesTooLarge {
        /// The picture that is too much.
        path: PathBuf,
        /// Texels of all.
        texels: u64,
    },
    /// The light of a sweep shines across the viewing direction or against it.
    #[error(
        "{} travels at {}° to the viewing direction, at most {limit}° are possible: it must shine away from the camera",
        index.map_or("a light in the place of the environment".to_owned(), |index| format!("light.{index}")),
        beyond(.angle, .limit)
    )]
    ObliqueLight {
        /// The number of the light; none for one in the place of the environment.
        index: Option<usize>,
        /// The angle, in degrees.
        angle: f64,
        /// The greatest angle, in degrees.
        limit: f64,
    },
}

impl Unrenderable {
    /// Advice in terms of scene keys and data, in one sentence.
    #[must_use]
    pub fn advice(&self) -> String {
        match self {
            Self::NoEnvironmentMap => "name an equirectangular picture".to_owned(),
            Self::TwoSources { .. } => "keep one".to_owned(),
            Self::NoSource { .. } => "give one of them".to_owned(),
            Self::UnknownBuiltin { known, name, .. } => match nearest(name, known.iter().copied()) {
                Some(near) => format!("did you mean `{near}`?"),
                None => format!("there are {}", known.join(", ")),
            },
            Self::BuiltinLeftOut { .. } => "name a file".to_owned(),
            Self::Syntax { .. } => "correct it".to_owned(),
            Self::NeedsMesh { .. } => "give a mesh, or take the method `sweep`".to_owned(),
            Self::NeedsVolume => "give a volume".to_owned(),
            Self::NoSurface { .. } => "give a mesh that has a surface".to_owned(),
            Self::NoExtent { .. } => "scale the mesh up".to_owned(),
            Self::TooManyToFill { .. } => "simplify the mesh".to_owned(),
            Self::TooManyVertices { .. } => "simplify the meshes".to_owned(),
            Self::TooManyTriangles { .. } => {
                "simplify the mesh, or make it clear and set `voxels.surfaces` to `multi`".to_owned()
            }
            Self::TooManyMaterials { .. } => "merge some, or make them opaque (`material`)".to_owned(),
            Self::VoxelCount { .. } => "choose another resolution".to_owned(),
            Self::Overlap { .. } => "choose another".to_owned(),
            Self::NoMemory { .. } => "choose a lower resolution".to_owned(),
            Self::TooManyVoxels { .. } => "lower `voxelization.resolution`".to_owned(),
            Self::ShadowMapTooLarge { .. } => "lower `shadow.resolution`".to_owned(),
            Self::ShadowTooSoft { .. } => "lower `shadow.resolution`, of which a soft shadow needs less".to_owned(),
            Self::TooManyBeams { adaptive: true, .. } => {
                "set `beams.adaptive = false`, or lower `beams.segments` or `beams.rays`".to_owned()
            }
            Self::TooManyBeams { .. } => "lower `beams.segments` or `beams.rays`".to_owned(),
            Self::TooManyClips { .. } => "leave some out".to_owned(),
            Self::ObliqueCrop { .. } => "cut by `clip` instead".to_owned(),
            Self::NoDirection { .. } => "give three numbers that are not all 0".to_owned(),
            Self::TooManyPlanes { .. } => "make it larger".to_owned(),
            Self::BehindCamera => "move camera.position or camera.target".to_owned(),
            Self::LightInMesh { index, .. } => {
                let key = index.map_or("its `".to_owned(), |index| format!("`light.{index}."));
                format!("move the light out of the box, or set {key}shadows = false`: it then shines through the mesh")
            }
            Self::LightInVolume { index, .. } => {
                let key = index.map_or("its `".to_owned(), |index| format!("`light.{index}."));
                format!(
                    "move the light away from the volume, or set {key}shadows = false`: it then shines through the volume"
                )
            }
            Self::NoTexture { .. } => {
                "add the picture to `Assets::textures`, or read the assets by `Assets::load`".to_owned()
            }
            Self::NoMask => "set `Assets::mask`, or read the assets by `Assets::load`".to_owned(),
            Self::MaskBeside { .. } => {
                "name the segmentation of this volume, or one whose file says where in the world it lies".to_owned()
            }
            Self::MaskHidesAll { .. } => "name some of them in `volume.mask.labels`".to_owned(),
            Self::NothingInvisible { .. } => {
                "give `transfer.opacity` a point of opacity 0, with a white `filter` and the index of the surroundings"
                    .to_owned()
            }
            Self::ColorsBeside { .. } => {
                "leave `ior_volume` out, or show a volume without colours, and no `transfer.gradient`".to_owned()
            }
            Self::BodiesBeside { .. } => {
                "leave `mesh` out, or show a volume without these; opaque bodies may be in a scan that bends light, and clear ones in any that does not (`--preset bone`)".to_owned()
            }
            Self::MixedBodies { .. } => "give one entry of `material` for all, such as `material.0.opaque=true`".to_owned(),
            Self::ColorsTooLarge { .. } => {
                "leave `transfer.gradient` out, take one number of each colour (`--array norm`), or make the volume smaller by `vitrum convert`"
                    .to_owned()
            }
            Self::CubicLabels { .. } => "set `volume.interpolation = \"nearest\"`".to_owned(),
            Self::NoDensity => "set `Assets::density`, or read the assets by `Assets::load`".to_owned(),
            Self::ObliqueDensity { .. } => {
                "resample the volume along the world's axes, or save it without its directions".to_owned()
            }
            Self::DensityNotFinite { .. } => "replace it by a finite value, such as the background's".to_owned(),
            Self::NegativeDensity { range: [low, high], .. } => {
                let high = high.max(0.0);
                format!(
                    "say at which values the density is 0 and 1, as in `medium.density_window = [{low:?}, {high:?}]`"
                )
            }
            Self::PicturesTooLarge { .. } => "make it smaller".to_owned(),
            Self::ObliqueLight { index: None, .. } => {
                "set `sweep.light = \"forward\"`, which carries light of all directions, or `environment.lights = 0`"
                    .to_owned()
            }
            Self::ObliqueLight { index: Some(index), .. } => {
                let key = format!("light.{index}");
                format!("turn {key}.azimuth or {key}.elevation towards 0, or use {key}.attachment = \"camera\"")
            }
        }
    }
}

/// A light, by its key where its number is known.
fn light(index: &Option<usize>) -> String {
    index.map_or("the light".to_owned(), |index| format!("light.{index}"))
}

/// The angle, in degrees, with as many decimals as show that it is not `limit`, and at least one.
fn beyond(angle: &f64, limit: &f64) -> String {
    let written = |decimals: usize| format!("{angle:.decimals$}");
    (1..15).map(written).find(|text| text.parse() != Ok(*limit)).unwrap_or_else(|| written(15))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_angle_is_never_written_as_its_limit() {
        let message = |angle| Unrenderable::ObliqueLight { index: Some(0), angle, limit: 85.0 }.to_string();
        assert!(message(92.25).contains("at 92.2° to"));
        assert!(message(85.001).contains("at 85.001° to") && message(85.001).contains("at most 85° are"));
        assert!(message(85.04).contains("at 85.04° to"));
    }
}
