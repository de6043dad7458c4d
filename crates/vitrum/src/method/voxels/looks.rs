//! Surface attributes of opaque bodies: reflectance and transmittance.

use super::bodies::{Body, chosen, of_mesh};
use crate::scene::{Rgb, Scene};
use vitrum_io::Mesh;
use vitrum_kernels::abi::voxels::look;

/// The reflectance of a body without a colour.
pub const GREY: Rgb = [0.7; 3];

/// Surface attributes as kernels read them.
pub(in crate::method) struct Looks {
    pub floats: Vec<f32>,
    /// Whether each triangle has its own attributes, in the order of the tree's triangles; else each body has them.
    pub of_triangles: bool,
}

/// The colours of a body's vertices if the body shows them, else its colour; and the transmittance of a triangle.
fn of_body<'a>(body: &'a Body, mesh: &Mesh, scene: &Scene) -> (Option<&'a [[f32; 4]]>, Rgb, f32) {
    let own = of_mesh(mesh, body.material);
    let material = chosen(&scene.material, own);
    // A colour in the scene is for the whole body.
    let colors = body.mesh.colors.as_deref().filter(|_| body.opaque && material.color.is_none());
    let color = material.color.or_else(|| own?.base_color).unwrap_or(GREY);
    let left = libm::exp(-f64::from(material.density) * f64::from(scene.shadow.optical_depth)) as f32;
    (colors, color, left)
}

/// The diffuse reflectance of a body as a whole, linear RGB, 0 to 1: where its vertices have colours that show, their mean.
pub(in crate::method) fn reflectance(body: &Body, mesh: &Mesh, scene: &Scene) -> Rgb {
    let (colors, color, _) = of_body(body, mesh, scene);
    let Some(colors) = colors.filter(|colors| !colors.is_empty()) else { return color };
    let mean = |channel: usize| colors.iter().map(|color| f64::from(color[channel])).sum::<f64>() / colors.len() as f64;
    std::array::from_fn(|channel| (mean(channel) as f32).clamp(0.0, 1.0))
}

/// The surface attributes of `bodies`; the tree has the triangles of the bodies from number `first` on.
pub(super) fn looks(bodies: &[Body], first: usize, mesh: &Mesh, scene: &Scene) -> Looks {
    let look = |colors: [Rgb; 3], left: f32| {
        let mut floats = [0.0; look::SIZE];
        floats[look::COLORS..][..9].copy_from_slice(colors.as_flattened());
        floats[look::TRANSMITTANCE] = left;
        floats
    };
    let of_triangles = bodies.iter().skip(first).any(|body| of_body(body, mesh, scene).0.is_some());
    let mut floats = Vec::new();
    for body in bodies.iter().skip(if of_triangles { first } else { 0 }) {
        let (colors, color, left) = of_body(body, mesh, scene);
        if !of_triangles {
            floats.extend(look([color; 3], left));
            continue;
        }
        for triangle in &body.mesh.triangles {
            let corner = |vertex: u32| {
                colors.map_or(color, |colors| {
                    let [red, green, blue, _] = colors[vertex as usize];
                    [red, green, blue].map(|channel| channel.clamp(0.0, 1.0))
                })
            };
            floats.extend(look(triangle.map(corner), left));
        }
    }
    Looks { floats, of_triangles }
}
