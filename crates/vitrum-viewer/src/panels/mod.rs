//! Panels generated from the schema of scenes.
