//! The pictures on the way to the whole one.

use vitrum::scene::Scene;

/// A picture on the way to the whole one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rung {
    /// Pixels across and down.
    pub size: [u32; 2],
    /// Whether each pixel has one ray, whatever the film says.
    pub single_rays: bool,
    /// Factor on the distance of samples along rays.
    pub distance: f32,
    /// The most cells along a side of the light's wavefront; as many as the scene says if `None`.
    pub light_cells: Option<u32>,
}

/// Cells along a side of the light of the pictures before the whole one.
const FIRST_CELLS: u32 = 96;

/// Seconds from which on a picture is worth one of a quarter of its edge before it.
const LONG: f64 = 0.4;

/// Seconds from which on a picture is worth one of half its edge before it.
const NOTICEABLE: f64 = 0.12;

/// The pictures of a view at rest, each better than the one before; the last one is the scene's own. `expected` is about how many seconds a picture of the
/// whole size takes, with one ray for each pixel.
#[must_use]
pub fn ladder(scene: &Scene, expected: f64) -> Vec<Rung> {
    let film = &scene.film;
    let whole = [film.width, film.height];
    let part = |parts: u32| Rung {
        size: whole.map(|edge| edge.div_ceil(parts)),
        single_rays: true,
        distance: 1.0,
        // Light takes as long for a small picture as for a large one.
        light_cells: (parts > 1).then_some(FIRST_CELLS),
    };
    let own = Rung { single_rays: false, ..part(1) };
    let many_rays = film.supersampling > 1 || film.refinement > 1;
    let mut rungs = Vec::new();
    rungs.extend((expected >= LONG).then(|| part(4)));
    rungs.extend((expected >= NOTICEABLE).then(|| part(2)));
    rungs.extend((many_rays && expected >= NOTICEABLE).then(|| part(1)));
    rungs.push(own);
    rungs
}

impl Rung {
    /// The scene of this picture.
    #[must_use]
    pub fn of(&self, scene: &Scene) -> Scene {
        let mut scene = scene.clone();
        [scene.film.width, scene.film.height] = self.size;
        if self.single_rays {
            (scene.film.supersampling, scene.film.refinement) = (1, 1);
        }
        if self.distance > 1.0 {
            // The largest that scenes have.
            scene.sweep.sample_distance = (scene.sweep.sample_distance * self.distance).min(16.0);
        }
        if let Some(most) = self.light_cells {
            scene.sweep.light_cells = Some(scene.sweep.light_cells.map_or(most, |own| own.min(most)));
        }
        scene
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sizes(expected: f64, refinement: u32) -> Vec<(u32, bool)> {
        let mut scene = Scene::default();
        (scene.film.width, scene.film.height, scene.film.refinement) = (402, 100, refinement);
        ladder(&scene, expected).into_iter().map(|rung| (rung.size[0], rung.single_rays)).collect()
    }

    #[test]
    fn a_picture_that_takes_long_comes_in_steps() {
        assert_eq!(sizes(1.0, 3), [(101, true), (201, true), (402, true), (402, false)]);
        assert_eq!(sizes(0.2, 3), [(201, true), (402, true), (402, false)]);
        assert_eq!(sizes(0.2, 1), [(201, true), (402, false)]);
        assert_eq!(sizes(0.01, 3), [(402, false)]);
    }

    #[test]
    fn the_last_picture_is_the_scenes_own() {
        let mut scene = Scene::default();
        scene.film.supersampling = 2;
        let last = ladder(&scene, 1.0).pop().expect("there is one");
        assert_eq!(last.of(&scene), scene);
    }
}
