//! The editor of transfer functions.
