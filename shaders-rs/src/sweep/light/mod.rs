//! The light that the sweep carries from plane to plane: the grid of light texels and its look-ups, directions in one word, derivatives
//! between texels, sheets, and the light that nothing has changed.

pub mod around;
pub mod arriving;
pub mod look_up;
pub mod offset;
pub mod sheet;
pub mod slopes;
pub mod unoccluded;
