//! Some hundred changes to every whole file of every format, the same ones each time: whatever the bytes are, reading them ends in a
//! whole value or an error. `cargo xtask fuzz` goes on from here with coverage as its guide.

mod common;
mod readers;
#[path = "readers/seeds.rs"]
mod seeds;
#[path = "readers/words.rs"]
mod words;

use std::collections::BTreeSet;
use std::path::Path;

use readers::Readers;

/// Mutations of each seed.
const ROUNDS: usize = 250;

/// Numbers that are most often mistaken.
const NUMBERS: [&str; 12] =
    ["0", "-1", "1", "255", "65536", "2147483648", "4294967295", "9223372036854775807", "1e39", "1e-320", "nan", ""];

/// A small generator with a period that is long enough (xorshift64*).
struct Random(u64);

impl Random {
    fn below(&mut self, end: usize) -> usize {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 33) as usize % end.max(1)
    }
}

/// One to four changes.
fn mutate(file: &mut Vec<u8>, others: &[Vec<u8>], words: &[&str], random: &mut Random) {
    for _ in 0..=random.below(4) {
        let at = random.below(file.len() + 1);
        let end = (at + 1 + random.below(16)).min(file.len());
        match random.below(9) {
            0 if at < file.len() => file[at] ^= 1 << random.below(8),
            1 if at < file.len() => file[at] = [0, 1, 0x7f, 0x80, 0xff, b' ', b'\n', b'0'][random.below(8)],
            2 => file.truncate(at),
            3 => drop(file.drain(at.min(end)..end)),
            4 => {
                let again = file[at.min(end)..end].to_vec();
                file.splice(at..at, again);
            }
            5 if !words.is_empty() => drop(file.splice(at..at, words[random.below(words.len())].bytes())),
            6 => {
                let value = [u32::MAX, 1 << 31, 0x7fff_ffff, 0, 1, 0x0100_0000][random.below(6)];
                for (place, byte) in file[at..].iter_mut().zip(value.to_ne_bytes()) {
                    *place = byte;
                }
            }
            7 => {
                // A whole number of a text for another one.
                let Some(start) = (at..file.len()).find(|&at| file[at].is_ascii_digit()) else { continue };
                let stop = (start..file.len()).find(|&at| !file[at].is_ascii_digit()).unwrap_or(file.len());
                file.splice(start..stop, NUMBERS[random.below(NUMBERS.len())].bytes());
            }
            _ => {
                let other = &others[random.below(others.len())];
                file.truncate(at);
                file.extend(&other[random.below(other.len())..]);
            }
        }
    }
}

#[test]
fn every_reader_survives_mutations() {
    let readers = Readers::new("mutations");
    for target in readers::names() {
        let seeds = seeds::seeds(target);
        for (index, seed) in seeds.iter().enumerate() {
            readers.read(target, seed);
            let mut random = Random(0x9e37_79b9_7f4a_7c15 ^ (index as u64 + 1));
            for _ in 0..ROUNDS {
                let mut file = seed.clone();
                mutate(&mut file, &seeds, words::words(target), &mut random);
                readers.read(target, &file);
            }
        }
    }
}

#[test]
fn there_is_a_fuzz_target_for_every_reader() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/fuzz_targets");
    let entries = std::fs::read_dir(&folder).expect("the folder is part of the project");
    let names = entries.map(|entry| entry.expect("an entry").path());
    let names: BTreeSet<_> =
        names.map(|path| path.file_stem().unwrap_or_default().to_string_lossy().into_owned()).collect();
    assert_eq!(names, readers::names().map(str::to_owned).collect());
    let volumes = vitrum_io::readers().len() + vitrum_io::mesh_readers().len();
    // Beside them: materials, transfer functions and five formats of pictures.
    assert_eq!(
        names.len(),
        volumes + 7,
        "a new format needs a target in tests/readers/mod.rs and in fuzz/fuzz_targets"
    );
}
