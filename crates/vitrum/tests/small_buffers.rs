//! Light that is carried forward on a card with small buffers: each buffer of the frame fits.

mod common;

use common::{Watch, Watched, small};
use vitrum::OutputRequest;
use vitrum::backend::{BackendError, Contents};

/// Cells along the longer side of the wavefront.
const CELLS: u32 = 64;
/// A buffer holds as many bytes a cell as those of a portable card hold with 512² cells, 2²⁷.
const LARGEST: u64 = 512 * CELLS as u64 * CELLS as u64;

/// A card whose buffers are small.
#[derive(Default)]
struct Small {
    /// Bytes of the largest buffer that was made.
    made: u64,
}

impl Watch for Small {
    fn largest_buffer(&self) -> u64 {
        LARGEST
    }

    fn creates(&mut self, contents: &Contents<'_>) -> Result<(), BackendError> {
        self.made = self.made.max(contents.bytes());
        Ok(())
    }
}

#[test]
fn light_carried_forward_fits_into_buffers() {
    let (mut scene, assets) = small("ball");
    let mut backend = Watched::new(Small::default());
    for setting in [format!("sweep.light_cells={CELLS}"), "sweep.sample_distance=0.25".to_owned()] {
        scene.set(&setting).expect("it is a key");
    }
    let frame = vitrum::render_requested(
        &scene,
        &assets,
        OutputRequest { light: true, ..OutputRequest::default() },
        &mut backend,
        &mut |_| true,
    )
    .expect("it renders");
    assert!(frame.layers.iter().flat_map(|layer| &layer.channels).all(|channel| !channel.data.is_empty()));
    let made = backend.watch.made;
    assert!(made <= LARGEST, "a buffer of {made} bytes was made; a card allows {LARGEST}");
}
