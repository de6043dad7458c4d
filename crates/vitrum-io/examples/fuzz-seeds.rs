//! Writes what coverage-guided fuzzing starts from: whole files of every format, `FOLDER/corpus/TARGET/seed-N`, and the words
//! of the format, `FOLDER/dictionaries/TARGET`. `cargo xtask fuzz` runs it. Each has been read once then, as fuzzing would.

#[path = "../tests/common/mod.rs"]
mod common;
#[path = "../tests/readers/mod.rs"]
mod readers;
#[path = "../tests/readers/seeds.rs"]
mod seeds;
#[path = "../tests/readers/words.rs"]
mod words;

use std::path::Path;
use std::{env, fs, io};

fn main() -> io::Result<()> {
    let folder = env::args().nth(1).ok_or_else(|| io::Error::other("name the folder to write to"))?;
    let folder = Path::new(&folder);
    let dictionaries = folder.join("dictionaries");
    fs::create_dir_all(&dictionaries)?;
    let readers = readers::Readers::new("seeds");
    for target in readers::names() {
        let corpus = folder.join("corpus").join(target);
        fs::create_dir_all(&corpus)?;
        for (index, seed) in seeds::seeds(target).iter().enumerate() {
            readers.read(target, seed);
            fs::write(corpus.join(format!("seed-{index}")), seed)?;
        }
        fs::write(dictionaries.join(target), words::words(target).iter().map(|word| entry(word)).collect::<String>())?;
    }
    Ok(())
}

/// A line of a libFuzzer dictionary.
fn entry(word: &str) -> String {
    let escaped = word.bytes().map(|byte| match byte {
        b'"' | b'\\' => format!("\\{}", char::from(byte)),
        b' '..=b'~' => char::from(byte).to_string(),
        _ => format!("\\x{byte:02x}"),
    });
    format!("\"{}\"\n", escaped.collect::<String>())
}
