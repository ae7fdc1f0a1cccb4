//! Where a window of a picture has gone in the next one: pyramidal Lucas and Kanade (Lucas and Kanade 1981; Bouguet 2000).
//!
//! **Law.** A window of the first picture is compared with the second, from the smallest pictures of both pyramids to the whole ones. Each step
//! solves `G d = e`: G is the sum of products of the window's gradients, e that of its gradients times what the pictures differ by.

use super::corners::least_eigenvalue;
use super::image::{Image, Pyramid};

/// Half of a window (pixels): it is 15 x 15.
pub const HALF: isize = 7;
/// Levels of the pyramids.
pub const LEVELS: usize = 3;
/// Most steps at a level, and the step (pixels) below which they end.
const MOST_STEPS: usize = 40;
const LEAST_STEP: f64 = 1e-4;
/// A window whose last step is still above this (pixels) has not settled. Chosen.
const UNSETTLED: f64 = 0.03;
/// Least eigenvalue of G over the pixels of a window: below it a window has too little contrast. Chosen: gradients of 1/1000 of white a pixel.
const LEAST_CONTRAST: f64 = 1e-6;
/// Most that windows may differ by (rms), over the deviation of the first one. Chosen.
const MOST_DIFFERENCE: f64 = 0.5;
/// Most that the way back may miss the beginning by (pixels). Chosen.
const MOST_MISS: f64 = 0.5;

/// Why a window is not found again.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Lost {
    /// The window reaches beyond the picture.
    Left,
    /// It has no contrast, does not settle, looks otherwise, or its way back ends elsewhere.
    Broken,
}

/// Place (pixels) in `to` of the window around `place` in `from`, found there and back.
///
/// # Errors
/// If the window is lost.
pub fn follow(from: &Pyramid, to: &Pyramid, place: [f64; 2]) -> Result<[f64; 2], Lost> {
    let found = one_way(from, to, place)?;
    let back = one_way(to, from, found)?;
    if libm::hypot(back[0] - place[0], back[1] - place[1]) > MOST_MISS {
        return Err(Lost::Broken);
    }
    Ok(found)
}

fn one_way(from: &Pyramid, to: &Pyramid, place: [f64; 2]) -> Result<[f64; 2], Lost> {
    expect_inside(from.whole(), place)?;
    let mut moved = [0.0; 2];
    for level in (0..from.levels.len()).rev() {
        let scale = f64::from(1_u32 << level);
        let window = Window::new(&from.levels[level], place.map(|at| at / scale));
        let is_whole = level == 0;
        if window.contrast() < LEAST_CONTRAST {
            // A smaller picture may be too plain; the next one begins where this one did.
            if is_whole {
                return Err(Lost::Broken);
            }
        } else {
            let (found, last) = window.found(&to.levels[level], moved.map(|at| at / scale));
            moved = found.map(|at| at * scale);
            if is_whole && last > UNSETTLED {
                return Err(Lost::Broken);
            }
            expect_inside(to.whole(), [place[0] + moved[0], place[1] + moved[1]])?;
            if is_whole && window.difference(to.whole(), moved) > MOST_DIFFERENCE {
                return Err(Lost::Broken);
            }
        }
    }
    Ok([place[0] + moved[0], place[1] + moved[1]])
}

fn expect_inside(image: &Image, place: [f64; 2]) -> Result<(), Lost> {
    let room = HALF as f64 + 1.0;
    let is_inside = |axis: usize| (room..=image.size()[axis] as f64 - 1.0 - room).contains(&place[axis]);
    if (0..2).all(is_inside) { Ok(()) } else { Err(Lost::Left) }
}

/// Values and gradients of the pixels around a place.
struct Window {
    place: [f64; 2],
    values: Vec<f64>,
    gradients: Vec<[f64; 2]>,
    /// Sums of products of gradients: x x, x y, y y.
    products: [f64; 3],
}

fn offsets() -> impl Iterator<Item = [f64; 2]> {
    (-HALF..=HALF).flat_map(|y| (-HALF..=HALF).map(move |x| [x as f64, y as f64]))
}

impl Window {
    fn new(image: &Image, place: [f64; 2]) -> Self {
        let at = |[x, y]: [f64; 2]| image.at([place[0] + x, place[1] + y]);
        let gradient = |[x, y]: [f64; 2]| {
            [(at([x + 1.0, y]) - at([x - 1.0, y])) / 2.0, (at([x, y + 1.0]) - at([x, y - 1.0])) / 2.0]
        };
        let gradients: Vec<[f64; 2]> = offsets().map(gradient).collect();
        let products =
            gradients.iter().fold([0.0; 3], |sum, [x, y]| [sum[0] + x * x, sum[1] + x * y, sum[2] + y * y]);
        Self { place, values: offsets().map(at).collect(), gradients, products }
    }

