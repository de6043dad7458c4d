//! The program `vitrum-viewer`.

fn main() {}
