//! The file formats: their names, extensions and first bytes, also of those that a build leaves out.

/// A file format.
#[derive(Debug, PartialEq, Eq)]
pub struct Format {
    /// Name of the format, such as `NRRD`.
    pub name: &'static str,
    /// File extensions of the format: lower case, with the dot.
    pub extensions: &'static [&'static str],
    /// The feature of this crate that its reader belongs to.
    pub feature: &'static str,
    /// Whether this build has the feature.
    pub included: bool,
    /// Magic numbers: each file begins with one of them; empty for a format whose files have none.
    pub(crate) magic: &'static [&'static [u8]],
}

impl Format {
    /// Whether a file begins as this format's files do.
    pub(crate) fn begins(&self, head: &[u8]) -> bool {
        self.magic.iter().any(|magic| head.starts_with(magic))
    }

    /// Whether a file's name, without the extension of its packing, ends as this format's files do.
    pub(crate) fn has_extension(&self, name: &str) -> bool {
        let name = name.to_ascii_lowercase();
        self.extensions.iter().any(|extension| name.ends_with(extension))
    }
}

/// Defines the formats of one kind of data and the list of them.
macro_rules! formats {
    ($(#[$list_doc:meta])* $list:ident: $($constant:ident = $feature:literal, $name:literal, $extensions:expr, $magic:expr;)*) => {
        $(
            #[doc = concat!("The format ", $name, ".")]
            pub(crate) static $constant: Format = Format {
                name: $name,
                extensions: &$extensions,
                feature: $feature,
                included: cfg!(feature = $feature),
                magic: &$magic,
            };
        )*

        $(#[$list_doc])*
        pub static $list: &[&Format] = &[$(&$constant),*];
    };
}

formats! {
    /// The formats of volumes, in the order in which their readers are asked.
    VOLUME_FORMATS:
    NRRD = "nrrd", "NRRD", [".nrrd", ".nhdr"], [b"NRRD00"];
    NIFTI = "nifti", "NIfTI", [".nii", ".nii.gz", ".hdr", ".hdr.gz", ".img", ".img.gz"], [];
    METAIMAGE = "metaimage", "MetaImage", [".mha", ".mhd"], [];
    NUMPY = "numpy", "NumPy", [".npy"], [b"\x93NUMPY"];
    NPZ = "numpy", "NumPy archive", [".npz"], [];
    PVD = "vti", "VTK collection", [".pvd"], [];
    VTI = "vti", "VTK image data", [".vti"], [];
    VTK = "vtk", "legacy VTK", [".vtk"], [b"# vtk DataFile"];
    DICOM = "dicom", "DICOM", [".dcm", ".dicom"], [];
    STACK = "tiff", "TIFF stack", [".tif", ".tiff"], [b"II*\0", b"MM\0*", b"II+\0", b"MM\0+"];
    RAW = "raw", "raw voxels", [".raw", ".bin"], [];
}

formats! {
    /// The formats of meshes, in the order in which their readers are asked.
    MESH_FORMATS:
    PLY = "ply", "PLY", [".ply"], [b"ply\n", b"ply\r"];
    GLTF = "gltf", "glTF", [".gltf", ".glb"], [b"glTF"];
    STL = "stl", "STL", [".stl"], [];
    OBJ = "obj", "OBJ", [".obj"], [];
}

formats! {
    /// The formats of pictures.
    PICTURE_FORMATS:
    PNG = "png", "PNG", [".png"], [b"\x89PNG\r\n\x1a\n"];
    EXR = "exr", "OpenEXR", [".exr"], [b"\x76\x2f\x31\x01"];
    HDR = "hdr", "Radiance HDR", [".hdr"], [b"#?RADIANCE", b"#?RGBE"];
    JPEG = "jpeg", "JPEG", [".jpg", ".jpeg"], [b"\xff\xd8\xff"];
    TIFF = "tiff", "TIFF", [".tif", ".tiff"], [b"II*\0", b"MM\0*"];
}

/// Names and extensions of formats, for messages.
pub(crate) fn described(formats: impl Iterator<Item = &'static Format>) -> String {
    let described = formats.map(|format| format!("{} ({})", format.name, format.extensions.join(", ")));
    described.collect::<Vec<_>>().join(", ")
}

/// The format of a file that this build leaves out, by the file's first bytes, else by its name without the extension of its
/// packing.
pub(crate) fn left_out(formats: &[&'static Format], head: &[u8], name: &str) -> Option<&'static Format> {
    let left_out = || formats.iter().copied().filter(|format| !format.included);
    left_out().find(|format| format.begins(head)).or_else(|| left_out().find(|format| format.has_extension(name)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_format_left_out_is_known_by_content_and_by_name() {
        static OUT: Format =
            Format { name: "Out", extensions: &[".out"], feature: "out", included: false, magic: &[b"OUT"] };
        let formats: &[&Format] = &[&NRRD, &OUT];
        assert_eq!(left_out(formats, b"OUT1", "a.nrrd"), Some(&OUT));
        assert_eq!(left_out(formats, b"1", "a.OUT"), Some(&OUT));
        let nrrd = (!NRRD.included).then_some(&NRRD);
        assert_eq!(left_out(formats, b"NRRD0004", "a.nrrd"), nrrd);
        assert_eq!(left_out(formats, b"1", "a.dat"), None);
    }
}
