//! Sheets of light that do not fit into one buffer lie in several: the same picture to the last bit.

mod common;

use common::{Watch, Watched, cpu, small};
use std::sync::{Arc, Mutex};
use vitrum::OutputRequest;
use vitrum::backend::{Backend, BackendError, PassList};

/// A card whose buffers hold two sheets or so.
struct Small {
    /// Batches of sheets in the pass list that ran.
    batches: Arc<Mutex<usize>>,
}

impl Watch for Small {
    fn largest_buffer(&self) -> u64 {
        1 << 16
    }

    fn runs(&mut self, passes: &PassList) -> Result<(), (usize, BackendError)> {
        let names = passes.passes.iter().map(|pass| pass.kernel.declaration.name);
        *self.batches.lock().expect("no test panicked") +=
            names.filter(|name| *name == "sweep_initialize_sheet").count();
        Ok(())
    }
}

#[test]
fn sheets_in_several_buffers_give_the_same_picture() {
    let (mut scene, assets) = small("ball/sheets");
    scene.set("sweep.sheets=5").expect("it is a key");
    let render = |backend: &mut dyn Backend| {
        vitrum::render_requested(&scene, &assets, OutputRequest { light: true }, backend, &mut |_| true)
            .expect("it renders")
    };
    let batches = Arc::default();
    let divided = render(&mut Watched::new(Small { batches: Arc::clone(&batches) }));
    let whole = render(&mut cpu());
    assert!(*batches.lock().expect("no test panicked") > 1, "everything fitted into one buffer");
    let bits = |frame: &vitrum::Frame| -> Vec<Vec<u32>> {
        let channels = frame.layers.iter().flat_map(|layer| &layer.channels);
        channels.map(|channel| channel.data.iter().map(|value| value.to_bits()).collect()).collect()
    };
    assert_eq!(bits(&divided), bits(&whole));
}
