//! Every reader as a function of bytes: what coverage-guided fuzzing (`fuzz/`) and the test of mutations call.

mod whole;

use std::fs;
use std::path::PathBuf;
use std::process;

use whole::Whole;

use vitrum_io::transfer::read_transfer_bytes;
use vitrum_io::{Input, OpenOptions, mesh_readers, open_mesh, read_picture_with, readers};

/// Largest memory that a file may ask for, in bytes: enough for every path through a reader, and soon filled.
const MOST: u64 = 1 << 20;

const OPTIONS: OpenOptions = OpenOptions {
    max_bytes: Some(MOST),
    paged: false,
    raw: None,
    spacing: None,
    array: None,
    time: None,
    seconds: None,
    up: None,
};

/// The format of a target's bytes.
#[derive(Debug, Clone, Copy)]
enum Kind {
    /// A volume of the reader's name, under each of these file names in turn.
    Volume(&'static str, &'static [&'static str]),
    /// Headerless voxels: the first line is the file's name.
    Raw,
    /// A mesh of the reader's name.
    Mesh(&'static str, &'static str),
    /// The materials of a mesh that is given.
    Materials,
    /// Transfer functions, under each of these file names in turn.
    Transfer(&'static [&'static str]),
    /// A picture. The content decides, so that its first bytes are put in their place.
    Picture(&'static [u8]),
}

/// What a collection may name.
const PIECE: &[u8] =
    b"<VTKFile type=\"ImageData\"><ImageData WholeExtent=\"0 1 0 0 0 0\"><Piece Extent=\"0 1 0 0 0 0\"><PointData>\
    <DataArray type=\"UInt8\" Name=\"a\" format=\"ascii\">1 2</DataArray></PointData></Piece></ImageData></VTKFile>";

/// The targets, one a format.
#[rustfmt::skip]
const TARGETS: &[(&str, Kind)] = &[
    ("nrrd", Kind::Volume("NRRD", &["a.nrrd"])),
    ("nifti", Kind::Volume("NIfTI", &["a.nii", "a.hdr"])),
    ("metaimage", Kind::Volume("MetaImage", &["a.mha"])),
    ("numpy", Kind::Volume("NumPy", &["a.npy"])),
    ("npz", Kind::Volume("NumPy archive", &["a.npz"])),
    ("vti", Kind::Volume("VTK image data", &["a.vti"])),
    ("pvd", Kind::Volume("VTK collection", &["b.pvd"])),
    ("vtk", Kind::Volume("legacy VTK", &["a.vtk"])),
    ("stack", Kind::Volume("TIFF stack", &["a.tif"])),
    ("dicom", Kind::Volume("DICOM", &["a.dcm"])),
    ("raw", Kind::Raw),
    ("obj", Kind::Mesh("OBJ", "a.obj")),
    ("mtl", Kind::Materials),
    ("ply", Kind::Mesh("PLY", "a.ply")),
    ("stl", Kind::Mesh("STL", "a.stl")),
    ("gltf", Kind::Mesh("glTF", "a.gltf")),
    ("transfer", Kind::Transfer(&["a.vp", "a.xml"])),
    ("hdr", Kind::Picture(b"#?RADIANCE")),
    ("exr", Kind::Picture(&[0x76, 0x2f, 0x31, 0x01])),
    ("png", Kind::Picture(b"\x89PNG\r\n\x1a\n")),
    ("jpeg", Kind::Picture(&[0xff, 0xd8, 0xff])),
    ("tiff", Kind::Picture(b"II*\0")),
];

/// The names of all targets.
pub fn names() -> impl Iterator<Item = &'static str> {
    TARGETS.iter().map(|&(name, _)| name)
}

/// A temporary folder with the files that others may name.
pub struct Readers {
    folder: PathBuf,
}

impl Readers {
    /// A folder of this process and this `label`; it is removed when the value is dropped.
    pub fn new(label: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("vitrum-readers-{label}-{}", process::id()));
        fs::create_dir_all(&folder).expect("a folder for the files");
        for (name, content) in [
            ("slice1", &[1; 6][..]),
            ("slice2", &[2; 6]),
            ("a.img", &[3; 4096]),
            ("a.bin", &[0; 4096]),
            ("b.vti", PIECE),
            ("a.mtl", b"newmtl a\nKd 1 0 1\nd 0.5\n"),
        ] {
            fs::write(folder.join(name), content).expect("a file that others name");
        }
        Self { folder }
    }

