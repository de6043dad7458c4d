//! The meshes of an animation's frames.

use crate::error::Error;
use crate::meshes::{joined, load_mesh};
use crate::scene::MeshSource;
use std::path::PathBuf;
use std::sync::Arc;
use vitrum_io::Mesh;

/// The meshes of a scene from frame to frame, of which those that move ([`MeshSource::time`]) are made anew for each and others are read once.
#[derive(Debug)]
pub struct MovingMeshes {
    base: PathBuf,
    max_bytes: Option<u64>,
    /// Each mesh of the last frame and its source, untwisted.
    parts: Vec<(MeshSource, Mesh)>,
    /// All of them as one.
    whole: Option<Arc<Mesh>>,
}

impl MovingMeshes {
    /// No meshes yet. Relative paths start at `base`; a file may have at most `max_bytes` bytes.
    pub fn new(base: impl Into<PathBuf>, max_bytes: Option<u64>) -> Self {
        Self { base: base.into(), max_bytes, parts: Vec::new(), whole: None }
    }

    /// The meshes that `sources` name as one, as [`crate::load_meshes`] makes it: the same one as for the last frame where nothing but `twist` has changed.
    ///
    /// # Errors
    /// As [`crate::load_meshes`].
    pub fn at(&mut self, sources: &[MeshSource]) -> Result<Arc<Mesh>, Error> {
        let untwisted = |source: &MeshSource| MeshSource { twist: 0.0, ..source.clone() };
        let sources: Vec<MeshSource> = sources.iter().map(untwisted).collect();
        if let Some(whole) = &self.whole
            && sources.iter().eq(self.parts.iter().map(|(source, _)| source))
        {
            return Ok(Arc::clone(whole));
        }
        self.whole = None;
        self.parts.truncate(sources.len());
        for (index, source) in sources.into_iter().enumerate() {
            if self.parts.get(index).is_some_and(|(known, _)| *known == source) {
                continue;
            }
            let part = load_mesh(&source, &self.base, self.max_bytes)?;
            match self.parts.get_mut(index) {
                Some(known) => *known = (source, part),
                None => self.parts.push((source, part)),
            }
        }
        let whole = Arc::new(joined(self.parts.iter().map(|(_, mesh)| mesh.clone()).collect())?);
        Ok(Arc::clone(self.whole.insert(whole)))
    }
}

#[cfg(all(test, feature = "builtin"))]
mod tests {
    use super::*;
    use crate::load_meshes;
    use std::path::Path;

    fn source(builtin: &str, time: Option<f32>) -> MeshSource {
        MeshSource { builtin: Some(builtin.to_owned()), time, ..MeshSource::default() }
    }

    #[test]
    fn every_frame_has_the_meshes_of_its_sources() {
        let mut meshes = MovingMeshes::new("", None);
        let mut last = None;
        for sources in [
            vec![source("waves", None)],
            vec![source("waves", Some(0.5))],
            vec![source("waves", Some(0.5)), MeshSource { position: [0.0, 0.0, 3.0], ..source("torus", None) }],
            vec![source("waves", Some(1.0)), source("torus", None)],
            vec![source("torus", None)],
        ] {
            let found = meshes.at(&sources).unwrap();
            assert_eq!(*found, load_meshes(&sources, Path::new(""), None).unwrap());
            assert!(Arc::ptr_eq(&found, &meshes.at(&sources).unwrap()), "nothing has changed");
            assert!(last.is_none_or(|last| !Arc::ptr_eq(&last, &found)));
            last = Some(found);
        }
        let twisted = MeshSource { twist: 90.0, ..source("torus", None) };
        assert!(Arc::ptr_eq(&last.unwrap(), &meshes.at(&[twisted]).unwrap()), "methods twist");
    }

    #[test]
    fn a_mesh_that_is_missing_leaves_the_others_as_they_are() {
        let mut meshes = MovingMeshes::new("", None);
        let sources = [source("waves", Some(2.0)), source("torus", None)];
        let before = meshes.at(&sources).unwrap();
        assert!(meshes.at(&[source("waves", Some(3.0)), source("no", None)]).is_err());
        assert_eq!(*meshes.at(&sources).unwrap(), *before);
        assert!(meshes.at(&[]).is_err(), "no mesh");
    }
}
