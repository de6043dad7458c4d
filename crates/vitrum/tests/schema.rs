//! The published schema is the code's.

use std::path::Path;
use vitrum::scene::Scene;

#[test]
fn the_published_schema_is_current() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/vitrum-scene.schema.json");
    let published = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let advice = "docs/vitrum-scene.schema.json is stale; run: cargo xtask docs";
    // Git may have put other line ends into it.
    assert!(published.lines().eq(Scene::json_schema().lines()), "{advice}");
}