    /// Opens `bytes` as the format of the target `name`. The outcome is a whole value within its memory limit, or an error.
    ///
    /// # Panics
    ///
    /// Where a reader does, or lets something through that it promises not to.
    pub fn read(&self, name: &str, bytes: &[u8]) {
        let (_, kind) = TARGETS.iter().find(|(known, _)| *known == name).expect("a known target");
        match *kind {
            Kind::Volume(reader, files) => files.iter().for_each(|file| self.volume(reader, file, bytes)),
            Kind::Raw => {
                let end = bytes.iter().position(|&byte| byte == b'\n').unwrap_or(bytes.len());
                let (file, voxels) = bytes.split_at(end.min(100));
                let fits = |byte: &&u8| byte.is_ascii_alphanumeric() || b"._- ()".contains(byte);
                let file: String = file.iter().filter(fits).map(|&byte| char::from(byte)).collect();
                self.volume("raw voxels", &format!("a{file}"), voxels.get(1..).unwrap_or_default());
            }
            Kind::Mesh(reader, file) => self.mesh(reader, file, bytes),
            Kind::Materials => {
                let path = self.write("b.mtl", bytes);
                let text = b"mtllib b.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\n";
                self.mesh("OBJ", "b.obj", text);
                let _ = fs::remove_file(path);
            }
            Kind::Transfer(files) => files.iter().for_each(|file| {
                let Ok(function) = read_transfer_bytes(file, bytes, None) else { return };
                assert!(!function.color.is_empty() || !function.opacity.is_empty());
                assert!(
                    function.color.is_sorted_by(|a, b| a.0 <= b.0) && function.opacity.is_sorted_by(|a, b| a.0 <= b.0)
                );
                let unit = |value: &f32| (0.0..=1.0).contains(value);
                assert!(function.color.iter().all(|(x, color)| x.is_finite() && color.iter().all(unit)));
                assert!(function.opacity.iter().all(|(x, opacity)| x.is_finite() && unit(opacity)));
                assert!(function.color.len().max(function.opacity.len()) <= 1 << 14);
            }),
            Kind::Picture(magic) => {
                let bytes = if bytes.starts_with(magic) || name == "tiff" && bytes.starts_with(b"MM\0*") {
                    bytes.to_vec()
                } else {
                    [magic, bytes].concat()
                };
                let Ok(picture) = read_picture_with(&self.write("a", &bytes), &OPTIONS) else { return };
                let pixels = picture.width as usize * picture.height as usize;
                let channels = picture.layers.iter().flat_map(|layer| &layer.channels);
                assert!(pixels > 0 && channels.clone().count() > 0);
                assert!(channels.clone().all(|channel| channel.data.len() == pixels));
                assert!(channels.map(|channel| 4 * channel.data.len() as u64).sum::<u64>() <= MOST);
            }
        }
    }

    fn write(&self, file: &str, bytes: &[u8]) -> PathBuf {
        let path = self.folder.join(file);
        fs::write(&path, bytes).expect("a written file");
        path
    }

    fn volume(&self, reader: &str, file: &str, bytes: &[u8]) {
        let path = self.write(file, bytes);
        let reader = readers().iter().find(|known| known.format().name == reader).expect("a known reader");
        let volume = Input::new(&path, &OPTIONS).and_then(|input| {
            let _ = reader.recognises(&input);
            reader.read(&input, &OPTIONS)
        });
        let _ = fs::remove_file(path);
        if let Ok(volume) = volume {
            volume.assert_whole(MOST);
        }
    }

    fn mesh(&self, reader: &str, file: &str, bytes: &[u8]) {
        let path = self.write(file, bytes);
        let input = Input::new(&path, &OPTIONS).expect("a written file");
        let reader = mesh_readers().iter().find(|known| known.format().name == reader).expect("a known reader");
        let mesh = if reader.recognises(&input) { open_mesh(&path, &OPTIONS) } else { reader.read(&input, &OPTIONS) };
        if let Ok(mesh) = mesh {
            mesh.assert_whole(MOST);
        }
    }
}

impl Drop for Readers {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.folder);
    }
}
