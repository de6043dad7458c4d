//! Nothing is built: cargo looks at the features of build dependencies only where there is a build script. `Cargo.toml` says which, and why.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
}
