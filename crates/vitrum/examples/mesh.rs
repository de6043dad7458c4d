//! Renders a mesh that a program has in memory, a tetrahedron of glass, by rays through its triangles.

use vitrum::backend::CpuBackend;
use vitrum::io::Mesh;
use vitrum::scene::{MethodName, Scene, Surfaces};
use vitrum::{OutputRequest, Renderer, preset};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let corners = vec![[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];
    let faces = vec![[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]];
    let mesh = Mesh::new("a tetrahedron", corners, faces)?;
    let mut scene = Scene { method: MethodName::Voxels, ..Scene::default() };
    preset::surround_mesh(&mut scene);
    scene.voxels.surfaces = Surfaces::Exact;
    scene.camera.elevation = 20.0;
    (scene.film.width, scene.film.height) = (160, 160);
    let mut renderer = Renderer::new(Box::new(CpuBackend::new(None)?), mesh);
    renderer.render(&scene, OutputRequest::default(), &mut |_| true)?.write("tetrahedron.png".as_ref())?;
    Ok(())
}
