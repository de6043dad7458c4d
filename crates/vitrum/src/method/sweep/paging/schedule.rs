//! The schedule of pages: the plane before which each is loaded, and its slot.

use super::residency::ResidentPage;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Pages that are loaded together.
#[derive(Debug, Default, PartialEq, Eq)]
pub(super) struct Batch {
    /// The plane before whose passes the pages are loaded.
    pub(super) plane: u32,
    /// The slots with their new pages, in the order of the slots.
    pub(super) pages: Vec<(u32, u32)>,
}

/// The largest number of pages that a plane needs.
pub(super) fn peak_pages(needed: &[ResidentPage]) -> usize {
    let planes = needed.iter().map(|need| need.last as usize + 2).max().unwrap_or(0);
    let mut changes = vec![0_i64; planes];
    for need in needed {
        changes[need.first as usize] += 1;
        changes[need.last as usize + 1] -= 1;
    }
    let counts = changes.iter().scan(0, |count, change| {
        *count += change;
        Some(*count)
    });
    counts.max().unwrap_or(0) as usize
}

/// Batches that load every page before the first plane that reads it and leave it in its slot until the last such plane. `slots` must
/// be at least [`peak_pages`]. A batch loads the pages of as many planes, from its own on, as the slots hold.
pub(super) fn schedule(needed: &[ResidentPage], slots: usize) -> Vec<Batch> {
    let mut coming: Vec<&ResidentPage> = needed.iter().collect();
    coming.sort_by_key(|need| (need.first, need.page));
    let mut coming = coming.as_slice();
    let mut free: BinaryHeap<Reverse<u32>> = (0..slots as u32).map(Reverse).collect();
    // The pages in slots, the first to leave on top.
    let mut there: BinaryHeap<Reverse<(u32, u32)>> = BinaryHeap::new();
    let mut batches = Vec::new();
    while let Some(next) = coming.first() {
        let plane = next.first;
        while let Some(&Reverse((last, slot))) = there.peek()
            && last < plane
        {
            there.pop();
            free.push(Reverse(slot));
        }
        // Whole planes at once: the batch after this one begins with a plane for which there was no room.
        let mut count = 0;
        for together in coming.chunk_by(|a, b| a.first == b.first) {
            if count + together.len() > free.len() {
                break;
            }
            count += together.len();
        }
        debug_assert!(count > 0, "slots for the pages of every plane");
        let (now, later) = coming.split_at(count.max(1).min(coming.len()));
        coming = later;
        let slots: Vec<u32> = now.iter().filter_map(|_| free.pop()).map(|Reverse(slot)| slot).collect();
        there.extend(now.iter().zip(&slots).map(|(need, &slot)| Reverse((need.last, slot))));
        batches.push(Batch { plane, pages: slots.into_iter().zip(now.iter().map(|need| need.page)).collect() });
    }
    batches
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Plays the batches and looks whether every page is there when it is needed.
    fn check(needed: &[ResidentPage], slots: usize) -> usize {
        let batches = schedule(needed, slots);
        let planes = needed.iter().map(|need| need.last).max().unwrap_or(0);
        let mut there = vec![None; slots];
        let mut brought = 0;
        for plane in 0..=planes {
            for batch in batches.iter().filter(|batch| batch.plane == plane) {
                assert!(batch.pages.is_sorted_by(|a, b| a.0 < b.0));
                brought += batch.pages.len();
                for &(slot, page) in &batch.pages {
                    there[slot as usize] = Some(page);
                }
            }
            for need in needed.iter().filter(|need| (need.first..=need.last).contains(&plane)) {
                assert!(there.contains(&Some(need.page)), "page {} at plane {plane}", need.page);
            }
        }
        assert_eq!(brought, needed.len(), "each page comes once");
        batches.len()
    }

    /// Pages that overlap irregularly.
    fn needed() -> Vec<ResidentPage> {
        (0..200)
            .map(|page| {
                let first = 1 + page * 7919 % 90;
                ResidentPage { page, first, last: first + page * 31 % 17 }
            })
            .collect()
    }

    #[test]
    fn pages_are_there_when_they_are_needed() {
        let needed = needed();
        let least = peak_pages(&needed);
        let found = [least, least + 1, 2 * least, needed.len()].map(|slots| check(&needed, slots));
        assert!(found.is_sorted_by(|a, b| a >= b) && found[0] > 10 && found[3] == 1, "{found:?} batches");
    }

    #[test]
    fn the_most_pages_of_a_plane_are_found() {
        let need = |first, last| ResidentPage { page: 0, first, last };
        assert_eq!(peak_pages(&[]), 0);
        assert_eq!(peak_pages(&[need(1, 1), need(2, 5), need(5, 7), need(4, 4)]), 2);
        let needed = needed();
        let at = |plane: u32| needed.iter().filter(|need| (need.first..=need.last).contains(&plane)).count();
        assert_eq!(Some(peak_pages(&needed)), (0..120).map(at).max());
    }
}
