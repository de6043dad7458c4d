//! What would make the picture of a scene take less time.

use vitrum::scene::{MethodName, Scene, Surfaces};

/// Advice in one sentence: the scene's own costly settings, those that cost most first, and what always helps.
pub fn advice(scene: &Scene, backend: &str) -> String {
    let mut ways = Vec::new();
    let film = &scene.film;
    if film.supersampling > 1 {
        ways.push(format!("film.supersampling=1 instead of {}", film.supersampling));
    }
    if scene.environment.lights > 0 {
        ways.push(format!("fewer environment.lights than {}", scene.environment.lights));
    }
    if scene.light.iter().filter(|light| light.shadows).count() > 1 {
        ways.push("lights without shadows (light.0.shadows=false)".to_owned());
    }
    let shows_mesh = scene.shows_mesh();
    if scene.shadow.samples > 1 && shows_mesh {
        ways.push(format!("fewer shadow.samples than {}", scene.shadow.samples));
    }
    if scene.method == MethodName::Beams {
        ways.push(format!("fewer beams.rays than {}", scene.beams.rays));
    }
    if shows_mesh && scene.voxels.surfaces == Surfaces::Exact {
        ways.push("voxels.surfaces=multi".to_owned());
    } else if shows_mesh {
        ways.push(format!("a smaller voxelization.resolution than {}", scene.voxelization.resolution));
    }
    if !shows_mesh {
        ways.push("a coarser volume (`vitrum convert --size`)".to_owned());
    }
    ways.push(format!("a smaller picture, such as --size {}x{}", film.width.div_ceil(2), film.height.div_ceil(2)));
    if backend == "cpu" {
        ways.push("a graphics card (--backend gpu)".to_owned());
    }
    format!("faster: {}", ways.join(", "))
}

#[cfg(test)]
mod tests {
    use super::advice;
    use vitrum::builtin;

    #[test]
    fn advice_is_of_the_scene() {
        let mut scene = builtin::scene("ball").expect("listed");
        let usual = advice(&scene, "cpu");
        assert!(usual.contains("--size 256x256") && usual.contains("--backend gpu"), "{usual}");
        assert!(!usual.contains("supersampling") && !usual.contains("beams"), "{usual}");
        scene.film.supersampling = 3;
        assert!(advice(&scene, "gpu").starts_with("faster: film.supersampling=1 instead of 3, "));
        let ring = builtin::scene("ring").expect("listed");
        assert!(advice(&ring, "gpu").contains("beams.rays"), "{}", advice(&ring, "gpu"));
    }
}
