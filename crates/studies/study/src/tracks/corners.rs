//! Corners of a picture, after Shi and Tomasi (Good features to track, 1994): where light changes in both directions.

use super::image::Image;

/// Half of a window (pixels) over which gradients are added up.
const HALF_WINDOW: isize = 3;
/// Least strength of a corner, over that of the strongest. Chosen.
const QUALITY: f64 = 0.01;
/// Least distance (pixels) of two corners. Chosen.
const APART: f64 = 12.0;

/// The strongest corners of a picture at pixels that are `usable`, at most `most`, the strongest first.
pub fn corners(image: &Image, most: usize, usable: &dyn Fn([usize; 2]) -> bool) -> Vec<[usize; 2]> {
    let [columns, lines] = image.size();
    let strength = strengths(image);
    let of = |[x, y]: [usize; 2]| strength[y * columns + x];
    let is_peak = |at: &[usize; 2]| {
        let around = (0..9).filter(|k| *k != 4).map(|k| [at[0] + k % 3 - 1, at[1] + k / 3 - 1]);
        of(*at) > 0.0 && around.into_iter().all(|next| of(next) <= of(*at))
    };
    let inside = (1..lines.max(2) - 1).flat_map(|y| (1..columns.max(2) - 1).map(move |x| [x, y]));
    let mut peaks: Vec<[usize; 2]> = inside.filter(|at| usable(*at)).filter(is_peak).collect();
    peaks.sort_by(|a, b| of(*b).total_cmp(&of(*a)).then(a.cmp(b)));
    let least = QUALITY * peaks.first().map_or(0.0, |first| of(*first));
    let mut chosen: Vec<[usize; 2]> = Vec::new();
    for peak in peaks.into_iter().take_while(|peak| of(*peak) >= least) {
        if chosen.len() == most {
            break;
        }
        let is_apart = |other: &[usize; 2]| {
            let off = [0, 1].map(|axis| peak[axis] as f64 - other[axis] as f64);
            libm::hypot(off[0], off[1]) >= APART
        };
        if chosen.iter().all(is_apart) {
            chosen.push(peak);
        }
    }
    chosen
}

/// The smaller eigenvalue of the sum of the squared gradients around each pixel, line by line.
fn strengths(image: &Image) -> Vec<f64> {
    let [columns, lines] = image.size();
    let products: Vec<[f64; 3]> = (0..columns * lines)
        .map(|index| {
            let [x, y] = gradient(image, [(index % columns) as isize, (index / columns) as isize]);
            [x * x, x * y, y * y]
        })
        .collect();
    let along = windowed(&products, |index, off| {
        let x = (index % columns) as isize + off;
        (0..columns as isize).contains(&x).then(|| index / columns * columns + x as usize)
    });
    let both = windowed(&along, |index, off| {
        let y = (index / columns) as isize + off;
        (0..lines as isize).contains(&y).then(|| y as usize * columns + index % columns)
    });
    both.into_iter().map(least_eigenvalue).collect()
}

/// Sums over a window in one direction.
fn windowed(values: &[[f64; 3]], at: impl Fn(usize, isize) -> Option<usize>) -> Vec<[f64; 3]> {
    let sum = |index: usize| {
        let inside = (-HALF_WINDOW..=HALF_WINDOW).filter_map(|off| at(index, off));
        inside.fold([0.0; 3], |sum, other| std::array::from_fn(|k| sum[k] + values[other][k]))
    };
    (0..values.len()).map(sum).collect()
}

/// How a picture changes to the right and downwards at a pixel (1 a pixel).
fn gradient(image: &Image, [x, y]: [isize; 2]) -> [f64; 2] {
    let half = |a: f32, b: f32| (f64::from(b) - f64::from(a)) / 2.0;
    [
        half(image.pixel([x - 1, y]), image.pixel([x + 1, y])),
        half(image.pixel([x, y - 1]), image.pixel([x, y + 1])),
    ]
}

/// The smaller eigenvalue of the symmetric matrix `[a, b; b, c]`.
pub fn least_eigenvalue([a, b, c]: [f64; 3]) -> f64 {
    (a + c - libm::hypot(a - c, 2.0 * b)) / 2.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_of_a_bright_square_are_found_and_its_sides_are_not() {
        let is_bright = |index: &usize| (20..40).contains(&(index % 64)) && (24..44).contains(&(index / 64));
        let image =
            Image::new(64, (0..64 * 64).map(|index| f32::from(u8::from(is_bright(&index)))).collect());
        let found = corners(&image, 10, &|_| true);
        assert_eq!(found.len(), 4, "{found:?}");
        for corner in [[20, 24], [39, 24], [20, 43], [39, 43]] {
            let near = |at: &[usize; 2]| (0..2).all(|axis| at[axis].abs_diff(corner[axis]) <= 3);
            assert!(found.iter().any(near), "{corner:?} of {found:?}");
        }
        assert!(corners(&image, 2, &|_| true).len() == 2 && corners(&image, 10, &|_| false).is_empty());
    }

    #[test]
    fn the_smaller_eigenvalue_is_that_of_the_matrix() {
        assert!((least_eigenvalue([3.0, 0.0, 5.0]) - 3.0).abs() < 1e-12);
        assert!((least_eigenvalue([2.0, 1.0, 2.0]) - 1.0).abs() < 1e-12);
        assert!(least_eigenvalue([1.0, 1.0, 1.0]).abs() < 1e-12);
    }
}
