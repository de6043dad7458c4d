//! The table of what paths gave.

use super::hold;
use vitrum_conformance::scattering::table::SETS;

/// Paths for each viewing ray.
const SAMPLES: u64 = 1 << 13;

#[test]
fn the_table_is_what_paths_give() {
    let mut off = Vec::new();
    for set in SETS {
        for (ray, [once, twice, more]) in set.radiance().into_iter().enumerate() {
            let seed = 100 + off.len() as u64;
            let found = [(2, seed), (u32::MAX, seed + 1)].map(|(highest, seed)| set.look(ray, highest, SAMPLES, seed));
            let [two, all] = found;
            off.extend([all.once.off_from(once), two.more.off_from(twice), all.more.off_from(more)]);
        }
    }
    hold(&off, "the table");
}
