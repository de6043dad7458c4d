//! Which pixel a viewing ray belongs to.
//!
//! Sixteen rays that follow one another in their buffer run together on the CPU and take as long as the one that has most to do. So they are
//! a square of four by four pixels, not a row: nearer to one another, they cross and leave the same bricks.

/// Pixels along each side of a tile.
const TILE: u32 = 4;
/// Rays in a tile.
const RAYS: u32 = TILE * TILE;

/// Whether (x, y) lies among four whole tiles side by side, which as many rows of rays make up.
#[inline(always)]
fn is_tiled(width: u32, height: u32, x: u32, y: u32) -> bool {
    (x < width - width % RAYS) & (y < height - height % TILE)
}

/// The pixel of ray (x, y) of a picture of `width` × `height` pixels.
#[inline(always)]
pub fn pixel(width: u32, height: u32, x: u32, y: u32) -> (u32, u32) {
    let (across, down) = (x % RAYS, y % TILE);
    if is_tiled(width, height, x, y) {
        (x - across + down * TILE + across % TILE, y - down + across / TILE)
    } else {
        (x, y)
    }
}

/// The number of the ray of pixel (x, y) of a picture of `width` × `height` pixels.
#[inline(always)]
pub fn ray(width: u32, height: u32, x: u32, y: u32) -> u32 {
    // The same exchange of rows and columns as in `pixel`. Calling that here instead put rays on wrong pixels on the GPU.
    let (across, down) = (x % RAYS, y % TILE);
    if is_tiled(width, height, x, y) {
        (y - down + across / TILE) * width + (x - across + down * TILE + across % TILE)
    } else {
        y * width + x
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_pixel_has_its_ray() {
        for (width, height) in [(1, 1), (16, 4), (37, 11), (64, 63), (15, 8), (48, 3)] {
            for index in 0..width * height {
                let (x, y) = pixel(width, height, index % width, index / width);
                assert!(x < width && y < height);
                assert_eq!(ray(width, height, x, y), index);
            }
        }
    }

    #[test]
    fn sixteen_rays_are_a_square() {
        let pixels = (0..16).map(|x| pixel(64, 64, 32 + x, 22));
        let (across, down): (Vec<u32>, Vec<u32>) = pixels.unzip();
        assert_eq!(across.iter().max().zip(across.iter().min()), Some((&43, &40)));
        assert_eq!(down.iter().max().zip(down.iter().min()), Some((&23, &20)));
    }
}
