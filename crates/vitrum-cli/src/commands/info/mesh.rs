//! The description of a mesh, for people and for machines.

use super::digits::Digits;
use serde_json::{Value, json};
use std::fmt::Write;
use vitrum::io::{Material, Mesh, Topology};

use crate::advice;

pub fn text(mesh: &Mesh) -> String {
    let topology = mesh.topology();
    let [low, high] = mesh.bounds();
    let source = &mesh.source;
    let mut text = String::new();
    let mut row = |name: &str, value: String| {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "{name:12}{value}");
    };
    row("mesh", mesh.name.clone());
    row("format", if source.format.is_empty() { "computed".to_owned() } else { source.format.to_owned() });
    let file = [&*source.sample_type, &*source.encoding].into_iter().filter(|part| !part.is_empty());
    row("type", file.map(|part| format!("{part}, ")).collect::<String>() + "float32 in memory");
    row("vertices", format!("{} at {} positions", mesh.positions.len(), topology.points));
    let in_memory = super::bytes(mesh.bytes());
    let degenerate = mesh.degenerate_triangle_count();
    row("triangles", format!("{}, {degenerate} of them without area ({in_memory} in memory)", mesh.triangles.len()));
    row("parts", topology.parts.to_string());
    let [low, high] = [low, high].map(|corner| super::place::shown(corner).join(", "));
    row("bounds", format!("({low}) to ({high})"));
    row("area", format!("{:.6}", Digits(mesh.surface_area())));
    row(
        "volume",
        match volume(mesh, &topology) {
            Some(volume) => format!("{:.6}", Digits(volume)),
            None => "none, as the surface encloses no volume".to_owned(),
        },
    );
    let Topology { boundary_edges, non_manifold_edges, unpaired_edges, .. } = topology;
    let closed = if topology.is_closed() { "closed" } else { "not closed" };
    row(
        "surface",
        format!(
            "{closed}: {} edges, {boundary_edges} of one triangle, {non_manifold_edges} of more than two, {unpaired_edges} \
         not followed both ways alike",
            topology.edges
        ),
    );
    row("per vertex", per_vertex(mesh).to_owned());
    for (index, material) in mesh.materials.iter().enumerate() {
        row(if index == 0 { "materials" } else { "" }, describe(material));
    }
    for (name, told) in advice::on_assumptions(&source.assumptions) {
        row(name, told);
    }
    text
}

pub fn json(mesh: &Mesh) -> Value {
    let topology = mesh.topology();
    json!({
        "name": mesh.name,
        "format": mesh.source.format,
        "sample_type": mesh.source.sample_type,
        "encoding": mesh.source.encoding,
        "vertices": mesh.positions.len(),
        "points": topology.points,
        "triangles": mesh.triangles.len(),
        "degenerate_triangles": mesh.degenerate_triangle_count(),
        "parts": topology.parts,
        "bounds": mesh.bounds(),
        "area": mesh.surface_area(),
        "volume": volume(mesh, &topology),
        "closed": topology.is_closed(),
        "edges": topology.edges,
        "boundary_edges": topology.boundary_edges,
        "non_manifold_edges": topology.non_manifold_edges,
        "unpaired_edges": topology.unpaired_edges,
        "normals": mesh.normals.is_some(),
        "colors": mesh.colors.is_some(),
        "materials": mesh.materials.iter().map(material_json).collect::<Vec<_>>(),
        "bytes": mesh.bytes(),
        "assumptions": mesh.source.assumptions.iter().map(advice::on_assumption).collect::<Vec<_>>(),
    })
}

/// `None` where the surface encloses none.
fn volume(mesh: &Mesh, topology: &Topology) -> Option<f64> {
    (topology.unpaired_edges == 0 && topology.edges > 0).then(|| mesh.signed_volume())
}

/// The attributes of a vertex besides its position.
fn per_vertex(mesh: &Mesh) -> &'static str {
    match (&mesh.normals, &mesh.colors) {
        (Some(_), Some(_)) => "position, normal, colour",
        (Some(_), None) => "position, normal",
        (None, Some(_)) => "position, colour",
        (None, None) => "position",
    }
}

fn describe(material: &Material) -> String {
    let mut text = if material.name.is_empty() { "(no name)".to_owned() } else { material.name.clone() };
    let mut add = |name: &str, value: Option<String>| {
        if let Some(value) = value {
            let _ = write!(text, ", {name} {value}");
        }
    };
    let shown = |value: Option<f32>| value.map(|value| value.to_string());
    let color = |value: Option<[f32; 3]>| value.map(|value| format!("{value:?}"));
    add("base colour", color(material.base_color));
    add("opacity", shown(material.opacity));
    add("transmission", shown(material.transmission));
    add("index of refraction", shown(material.index_of_refraction));
    add("attenuation colour", color(material.attenuation_color));
    add("attenuation distance", shown(material.attenuation_distance));
    add("roughness", shown(material.roughness));
    text
}

fn material_json(material: &Material) -> Value {
    json!({
        "name": material.name,
        "base_color": material.base_color,
        "opacity": material.opacity,
        "transmission": material.transmission,
        "index_of_refraction": material.index_of_refraction,
        "attenuation_color": material.attenuation_color,
        "attenuation_distance": material.attenuation_distance,
        "roughness": material.roughness,
    })
}
