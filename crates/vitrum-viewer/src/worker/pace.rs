//! The resolution at which a picture follows the hand.

use super::ladder::Rung;

/// Seconds that a picture may take while something is dragged: two frames of a screen.
pub const TARGET: f64 = 0.033;

/// The least edge of a picture that is still readable, along its shorter side, in pixels.
pub const LEAST_EDGE: u32 = 160;

/// The largest factor on the distance of samples.
const COARSEST: f64 = 4.0;

/// A change of the resolution that is worth it: smaller ones would make the picture flicker, and buffers anew.
const WORTHWHILE: f64 = 1.2;

/// The most that one picture's time may change the next one's work: a single slow frame should not throw the resolution away.
const BOLDEST: f64 = 3.0;

/// Cells of light along a side, times the factor on the distance of samples: light that turns with the camera is carried anew for each picture.
const CELLS: f64 = 192.0;

/// The controller of the resolution while something is dragged: it is told the time of each picture, and says how large the next one is, and how far apart
/// its samples and the cells of its light are, so that it takes [`TARGET`]. The size gives way first, down to [`LEAST_EDGE`], then samples and cells.
#[derive(Debug, Clone, PartialEq)]
pub struct Pace {
    /// Share of the whole picture's edge.
    share: f64,
    /// Factor on the distance of samples along rays.
    distance: f64,
}

impl Default for Pace {
    fn default() -> Self {
        Self { share: 0.5, distance: 2.0 }
    }
}

impl Pace {
    /// The size of the next picture, of a whole one of `size`.
    #[must_use]
    pub fn size(&self, size: [u32; 2]) -> [u32; 2] {
        let share = self.share.max(least_share(size));
        size.map(|edge| ((f64::from(edge) * share + 0.5) as u32).clamp(1, edge))
    }

    /// The factor on the distance of the next picture's samples.
    #[must_use]
    pub fn distance(&self) -> f32 {
        // Steps of a half: what depends on the distance is made anew with each change.
        ((self.distance * 2.0 + 0.5).floor() * 0.5) as f32
    }

    /// The most cells along a side of the next picture's light; as many as the scene says if `None`.
    #[must_use]
    pub fn light_cells(&self) -> Option<u32> {
        let distance = f64::from(self.distance());
        (distance > 1.0).then_some((CELLS / distance) as u32)
    }

    /// The next picture, of a whole one of `size`.
    #[must_use]
    pub fn rung(&self, size: [u32; 2]) -> Rung {
        Rung { size: self.size(size), single_rays: true, distance: self.distance(), light_cells: self.light_cells() }
    }

    /// Takes the time into account that a picture of the size and distance that this named took, of a whole one of `size`.
    pub fn took(&mut self, seconds: f64, size: [u32; 2]) {
        let least = least_share(size);
        self.share = self.share.max(least);
        let ratio = (seconds.max(1e-4) / TARGET).clamp(1.0 / BOLDEST, BOLDEST);
        if (1.0 / WORTHWHILE..WORTHWHILE).contains(&ratio) {
            return;
        }
        if ratio > 1.0 {
            // Pixels go with the square of the edge.
            let wanted = self.share / ratio.sqrt();
            self.share = wanted.max(least);
            if wanted < least {
                let left = (wanted / least) * (wanted / least);
                self.distance = (self.distance / left).min(COARSEST);
            }
        } else if self.distance > 1.0 {
            self.distance = (self.distance * ratio.sqrt()).max(1.0);
        } else {
            // Half of the way: it comes from below, and does not swing.
            self.share = (self.share / ratio.sqrt().sqrt()).min(1.0);
        }
    }

    /// Share of the whole picture's edge, for people.
    #[must_use]
    pub fn share(&self) -> f64 {
        self.share
    }
}

fn least_share(size: [u32; 2]) -> f64 {
    let shorter = size[0].min(size[1]).max(1);
    (f64::from(LEAST_EDGE) / f64::from(shorter)).min(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Seconds of a picture on a machine that takes `fixed` and `per_sample` for each pixel at the usual distance.
    fn run(pace: &mut Pace, size: [u32; 2], fixed: f64, per_pixel: f64) -> f64 {
        let mut seconds = 0.0;
        for _ in 0..40 {
            let [width, height] = pace.size(size);
            seconds = fixed + f64::from(width * height) * per_pixel / f64::from(pace.distance());
            pace.took(seconds, size);
        }
        seconds
    }

    #[test]
    fn a_fast_machine_shows_the_whole_picture_and_a_slow_one_what_it_can() {
        let size = [1024, 512];
        let mut pace = Pace::default();
        run(&mut pace, size, 0.001, 1e-8);
        assert_eq!((pace.size(size), pace.distance()), (size, 1.0));
        let seconds = run(&mut pace, size, 0.001, 2e-7);
        assert!((0.02..0.045).contains(&seconds), "{seconds}");
        assert!(pace.size(size)[0] < 700 && pace.distance() == 1.0, "{pace:?}");
        // The size is as small as may be, and samples are coarser.
        let seconds = run(&mut pace, size, 0.001, 1.5e-6);
        assert_eq!(pace.size(size), [320, 160]);
        assert!(pace.distance() > 1.0 && seconds < 0.05, "{pace:?}, {seconds}");
        // Even where no size is fast enough it stays readable.
        run(&mut pace, size, 1.0, 1e-5);
        assert_eq!((pace.size(size), pace.distance()), ([320, 160], COARSEST as f32));
        run(&mut pace, size, 0.0, 1e-8);
        assert_eq!((pace.size(size), pace.distance()), (size, 1.0));
    }

    #[test]
    fn a_resolution_that_fits_stays() {
        let mut pace = Pace::default();
        assert_eq!(pace.light_cells(), Some(96));
        let before = pace.clone();
        pace.took(TARGET * 1.1, [800, 600]);
        pace.took(TARGET * 0.9, [800, 600]);
        assert_eq!(pace, before);
    }

    #[test]
    fn small_pictures_are_whole() {
        assert_eq!(Pace::default().size([100, 90]), [100, 90]);
        assert_eq!(Pace::default().size([1, 1]), [1, 1]);
    }
}
