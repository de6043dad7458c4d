//! The input that a person names, and the flags that change its scene.

use crate::failure::{Failure, Status};
use crate::size::Size;
use crate::transfer::TransferArguments;
use crate::volume::VolumeArguments;
use clap::Args;
use std::path::Path;
use vitrum::composition::{Composed, Composition, Opened, open};
use vitrum::io::{Mesh, OpenOptions, Up, Volume};
use vitrum::scene::MeshSource;
use vitrum::{load_mesh, load_meshes, load_volume, preset};

/// The input and the flags that change its scene.
#[derive(Debug, Args)]
pub struct SceneArguments {
    /// A scene file (.toml), a volume file, a mesh (.obj, .ply, .stl, .gltf, .glb), a folder of DICOM files, `-` for a volume from standard input, or builtin:NAME
    /// (`vitrum scenes` lists them)
    pub input: String,

    #[command(flatten)]
    pub volume: VolumeArguments,

    /// Give the scene the look of a preset (`vitrum presets` lists them); volume files without it take `amber`, meshes what their file says or glass
    #[arg(long, value_name = "NAME")]
    pub preset: Option<String>,

    /// Put meshes into a medium and show the beams of light in it
    #[arg(long, value_name = "NAME", long_help = medium_help())]
    pub medium: Option<String>,

    #[command(flatten)]
    pub transfer: TransferArguments,

    /// Set a scene key, such as light.0.angular_radius=3; repeatable, applied in order, after --preset and --medium
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,

    /// Pixels across and down, such as 1024x768
    #[arg(long, value_name = "WxH")]
    pub size: Option<Size>,
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
    /// Reads the scene and its files, and applies the flags.
    pub fn compose(&self) -> Result<Composed, Failure> {
        let composition = Composition {
            input: self.input.clone(),
            preset: self.preset.clone(),
            medium: self.medium.clone(),
            transfer: self.transfer.transfer.clone(),
            adjustments: self.transfer.adjustments(),
            size: self.size.map(|Size { width, height }| [width, height]),
            source: self.volume.source(),
            settings: self.set.clone(),
            max_bytes: self.volume.limit(),
        };
        Ok(composition.compose()?)
    }
}

/// The volume that is shown, without the rest of the scene's files.
pub fn open_volume(input: &str, arguments: &VolumeArguments) -> Result<Volume, Failure> {
    // Reading a mesh as a volume says what is wrong with that.
    let Opened { mut scene, base, .. } = open(input)?.as_volume();
    if !scene.mesh.is_empty() {
        let message = format!("{input}: this is a mesh, and there is no volume in it");
        let help = format!("`vitrum voxelize {input} -r 256 -o voxels.nrrd` makes one of it");
        return Err(Failure::new(Status::WrongUse, message, help));
    }
    scene.volume.read_as(arguments.source());
    scene.validate()?;
    Ok(load_volume(&scene.volume, &base, arguments.limit())?)
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
