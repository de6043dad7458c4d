//! Materials of surfaces and of the bodies within them.

/// A material, as far as the file describes it; `None` stands for a value that the file does not have.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Material {
    /// Name of the material in the file; may be empty.
    pub name: String,
    /// Linear RGB, 0 to 1: `Kd` of MTL, which is taken for linear, and the base colour factor of glTF.
    pub base_color: Option<[f32; 3]>,
    /// Opacity from 0, invisible, to 1: `d` or `1 - Tr` of MTL, the alpha of glTF where its mode is not opaque.
    pub opacity: Option<f32>,
    /// Fraction of light, 0 to 1, that goes through the surface into the body: `KHR_materials_transmission`.
    pub transmission: Option<f32>,
    /// Index of refraction of the body that the surface encloses, 1 for vacuum: `Ni` of MTL, `KHR_materials_ior`.
    pub index_of_refraction: Option<f32>,
    /// Linear RGB, 0 to 1, of white light that has gone through the body for [`Self::attenuation_distance`], or for any
    /// distance where that is `None`: `Tf` of MTL, `KHR_materials_volume`.
    pub attenuation_color: Option<[f32; 3]>,
    /// Attenuation distance in the mesh's units, above 0: `KHR_materials_volume`.
    pub attenuation_distance: Option<f32>,
    /// Roughness from 0, a mirror, to 1: `Pr` of MTL, the roughness factor of glTF.
    pub roughness: Option<f32>,
}
