//! FLIP: how different two pictures look when one takes the place of the other (Andersson, Nilsson, Akenine-Möller,
//! Oskarsson, Åström, Fairchild 2020), for grey pictures, whose colour differences are differences of lightness alone.

use picture::GreyPicture;

use crate::metrics::{CompareError, same_size};

/// Pixels per degree of our pictures: 700 lines over 30 degrees. The usual 67 of a monitor is more lenient here.
pub const PIXELS_PER_DEGREE: f64 = 23.0;

/// Exponent of lightness differences.
const COLOUR_EXPONENT: f64 = 0.7;
/// Differences up to this share of the largest are spread over [`NEAR_RANGE`] of the scale.
const NEAR: f64 = 0.4;
const NEAR_RANGE: f64 = 0.95;
/// Exponent of feature differences.
const FEATURE_EXPONENT: f64 = 0.5;
/// Width of the detector of edges and points (degrees).
const FEATURE_WIDTH: f64 = 0.082;
/// Spread of the achromatic filter, and that of the widest chromatic one, which sets the window (square degrees).
const ACHROMATIC: f64 = 0.0047;
const WIDEST: f64 = 0.04;
/// Distance of green from blue in Hunt-adjusted L*a*b*, the largest there is, before the exponent.
const GREEN_TO_BLUE: f64 = 203.301_654_610_877_42;

/// The difference that is seen, 0 (equal) to 1, over all pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Flip {
    /// Mean difference over all pixels.
    pub mean: f64,
    /// Half the pixels differ by so much or less.
    pub median: f64,
    /// 99 of 100 pixels differ by so much or less.
    pub percentile_99: f64,
    /// Largest difference of any pixel.
    pub maximum: f64,
}

/// FLIP of two pictures as they are displayed, seen at `pixels_per_degree`.
///
/// # Errors
/// [`CompareError::Size`].
pub fn flip(
    test: &GreyPicture,
    reference: &GreyPicture,
    pixels_per_degree: f64,
) -> Result<Flip, CompareError> {
    let mut map = flip_map(test, reference, pixels_per_degree)?;
    map.sort_by(f64::total_cmp);
    let at = |share: f64| map[((map.len() - 1) as f64 * share).round() as usize];
    Ok(Flip {
        mean: map.iter().sum::<f64>() / map.len() as f64,
        median: at(0.5),
        percentile_99: at(0.99),
        maximum: at(1.0),
    })
}

/// The difference of every pixel, line by line from the top.
///
/// # Errors
/// [`CompareError::Size`].
pub fn flip_map(
    test: &GreyPicture,
    reference: &GreyPicture,
    pixels_per_degree: f64,
) -> Result<Vec<f64>, CompareError> {
    same_size(test, reference)?;
    let [test, reference] = [test, reference].map(|picture| Seen::of(picture, pixels_per_degree));
    let largest = libm::pow(GREEN_TO_BLUE, COLOUR_EXPONENT);
    let pixel = |at: usize| {
        let colour = libm::pow((test.lightness[at] - reference.lightness[at]).abs(), COLOUR_EXPONENT);
        let edges = (test.edges[at] - reference.edges[at]).abs();
        let points = (test.points[at] - reference.points[at]).abs();
        let features = libm::pow(edges.max(points) / std::f64::consts::SQRT_2, FEATURE_EXPONENT);
        libm::pow(spread(colour, largest), 1.0 - features.min(1.0))
    };
    Ok((0..test.lightness.len()).map(pixel).collect())
}

/// Small differences take most of the scale.
fn spread(difference: f64, largest: f64) -> f64 {
    let near = NEAR * largest;
    if difference < near {
        NEAR_RANGE * difference / near
    } else {
        NEAR_RANGE + (difference - near) / (largest - near) * (1.0 - NEAR_RANGE)
    }
}

/// What an eye makes of a picture.
struct Seen {
    /// L* of what is left after the eye's own blur.
    lightness: Vec<f64>,
    edges: Vec<f64>,
    points: Vec<f64>,
}

impl Seen {
    fn of(picture: &GreyPicture, pixels_per_degree: f64) -> Self {
        let linear: Vec<f64> = picture.levels().map(linear).collect();
        let size = [picture.columns(), picture.lines()];
        let blur = blur(pixels_per_degree);
        let blurred = filtered(&filtered(&linear, size, &blur, false), size, &blur, true);
        let detector = Detector::new(pixels_per_degree);
        let magnitude = |kernel: &[f64]| {
            let along = filtered(&filtered(&linear, size, kernel, false), size, &detector.bell, true);
            let across = filtered(&filtered(&linear, size, &detector.bell, false), size, kernel, true);
            along.iter().zip(&across).map(|(x, y)| (x * x + y * y).sqrt()).collect()
        };
        Self {
            lightness: blurred.iter().map(|light| lightness(light.clamp(0.0, 1.0))).collect(),
            edges: magnitude(&detector.edge),
            points: magnitude(&detector.point),
        }
    }
}

/// Light of a displayed grey (sRGB).
fn linear(grey: f64) -> f64 {
    if grey <= 0.04045 { grey / 12.92 } else { libm::pow((grey + 0.055) / 1.055, 2.4) }
}

/// Returns the CIE lightness L*, 0 to 100, of a light from 0 to 1.
fn lightness(light: f64) -> f64 {
    const DELTA: f64 = 6.0 / 29.0;
    let root = if light > DELTA * DELTA * DELTA {
        libm::cbrt(light)
    } else {
        light / (3.0 * DELTA * DELTA) + 4.0 / 29.0
    };
    116.0 * root - 16.0
}

