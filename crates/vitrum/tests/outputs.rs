//! Named outputs: each method has those that are listed, and pixels of several rays stay what their output says.

use vitrum::backend::CpuBackend;
use vitrum::method;
use vitrum::scene::{MethodName, Scene};
use vitrum::{Assets, Frame, builtin, render};

fn frame(name: &str, supersampling: u32) -> (Scene, Frame) {
    let mut scene = builtin::scene(name).unwrap();
    (scene.film.width, scene.film.height, scene.film.supersampling) = (24, 20, supersampling);
    scene.voxelization.resolution = 32;
    scene.volume.resolution = Some(32).filter(|_| scene.mesh.is_empty());
    let assets = Assets::load(&scene, std::path::Path::new("")).unwrap();
    let mut backend = CpuBackend::new(None).unwrap();
    let frame = render(&scene, &assets, &mut backend, &mut |_| true).unwrap();
    (scene, frame)
}

#[test]
fn frames_have_the_outputs_that_are_listed() {
    for (name, method) in [("ball", MethodName::Sweep), ("vase", MethodName::Voxels)] {
        let (scene, frame) = frame(name, 1);
        assert_eq!(scene.method, method);
        let outputs = method::of(method).outputs();
        let mut listed: Vec<&str> = outputs.iter().map(|output| output.name).collect();
        let mut found: Vec<&str> = frame.layers.iter().map(|layer| layer.name.as_str()).collect();
        found.extend(frame.light.as_ref().map(|_| "light"));
        listed.sort_unstable();
        found.sort_unstable();
        assert_eq!(found, listed, "{name}");
        for layer in &frame.layers {
            let output = outputs.iter().find(|output| output.name == layer.name).expect("it is listed");
            assert_eq!(layer.is_vector(), output.is_vector, "{name}: {}", layer.name);
        }
    }
}

#[test]
fn pixels_of_several_rays_hold_unit_vectors_and_whole_numbers() {
    for (name, vectors, numbers) in
        [("ball", &["direction"][..], &["status"][..]), ("vase", &["direction", "normal"], &["status", "bounces"])]
    {
        let (_, frame) = frame(name, 2);
        for vector in vectors {
            let component = |channel: &str| frame.channel(vector, channel).unwrap();
            for ((x, y), z) in component("X").iter().zip(component("Y")).zip(component("Z")) {
                let length = (x * x + y * y + z * z).sqrt();
                // Four roundings.
                assert!(length == 0.0 || (length - 1.0).abs() < 5e-7, "{name}: {vector} has length {length}");
            }
        }
        for number in numbers {
            let values = frame.channel(number, "Y").unwrap();
            assert!(values.iter().all(|value| value.fract() == 0.0), "{name}: {number}");
            assert!(values.iter().any(|value| *value > 0.0), "{name}: {number} is nothing but 0");
        }
    }
}

#[test]
fn depth_is_that_of_what_is_there() {
    // The vase's edge has pixels of which some rays miss: their depth lies on the vase, not halfway to the eye.
    let (_, frame) = frame("vase", 2);
    let depth = frame.channel("depth", "Z").unwrap();
    let seen: Vec<f32> = depth.iter().copied().filter(|&depth| depth > 0.0).collect();
    let (nearest, farthest) = seen.iter().fold((f32::MAX, 0.0_f32), |(low, high), &z| (low.min(z), high.max(z)));
    assert!(seen.len() < depth.len() && nearest > 0.5 * farthest, "{nearest} to {farthest}");
}
