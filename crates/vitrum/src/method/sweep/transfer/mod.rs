//! Transfer functions as functions of a normalised scalar, and the abscissae of their tables.

pub(super) mod abscissa;
pub(super) mod curve;
pub(super) mod isosurfaces;
pub(super) mod preintegration;
pub(super) mod window;