/// The eye's blur of lightness along one axis.
fn blur(pixels_per_degree: f64) -> Vec<f64> {
    use std::f64::consts::PI;
    let radius = (3.0 * (WIDEST / (2.0 * PI * PI)).sqrt() * pixels_per_degree).ceil() as i64;
    let degrees = |x: i64| x as f64 / pixels_per_degree;
    let bell = (-radius..=radius).map(|x| libm::exp(-PI * PI * degrees(x) * degrees(x) / ACHROMATIC));
    normalised(bell.collect())
}

/// Kernels that find edges and points, separated by axis.
struct Detector {
    bell: Vec<f64>,
    edge: Vec<f64>,
    point: Vec<f64>,
}

impl Detector {
    fn new(pixels_per_degree: f64) -> Self {
        let deviation = 0.5 * FEATURE_WIDTH * pixels_per_degree;
        let radius = (3.0 * deviation).ceil() as i64;
        let over = |law: fn(f64) -> f64| -> Vec<f64> {
            let at = |x: i64| {
                let share = x as f64 / deviation;
                law(share) * libm::exp(-0.5 * share * share)
            };
            (-radius..=radius).map(at).collect()
        };
        Self {
            bell: normalised(over(|_| 1.0)),
            edge: balanced(over(|x| -x)),
            point: balanced(over(|x| x * x - 1.0)),
        }
    }
}

fn normalised(kernel: Vec<f64>) -> Vec<f64> {
    let sum: f64 = kernel.iter().sum();
    kernel.iter().map(|weight| weight / sum).collect()
}

/// Positive weights with sum 1, negative ones with sum -1.
fn balanced(kernel: Vec<f64>) -> Vec<f64> {
    let sum = |sign: f64| kernel.iter().map(|weight| (sign * weight).max(0.0)).sum::<f64>();
    let (positive, negative) = (sum(1.0), sum(-1.0));
    kernel.iter().map(|weight| weight / if *weight > 0.0 { positive } else { negative }).collect()
}

/// `plane` filtered along one axis; beyond its edges the pixels of the edge go on.
fn filtered(plane: &[f64], [columns, lines]: [usize; 2], kernel: &[f64], upright: bool) -> Vec<f64> {
    let (count, stride) = if upright { (lines, columns) } else { (columns, 1) };
    let radius = (kernel.len() / 2) as i64;
    let pixel = |at: usize| {
        let place = (at / stride % count) as i64;
        let first = at as i64 - place * stride as i64;
        let value = |offset: usize| {
            let near = (place + offset as i64 - radius).clamp(0, count as i64 - 1);
            plane[(first + near * stride as i64) as usize]
        };
        kernel.iter().enumerate().map(|(offset, weight)| weight * value(offset)).sum()
    };
    (0..plane.len()).map(pixel).collect()
}

#[cfg(test)]
mod tests {
    use picture::{Depth, GreyPicture};

    use super::{PIXELS_PER_DEGREE, flip, flip_map};

    /// A pattern with fine grain, blocks, a bright bar, a black line and a darker stripe.
    fn pair() -> [GreyPicture; 2] {
        let (columns, lines) = (40, 28);
        let pixel = |column: usize, line: usize| {
            let grain = (7 * column + 13 * line) % 64;
            let block = if (column / 9 + line / 7) % 2 == 1 { 120 } else { 0 };
            let reference = 40 + block + grain / 4;
            let bar = if (10..14).contains(&column) { (reference + 60).min(255) } else { reference };
            let lined = if line == 20 { 0 } else { bar };
            [if column > 30 { (reference as f64 * 0.9) as usize } else { lined }, reference]
        };
        [0, 1].map(|which| {
            let at = |index: usize| pixel(index % columns, index / columns)[which] as u16;
            let codes = (0..columns * lines).map(at).collect();
            GreyPicture::new(columns, lines, Depth::Eight, codes).unwrap()
        })
    }

    /// Figures of the authors' own program (version 1.7 of its package), which computes in f32.
    #[test]
    fn agrees_with_the_program_of_its_authors() {
        let [test, reference] = pair();
        let found = flip(&test, &reference, PIXELS_PER_DEGREE).unwrap();
        let close = |found: f64, told: f64| assert!((found - told).abs() < 2e-4, "{found} {told}");
        close(found.mean, 0.141_766_04);
        close(found.maximum, 0.969_378_4);
        close(found.percentile_99, 0.955_922_3);
        let map = flip_map(&test, &reference, PIXELS_PER_DEGREE).unwrap();
        let told = [((11, 5), 0.628_381_67), ((3, 20), 0.431_613_95), ((35, 9), 0.189_131_69)];
        told.into_iter().for_each(|((column, line), told)| close(map[line * 40 + column], told));
        let near = flip(&test, &reference, 67.0).unwrap();
        close(near.mean, 0.158_063_01);
    }

    #[test]
    fn equal_pictures_do_not_differ_and_black_is_far_from_white() {
        let flat = |code| GreyPicture::new(20, 20, Depth::Eight, vec![code; 400]).unwrap();
        assert_eq!(flip(&flat(90), &flat(90), PIXELS_PER_DEGREE).unwrap().maximum, 0.0);
        let far = flip(&flat(0), &flat(255), PIXELS_PER_DEGREE).unwrap();
        assert!(far.mean > 0.9 && far.maximum <= 1.0, "{far:?}");
    }
}
