//! Vertices at one position.

use std::collections::HashMap;
use std::collections::hash_map::Entry;

/// Numbers positions so that equal ones have one number; -0 equals 0.
#[derive(Debug, Default)]
pub(super) struct Weld(HashMap<[u32; 3], u32>);

impl Weld {
    /// The position's number, and whether it is a new one: those count up from 0.
    pub fn number(&mut self, position: [f32; 3]) -> (u32, bool) {
        // Adding 0 turns -0 into 0.
        let key = position.map(|coordinate| (coordinate + 0.0).to_bits());
        let next = self.0.len() as u32;
        match self.0.entry(key) {
            Entry::Occupied(entry) => (*entry.get(), false),
            Entry::Vacant(entry) => (*entry.insert(next), true),
        }
    }

    /// Count of the numbers that were given.
    pub fn len(&self) -> usize {
        self.0.len()
    }
}
