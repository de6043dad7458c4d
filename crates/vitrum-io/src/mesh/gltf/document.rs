//! The JSON of a glTF file, as far as meshes go.

use serde::Deserialize;

use crate::error::{Error, Place, clip};
use crate::mesh::build::Builder;

#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase", default)]
#[derive(Default)]
pub(super) struct Document {
    extensions_required: Vec<String>,
    pub scene: Option<usize>,
    pub scenes: Vec<Scene>,
    pub nodes: Vec<Node>,
    pub meshes: Vec<MeshEntry>,
    pub accessors: Vec<Accessor>,
    pub buffer_views: Vec<BufferView>,
    pub buffers: Vec<Buffer>,
    pub materials: Vec<MaterialEntry>,
    pub textures: Vec<serde::de::IgnoredAny>,
    pub skins: Vec<serde::de::IgnoredAny>,
    pub animations: Vec<serde::de::IgnoredAny>,
}

#[derive(Deserialize)]
struct Head {
    asset: Asset,
}

#[derive(Deserialize)]
struct Asset {
    version: String,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Scene {
    pub nodes: Vec<usize>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Node {
    pub mesh: Option<usize>,
    pub children: Vec<usize>,
    pub matrix: Option<[f64; 16]>,
    pub translation: Option<[f64; 3]>,
    pub rotation: Option<[f64; 4]>,
    pub scale: Option<[f64; 3]>,
}

#[derive(Debug, Deserialize)]
pub(super) struct MeshEntry {
    pub primitives: Vec<Primitive>,
}

#[derive(Debug, Deserialize)]
pub(super) struct Primitive {
    pub attributes: Attributes,
    pub indices: Option<usize>,
    pub material: Option<usize>,
    pub mode: Option<u32>,
    #[serde(default)]
    pub targets: Vec<serde::de::IgnoredAny>,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "UPPERCASE")]
pub(super) struct Attributes {
    pub position: Option<usize>,
    pub normal: Option<usize>,
    #[serde(rename = "COLOR_0")]
    pub color: Option<usize>,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Accessor {
    pub buffer_view: Option<usize>,
    #[serde(default)]
    pub byte_offset: u64,
    pub component_type: u32,
    #[serde(default)]
    pub normalized: bool,
    pub count: u64,
    #[serde(rename = "type")]
    pub kind: String,
    pub sparse: Option<Sparse>,
}

#[derive(Debug, Deserialize)]
pub(super) struct Sparse {
    pub count: u64,
    pub indices: SparsePart,
    pub values: SparsePart,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct SparsePart {
    pub buffer_view: usize,
    #[serde(default)]
    pub byte_offset: u64,
    /// Component type of indices; values have the component type of their accessor.
    pub component_type: Option<u32>,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct BufferView {
    pub buffer: usize,
    #[serde(default)]
    pub byte_offset: u64,
    pub byte_length: u64,
    pub byte_stride: Option<u64>,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Buffer {
    pub uri: Option<String>,
    pub byte_length: u64,
}

#[derive(Debug, Default, Deserialize)]
#[serde(rename_all = "camelCase", default)]
pub(super) struct MaterialEntry {
    pub name: String,
    pub pbr_metallic_roughness: PbrMetallicRoughness,
    pub alpha_mode: Option<String>,
    pub extensions: MaterialExtensions,
}

#[derive(Debug, Default, Deserialize)]
#[serde(rename_all = "camelCase", default)]
pub(super) struct PbrMetallicRoughness {
    pub base_color_factor: Option<[f32; 4]>,
    pub roughness_factor: Option<f32>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct MaterialExtensions {
    #[serde(rename = "KHR_materials_transmission")]
    pub transmission: Option<Transmission>,
    #[serde(rename = "KHR_materials_ior")]
    pub ior: Option<Ior>,
    #[serde(rename = "KHR_materials_volume")]
    pub volume: Option<Volume>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(rename_all = "camelCase", default)]
pub(super) struct Transmission {
    pub transmission_factor: f32,
}

#[derive(Debug, Deserialize)]
pub(super) struct Ior {
    pub ior: Option<f32>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(rename_all = "camelCase", default)]
pub(super) struct Volume {
    pub attenuation_distance: Option<f32>,
    pub attenuation_color: Option<[f32; 3]>,
}

impl Document {
    pub fn parse(json: &[u8], builder: &Builder) -> Result<Self, Error> {
        let report = builder.report;
        // Each object becomes one of the structures above, and numbers between commas take 8 bytes each.
        let objects = json.iter().filter(|&&byte| byte == b'{').count();
        builder.budget.check(size_of::<Node>() as u64 * objects as u64 + 4 * json.len() as u64)?;
        let wrong = |error: serde_json::Error| {
            report.invalid(
                Place::File,
                format!("this is not the JSON of glTF: {error}"),
                "correct it, or write it anew",
            )
        };
        let head: Head = serde_json::from_slice(json).map_err(wrong)?;
        let version = head.asset.version;
        if !version.starts_with("2.") {
            let problem = format!("glTF of version `{}`, and only 2.0 is read", clip(&version));
            return Err(report.unsupported(Place::File, problem, "convert it to glTF 2.0"));
        }
        let document: Self = serde_json::from_slice(json).map_err(wrong)?;
        // These either change nothing in the triangles or are read.
        let is_known = |name: &str| {
            name == "KHR_mesh_quantization"
                || ["KHR_materials_", "KHR_texture_", "EXT_texture_", "KHR_lights_"]
                    .iter()
                    .any(|one| name.starts_with(one))
        };
        match document.extensions_required.iter().find(|name| !is_known(name)) {
            None => Ok(document),
            Some(name) => Err(report.unsupported(
                Place::File,
                format!("the file requires the extension `{}`, which is not read", clip(name)),
                "write it without that, for example by `gltf-transform copy`",
            )),
        }
    }
}
