//! The input that a person names, and the flags that change its scene.

use crate::complete;
use crate::failure::{Failure, Status};
use crate::size::Size;
use crate::transfer::TransferArguments;
use crate::volume::VolumeArguments;
use clap::Args;
use std::path::{Path, PathBuf};
use vitrum::composition::{Composed, Composition, Opened, Quality, Side, open};
use vitrum::io::{Mesh, OpenOptions, Up, Volume};
use vitrum::scene::{Hides, Mask, MeshSource, VolumeSource};
use vitrum::suggest::nearest;
use vitrum::{builtin, load_mesh, load_meshes, load_volume, preset};

/// The input and the flags that change its scene.
#[derive(Debug, Args)]
pub struct SceneArguments {
    /// A scene file (.toml), a volume file, a mesh (.obj, .ply, .stl, .gltf, .glb), a folder of DICOM files, `-` for a volume from standard input, or builtin:NAME
    /// (`vitrum scenes` lists them)
    #[arg(add = complete::inputs())]
    pub input: String,

    #[command(flatten)]
    pub volume: VolumeArguments,

    /// Give the scene the look of a preset (`vitrum presets` lists them); without it volume files take the one that suits their contents, and meshes what their file says or glass
    #[arg(long, value_name = "NAME", add = complete::presets())]
    pub preset: Option<String>,

    /// Put meshes into a medium and show the beams of light in it
    #[arg(long, value_name = "NAME", add = complete::media(), long_help = medium_help())]
    pub medium: Option<String>,

    /// Look at the patient from a side: anterior, posterior, left, right, superior or inferior; before --set
    #[arg(long, value_name = "SIDE")]
    pub view: Option<Side>,
    #[command(flatten)]
    pub transfer: TransferArguments,

    /// Hide what has no label in a segmentation of the volume, a volume file on the same grid or another
    #[arg(long, value_name = "FILE")]
    pub mask: Option<PathBuf>,

    /// Labels of the parts of --mask that are shown, such as 1,3; else all but 0
    #[arg(long, value_name = "LABEL,LABEL", value_delimiter = ',', requires = "mask")]
    pub mask_labels: Vec<f32>,

    /// Set a scene key, such as light.0.angular_radius=3; repeatable, applied in order, after --preset and --medium
    #[arg(long, value_name = "KEY=VALUE", add = complete::settings())]
    pub set: Vec<String>,

    /// Viewing rays: draft has one for each pixel, good more where neighbouring pixels differ, best four times as many. Without it a scene file's own
    /// keys stand (film.supersampling, film.refinement), and everything else is good
    #[arg(long, value_enum, value_name = "QUALITY")]
    pub quality: Option<QualityName>,

    /// Pixels across and down, such as 1024x768
    #[arg(long, value_name = "WxH")]
    pub size: Option<Size>,
}

/// Names of qualities.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum QualityName {
    /// One ray for each pixel
    Draft,
    /// More rays where neighbouring pixels differ
    Good,
    /// Four times as many rays
    Best,
}

impl QualityName {
    fn quality(self) -> Quality {
        match self {
            Self::Draft => Quality::Draft,
            Self::Good => Quality::Good,
            Self::Best => Quality::Best,
        }
    }
}

/// The help of `--medium`, with the names and descriptions of all media.
fn medium_help() -> String {
    let mut text =
        "Put meshes into a medium and show the beams of light in it (method beams). A scene with the default light gets a spot in the dark. \
         The media:"
            .to_owned();
    for (name, description) in preset::medium_names() {
        text.push_str(&format!("\n  {name:6} {}", description.trim_start_matches("a medium: ")));
    }
    text
}

impl SceneArguments {
    /// The mask. Its path does not start at the scene file's folder.
    fn mask(&self) -> Result<Option<Mask>, Failure> {
        let Some(file) = &self.mask else { return Ok(None) };
        let file = std::path::absolute(file).map_err(|error| {
            Failure::new(Status::WrongUse, format!("{}: {error}", file.display()), "name a volume file")
        })?;
        Ok(Some(Mask { file, labels: self.mask_labels.clone(), hides: Hides::Outside }))
    }

    /// Reads the scene and its files, and applies the flags.
    pub fn compose(&self) -> Result<Composed, Failure> {
        let composition = Composition {
            input: self.input.clone(),
            preset: self.preset.clone(),
            medium: self.medium.clone(),
            quality: self.quality.map(QualityName::quality),
            transfer: self.transfer.transfer.clone(),
            adjustments: self.transfer.adjustments(),
            size: self.size.map(|Size { width, height }| [width, height]),
            source: VolumeSource { mask: self.mask()?, ..self.volume.source() },
            side: self.view,
            settings: self.set.clone(),
            max_bytes: self.volume.limit(),
        };
        composition.compose().map_err(|error| with_built_in(&self.input, error.into()))
    }
}

/// The volume that is shown, without the rest of the scene's files.
pub fn open_volume(input: &str, arguments: &VolumeArguments) -> Result<Volume, Failure> {
    // Reading a mesh as a volume says what is wrong with that.
    let Opened { mut scene, base, .. } = open(input)?.as_volume();
    if scene.shows_mesh() {
        let message = format!("{input}: this is a mesh, and there is no volume in it");
        let help = format!("`vitrum voxelize {input} -r 256 -o voxels.nrrd` makes one of it");
        return Err(Failure::new(Status::WrongUse, message, help));
    }
    scene.volume.read_as(arguments.source());
    scene.validate()?;
    load_volume(&scene.volume, &base, arguments.limit()).map_err(|error| with_built_in(input, error.into()))
}

/// The failure of an input that is not there, with the built-in scene that was perhaps meant.
fn with_built_in(input: &str, failure: Failure) -> Failure {
    if input.contains(':') || Path::new(input).exists() {
        return failure;
    }
    match nearest(input, builtin::names().iter().map(|(name, _)| *name)) {
        Some(near) if !input.contains('.') => {
            failure.with_help(&format!("did you mean `builtin:{near}`? There is no such file"))
        }
        _ => failure,
    }
}

/// The mesh of a file as it stands there, without the other files of the scene. An input without a mesh fails.
pub fn open_mesh(input: &str, max_bytes: Option<u64>) -> Result<Mesh, Failure> {
    let Opened { scene, base, bare } = open(input)?;
    let as_it_stands = Up::Superior.to_string();
    match scene.mesh.as_slice() {
        [source] if bare => {
            Ok(load_mesh(&MeshSource { up: Some(as_it_stands), ..source.clone() }, Path::new(""), max_bytes)?)
        }
        [_, ..] => Ok(load_meshes(&scene.mesh, &base, max_bytes)?),
        [] if !bare => {
            let message = format!("{input}: this shows a volume, and no mesh");
            let help = "name a mesh's file, a scene that shows one, or a built-in one (`vitrum scenes` lists them)";
            Err(Failure::new(Status::WrongUse, message, help))
        }
        [] => Ok(vitrum::io::open_mesh(Path::new(input), &OpenOptions { max_bytes, ..OpenOptions::default() })?),
    }
}