    /// The smaller eigenvalue of its products, a pixel.
    fn contrast(&self) -> f64 {
        least_eigenvalue(self.products) / self.values.len() as f64
    }

    /// What the window is less by than `image`, moved by `moved` pixels, pixel by pixel.
    fn differences(&self, image: &Image, moved: [f64; 2]) -> impl Iterator<Item = f64> {
        let [x, y] = [0, 1].map(|axis| self.place[axis] + moved[axis]);
        offsets().zip(&self.values).map(move |(off, value)| value - image.at([x + off[0], y + off[1]]))
    }

    /// How far (pixels) the window has moved in `image`, first guessed as `moved`, and the length of the last step.
    fn found(&self, image: &Image, mut moved: [f64; 2]) -> ([f64; 2], f64) {
        let [a, b, c] = self.products;
        let determinant = a * c - b * b;
        let mut length = f64::INFINITY;
        for _ in 0..MOST_STEPS {
            let [x, y] = self
                .differences(image, moved)
                .zip(&self.gradients)
                .fold([0.0; 2], |sum, (off, [x, y])| [sum[0] + off * x, sum[1] + off * y]);
            let step = [(c * x - b * y) / determinant, (a * y - b * x) / determinant];
            moved = [moved[0] + step[0], moved[1] + step[1]];
            length = libm::hypot(step[0], step[1]);
            if length < LEAST_STEP {
                break;
            }
        }
        (moved, length)
    }

    /// What the window and `image` differ by (rms), over the deviation of the window.
    fn difference(&self, image: &Image, moved: [f64; 2]) -> f64 {
        let count = self.values.len() as f64;
        let mean = self.values.iter().sum::<f64>() / count;
        let own: f64 = self.values.iter().map(|value| (value - mean) * (value - mean)).sum();
        let off: f64 = self.differences(image, moved).map(|off| off * off).sum();
        (off / own).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Hills and hollows in closed form, moved by `moved` pixels, with all lengths `scale` times as long around the middle.
    fn hills(moved: [f64; 2], scale: f64) -> Pyramid {
        let value = |index: usize| {
            let x = ((index % 160) as f64 - 80.0 - moved[0]) / scale;
            let y = ((index / 160) as f64 - 60.0 - moved[1]) / scale;
            let waves = libm::sin(x / 5.0) * libm::cos(y / 6.0) + 0.5 * libm::sin(0.09 * x + 0.13 * y + 0.4);
            (0.5 + 0.2 * waves) as f32
        };
        Pyramid::new(Image::new(160, (0..160 * 120).map(value).collect()), LEVELS)
    }

    #[test]
    fn a_picture_that_moves_by_a_known_way_is_followed_within_a_fiftieth_of_a_pixel() {
        let still = hills([0.0; 2], 1.0);
        for moved in [[0.3, 0.0], [-0.17, 0.61], [1.45, -0.8], [4.2, 3.7], [-6.5, 2.25]] {
            let next = hills(moved, 1.0);
            for place in [[60.0, 50.0], [83.0, 71.0], [100.5, 40.25]] {
                let found = follow(&still, &next, place).unwrap();
                for axis in 0..2 {
                    let off = found[axis] - place[axis] - moved[axis];
                    assert!(off.abs() < 0.02, "{moved:?} {place:?}: off by {off}");
                }
            }
        }
    }

    #[test]
    fn a_picture_that_stands_moves_nothing() {
        let still = hills([0.0; 2], 1.0);
        assert_eq!(follow(&still, &still, [70.25, 51.5]).unwrap(), [70.25, 51.5]);
    }

    #[test]
    fn a_picture_that_grows_is_followed_along_its_rays() {
        let (still, next) = (hills([0.0; 2], 1.0), hills([0.0; 2], 1.01));
        let found = follow(&still, &next, [110.0, 85.0]).unwrap();
        // Over the window the motion is not the same: its gradients weigh it.
        assert!((found[0] - 110.3).abs() < 0.05 && (found[1] - 85.25).abs() < 0.05, "{found:?}");
    }

    #[test]
    fn what_cannot_be_followed_is_lost() {
        let still = hills([0.0; 2], 1.0);
        assert_eq!(follow(&still, &still, [4.0, 60.0]), Err(Lost::Left));
        assert_eq!(follow(&still, &hills([-4.0, 0.0], 1.0), [11.0, 60.0]), Err(Lost::Left));
        let plain = Pyramid::new(Image::new(160, vec![0.5; 160 * 120]), LEVELS);
        assert_eq!(follow(&plain, &still, [60.0, 60.0]), Err(Lost::Broken));
        // Bright and dark change places.
        let image = still.whole();
        let turned = (0..160 * 120).map(|k| 1.0 - image.pixel([k % 160, k / 160])).collect();
        let turned = Pyramid::new(Image::new(160, turned), LEVELS);
        assert_eq!(follow(&still, &turned, [60.0, 60.0]), Err(Lost::Broken));
    }
}
