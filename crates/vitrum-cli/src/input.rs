//! What the user wants to see: a scene file, a volume file or a built-in scene, changed by flags.

use crate::failure::{Failure, Status};
use crate::size::Size;
use crate::volume::VolumeArguments;
use clap::Args;
use std::fs;
use std::path::{Path, PathBuf};
use vitrum::io::{Mesh, OpenOptions, STANDARD_INPUT, Up, Volume, is_mesh};
use vitrum::scene::{MeshSource, MethodName, Problem, Scene, VolumeSource};
use vitrum::suggest::nearest;
use vitrum::{Assets, builtin, load_mesh, load_meshes, load_volume, preset};

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

    /// Set a scene key, such as light.0.angular_radius=3; repeatable, applied in order, after --preset
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,

    /// Pixels across and down, such as 1024x768
    #[arg(long, value_name = "WxH")]
    pub size: Option<Size>,
}

impl SceneArguments {
    /// Reads the scene and its files, and applies the flags.
    pub fn prepare(&self) -> Result<Prepared, Failure> {
        let Opened { mut scene, base, bare } = open(&self.input)?;
        if bare && self.volume.raw.is_some() {
            scene = without_mesh(scene);
        }
        if !scene.mesh.is_empty() {
            return self.prepare_mesh(scene, base, bare);
        }
        // Names first: a slip should not cost the time to read a volume.
        self.preset.as_deref().map_or(Ok(()), preset::check)?;
        let preset = self.preset.as_deref().or(bare.then_some(preset::DEFAULT));
        let mut before = scene.clone();
        self.change(&mut before, preset.is_some())?;
        let assets = Assets::load_within(&before, &base, self.volume.limit())?;
        if let Some(name) = preset {
            // Without a mesh in the scene, a volume was loaded.
            let volume = assets.subject.volume().expect("a scene without a mesh shows a volume");
            preset::apply(name, volume, &mut scene)?;
        }
        self.change(&mut scene, false)?;
        Ok(Prepared { scene, base, assets })
    }

    /// What a mesh looks like does not depend on what is in its file.
    fn prepare_mesh(&self, mut scene: Scene, base: PathBuf, bare: bool) -> Result<Prepared, Failure> {
        match &self.preset {
            Some(name) => preset::apply_to_mesh(name, &mut scene)?,
            None if bare => preset::surround_mesh(&mut scene),
            None => {}
        }
        self.change(&mut scene, false)?;
        let assets = Assets::load_within(&scene, &base, self.volume.limit())?;
        Ok(Prepared { scene, base, assets })
    }

    /// Applies `--size`, the volume's flags and `--set`. If a preset is still to come, what is missing now may be filled in by it, such as
    /// the points of a transfer function.
    fn change(&self, scene: &mut Scene, preset_to_come: bool) -> Result<(), Failure> {
        if let Some(Size { width, height }) = self.size {
            scene.film.width = width;
            scene.film.height = height;
        }
        self.volume.apply_to(scene);
        for assignment in &self.set {
            match scene.set(assignment) {
                Err(error) if preset_to_come && is_missing(&error.problem) => {}
                outcome => outcome?,
            }
        }
        Ok(scene.validate()?)
    }
}

fn is_missing(problem: &Problem) -> bool {
    matches!(problem, Problem::MissingKey { .. } | Problem::Contradiction { .. })
}

/// The scene that is rendered, and what it is rendered from.
pub struct Prepared {
    pub scene: Scene,
    /// The folder that relative paths in the scene start at.
    pub base: PathBuf,
    pub assets: Assets,
}

/// An input before flags.
pub struct Opened {
    pub scene: Scene,
    /// The folder that relative paths in the scene start at.
    pub base: PathBuf,
    /// Whether there is a volume or a mesh and nobody has said how it looks.
    pub bare: bool,
}

/// Finds out what `input` is. Volumes are not read yet.
pub fn open(input: &str) -> Result<Opened, Failure> {
    if let Some(name) = input.strip_prefix("builtin:") {
        let scene = builtin::scene(name).ok_or_else(|| unknown_builtin(name))?;
        return Ok(Opened { scene, base: PathBuf::new(), bare: false });
    }
    let path = Path::new(input);
    if path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("toml")) {
        let base = path.parent().unwrap_or(Path::new("")).to_owned();
        return Ok(Opened { scene: read_scene(path)?, base, bare: false });
    }
    // What cannot be looked at, the reader of volumes has the message for.
    if path != Path::new(STANDARD_INPUT) && is_mesh(path).unwrap_or(false) {
        let mesh = vec![MeshSource { file: Some(path.to_owned()), ..MeshSource::default() }];
        let scene = Scene { method: MethodName::Voxels, mesh, ..Scene::default() };
        return Ok(Opened { scene, base: PathBuf::new(), bare: true });
    }
    let volume = VolumeSource { file: Some(path.to_owned()), ..VolumeSource::default() };
    Ok(Opened { scene: Scene { volume, ..Scene::default() }, base: PathBuf::new(), bare: true })
}

/// The scene of a mesh's file as a volume.
fn without_mesh(scene: Scene) -> Scene {
    match scene.mesh.as_slice() {
        [MeshSource { file: Some(file), .. }] => {
            Scene { volume: VolumeSource { file: Some(file.clone()), ..VolumeSource::default() }, ..Scene::default() }
        }
        _ => scene,
    }
}

/// The volume that is shown, without the rest of the scene's files.
pub fn open_volume(input: &str, arguments: &VolumeArguments) -> Result<Volume, Failure> {
    let Opened { mut scene, base, .. } = open(input)?;
    // Reading a mesh as a volume says what is wrong with that.
    scene = without_mesh(scene);
    if !scene.mesh.is_empty() {
        let message = format!("{input}: this is a mesh, and there is no volume in it");
        let help = format!("`vitrum voxelize {input} -r 256 -o voxels.nrrd` makes one of it");
        return Err(Failure::new(Status::WrongUse, message, help));
    }
    arguments.apply(&mut scene.volume);
    scene.validate()?;
    Ok(load_volume(&scene.volume, &base, arguments.limit())?)
}

/// The mesh that is shown, as it stands in its file, without the rest of the scene's files. What is no mesh fails as one.
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

fn read_scene(path: &Path) -> Result<Scene, Failure> {
    Ok(Scene::from_toml(&read_text(path, "scene")?, &path.display().to_string())?)
}

/// Reads a text that should hold `what`.
pub fn read_text(path: &Path, what: &str) -> Result<String, Failure> {
    // They are small; anything else by that name should not fill the memory.
    const MOST_BYTES: u64 = 16 << 20;
    let shown = path.display();
    let unreadable = |problem: String, help: &str| Failure::new(Status::Input, format!("{shown}: {problem}"), help);
    let length =
        fs::metadata(path).map_err(|error| unreadable(format!("cannot be read: {error}"), "check the path"))?.len();
    if length > MOST_BYTES {
        let problem = format!("{length} bytes are no {what}, the limit is {MOST_BYTES}");
        return Err(unreadable(problem, "give a text file; volumes have other extensions"));
    }
    fs::read_to_string(path)
        .map_err(|error| unreadable(format!("cannot be read: {error}"), "give a text file in UTF-8"))
}

fn unknown_builtin(name: &str) -> Failure {
    let names = || builtin::names().iter().map(|&(name, _)| name);
    let help = match nearest(name, names()) {
        Some(near) => format!("did you mean `builtin:{near}`?"),
        None => format!("the built-in scenes are: {}", names().collect::<Vec<_>>().join(", ")),
    };
    Failure::new(Status::WrongUse, format!("there is no built-in scene `{name}`"), help)
}
