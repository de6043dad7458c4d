//! Triangles that follow each other by one vertex each.

use super::build::Builder;
use crate::error::Error;

/// Adds a strip's triangles; every second one runs the other way. Those that have a vertex twice, which is how strips
/// are joined, are left out and counted.
pub(super) fn strip(builder: &mut Builder, vertices: &[u32]) -> Result<u64, Error> {
    let mut joints = 0;
    for (index, window) in vertices.windows(3).enumerate() {
        let [a, b, c] = [window[0], window[1], window[2]];
        if a == b || b == c || c == a {
            joints += 1;
        } else {
            builder.triangle(if index % 2 == 0 { [a, b, c] } else { [a, c, b] })?;
        }
    }
    Ok(joints)
}

/// The assumption about so many joints.
pub(super) fn joints_note(joints: u64) -> Option<String> {
    (joints > 0).then(|| format!("{joints} triangles of strips that have a vertex twice were left out"))
}
