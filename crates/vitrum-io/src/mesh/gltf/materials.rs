//! Materials as glTF and its extensions describe them.

use super::document::MaterialEntry;
use super::lookup::lookup;
use super::scene::Assembly;
use crate::error::{Error, Place};
use crate::mesh::Material;

impl Assembly<'_, '_> {
    /// The mesh's index of a material, or of the default one.
    pub fn material(&mut self, index: Option<usize>, name: &str) -> Result<u32, Error> {
        let default = MaterialEntry::default();
        let list = &self.files.document.materials;
        let entry = match index {
            Some(index) => lookup(self.builder.report, list, "materials", index, || format!("{name}.material"))?,
            None => &default,
        };
        let slot = index.unwrap_or(list.len());
        if let Some(known) = self.materials[slot] {
            return Ok(known);
        }
        let material = convert(entry);
        if let Some(problem) = out_of_range(&material) {
            let problem = format!("materials[{slot}]: {problem}");
            return Err(self.builder.report.invalid(Place::File, problem, "correct the material"));
        }
        let number = self.builder.materials.len() as u32;
        self.builder.budget.push(&mut self.builder.materials, material)?;
        self.materials[slot] = Some(number);
        Ok(number)
    }
}

/// The material of an entry, with the format's defaults for absent fields.
fn convert(entry: &MaterialEntry) -> Material {
    let [red, green, blue, alpha] = entry.pbr_metallic_roughness.base_color_factor.unwrap_or([1.0; 4]);
    let extensions = &entry.extensions;
    let volume = extensions.volume.as_ref();
    // Over an infinite distance, which is the default, no colour attenuates.
    let distance = volume.and_then(|volume| volume.attenuation_distance);
    Material {
        name: entry.name.clone(),
        base_color: Some([red, green, blue]),
        opacity: Some(match entry.alpha_mode.as_deref() {
            None | Some("OPAQUE") => 1.0,
            Some(_) => alpha,
        }),
        transmission: extensions.transmission.as_ref().map(|transmission| transmission.transmission_factor),
        index_of_refraction: extensions.ior.as_ref().map(|ior| ior.ior.unwrap_or(1.5)),
        attenuation_color: distance.and(volume).map(|volume| volume.attenuation_color.unwrap_or([1.0; 3])),
        attenuation_distance: distance,
        roughness: Some(entry.pbr_metallic_roughness.roughness_factor.unwrap_or(1.0)),
    }
}

fn out_of_range(material: &Material) -> Option<String> {
    let unit = |name: &str, value: Option<f32>| {
        let value = value.filter(|value| !(0.0..=1.0).contains(value))?;
        Some(format!("{name} is {value}, not 0 to 1"))
    };
    let colors = [("the base colour", material.base_color), ("the attenuation colour", material.attenuation_color)];
    let channels =
        colors.into_iter().flat_map(|(name, color)| color.into_iter().flatten().map(move |value| (name, Some(value))));
    let numbers = [
        ("the alpha", material.opacity),
        ("the transmission", material.transmission),
        ("the roughness", material.roughness),
    ];
    if let Some(problem) = channels.chain(numbers).find_map(|(name, value)| unit(name, value)) {
        return Some(problem);
    }
    // 0 stands for an infinite one.
    if let Some(ior) = material.index_of_refraction.filter(|&ior| ior != 0.0 && !(1.0..=1e6).contains(&ior)) {
        return Some(format!("the index of refraction is {ior}, not 1 or more"));
    }
    let distance = material.attenuation_distance.filter(|distance| !(*distance > 0.0 && distance.is_finite()));
    distance.map(|distance| format!("the attenuation distance is {distance}, not above 0"))
}
