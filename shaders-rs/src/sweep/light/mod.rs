//! The light that the sweep carries from plane to plane: the grid of light texels and its look-ups, directions in one word, derivatives
//! between texels, the wavefront with the bricks and maps that it fills, the light of points and spots, and the light that nothing has changed.

pub mod around;
pub mod arriving;
pub mod body;
pub mod bricks;
pub mod carried;
pub mod cell;
pub mod look_up;
pub mod matter;
pub mod offset;
pub mod placed;
pub mod quad;
pub mod receiver_map;
pub mod samples;
pub mod slopes;
pub mod unoccluded;
pub mod wavefront;
