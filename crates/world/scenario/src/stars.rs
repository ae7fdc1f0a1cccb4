//! Stars of a sky: of a catalogue, or strewn by a seed.

use std::f64::consts::TAU;
use std::path::PathBuf;
use std::sync::Arc;

use glam::{DMat3, DVec3};
use quantities::{sin_cos, unit_interval};

use crate::DatedSky;
use crate::turns::{about_x, about_z};

/// The stars that a scenario asks for.
#[derive(Debug, Clone, PartialEq)]
pub struct StarWish {
    /// Where they come from.
    pub source: StarSource,
    /// Whether a beam of its own draws each of them.
    pub calligraphic: bool,
    /// Angles (rad) that turn the catalogue's axes into those of the ground, where no date does: about the third axis by the
    /// last, about the first by the second, about the third by the first.
    pub turn: [f64; 3],
}

/// Where stars come from.
#[derive(Debug, Clone, PartialEq)]
pub enum StarSource {
    /// A catalogue in a file.
    Catalogue {
        /// Path of the file that lists the stars.
        file: PathBuf,
        /// Stars of the file, in its order.
        stars: Arc<[Star]>,
    },
    /// A law, and a seed of all draws.
    Seeded(SeededSky),
}

/// A star as a catalogue has it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Star {
    /// Unit vector to it in the catalogue's axes: x to right ascension 0 on the equator, z to the north pole of the sky.
    pub direction: DVec3,
    /// Apparent visual magnitude, -50 to 50.
    pub magnitude: f64,
    /// Its colour (linear red, green, blue, 0..=1).
    pub colour: [f64; 3],
}

/// Stars that are strewn evenly over the sphere. The number of stars brighter than a magnitude m is in proportion to
/// `10^(0.5 m)`, cut off at both ends.
///
/// Chosen: stars in even space would have `10^(0.6 m)`; the sky has some 50 stars to magnitude 2 and 5000 to magnitude 6
/// (unsourced), which is `10^(0.5 m)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SeededSky {
    /// Seed of all draws.
    pub seed: u64,
    /// How many stars there are.
    pub count: u32,
    /// Magnitude of the brightest that there can be.
    pub brightest: f64,
    /// Magnitude of the faintest that there can be, above `brightest`.
    pub faintest: f64,
}

/// What a draw of a star is for.
#[derive(Clone, Copy)]
enum Purpose {
    Height,
    Longitude,
    Magnitude,
}

impl Star {
    /// A star at a right ascension and declination (rad); white without a colour index (B - V).
    pub fn at(right_ascension: f64, declination: f64, magnitude: f64, colour_index: Option<f64>) -> Self {
        let (sin, cos) = sin_cos(declination);
        let direction = on_circle(right_ascension, cos, sin);
        Self { direction, magnitude, colour: colour_index.map_or([1.0; 3], colour) }
    }
}

impl SeededSky {
    /// All its stars, white.
    pub fn stars(&self) -> impl Iterator<Item = Star> {
        (0..u64::from(self.count)).map(|number| self.star(number))
    }

    fn star(&self, number: u64) -> Star {
        let draw = |purpose: Purpose| unit_interval(self.seed, &[number, purpose as u64]);
        let height = 2.0 * draw(Purpose::Height) - 1.0;
        let across = (1.0 - height * height).max(0.0).sqrt();
        let direction = on_circle(TAU * draw(Purpose::Longitude), across, height);
        Star { direction, magnitude: self.magnitude(draw(Purpose::Magnitude)), colour: [1.0; 3] }
    }

    /// Magnitude than which a `share` (0 to 1) of all stars is brighter.
    fn magnitude(&self, share: f64) -> f64 {
        let least = libm::pow(10.0, 0.5 * (self.brightest - self.faintest));
        let magnitude = self.faintest + 2.0 * libm::log10(least + share * (1.0 - least));
        magnitude.clamp(self.brightest, self.faintest)
    }
}

impl StarWish {
    /// All stars, in the axes of the catalogue.
    pub(crate) fn stars(&self) -> Vec<Star> {
        match &self.source {
            StarSource::Catalogue { stars, .. } => stars.to_vec(),
            StarSource::Seeded(sky) => sky.stars().collect(),
        }
    }

    /// From the axes of the catalogue to north, east, up: by the date of `sky`, or by the angles of the scenario.
    pub(crate) fn to_ground(&self, sky: Option<&DatedSky>) -> DMat3 {
        // North, east and up are left-handed; a turn leads to north, west, up.
        let flip = DMat3::from_diagonal(DVec3::new(1.0, -1.0, 1.0));
        let [first, second, third] = self.turn;
        sky.map_or_else(|| flip * about_z(first) * about_x(second) * about_z(third), DatedSky::icrf_to_ground)
    }
}

fn on_circle(longitude: f64, radius: f64, height: f64) -> DVec3 {
    let (sin, cos) = sin_cos(longitude);
    DVec3::new(radius * cos, radius * sin, height)
}

/// Linear red, green and blue (0..=1, the largest 1) of a colour index B - V, -0.5 or more.
///
/// Reported: temperature by F. Ballesteros, Europhysics Letters 97, 34008, 2012; a black body's chromaticity by B. Kim and
/// others, Journal of the Korean Physical Society 41, 865, 2002, from 1667 to 25 000 K. Chosen: the temperature ends there,
/// and so do colours that no display has.
fn colour(colour_index: f64) -> [f64; 3] {
    let temperature = 4600.0 * (1.0 / (0.92 * colour_index + 1.7) + 1.0 / (0.92 * colour_index + 0.62));
    let [x, y] = chromaticity(temperature.clamp(1667.0, 25_000.0));
    let (big_x, big_z) = (x / y, (1.0 - x - y) / y);
    // From CIE XYZ to linear sRGB (IEC 61966-2-1).
    let light = [
        3.2406 * big_x - 1.5372 - 0.4986 * big_z,
        -0.9689 * big_x + 1.8758 + 0.0415 * big_z,
        0.0557 * big_x - 0.2040 + 1.0570 * big_z,
    ];
    let most = light.into_iter().fold(0.0, f64::max);
    light.map(|part| part.max(0.0) / most)
}

/// CIE x and y of a black body of 1667 to 25 000 K.
fn chromaticity(temperature: f64) -> [f64; 2] {
    let cubic = |[a, b, c, d]: [f64; 4], t: f64| ((a * t + b) * t + c) * t + d;
    let to_x = if temperature <= 4000.0 {
        [-0.266_123_9e9, -0.234_358_9e6, 0.877_695_6e3, 0.179_910]
    } else {
        [-3.025_846_9e9, 2.107_037_9e6, 0.222_634_7e3, 0.240_390]
    };
    let x = cubic(to_x, 1.0 / temperature);
    let to_y = if temperature <= 2222.0 {
        [-1.106_381_4, -1.348_110_20, 2.185_558_32, -0.202_196_83]
    } else if temperature <= 4000.0 {
        [-0.954_947_6, -1.374_185_93, 2.091_370_15, -0.167_488_67]
    } else {
        [3.081_758_0, -5.873_386_70, 3.751_129_97, -0.370_014_83]
    };
    [x, cubic(to_y, x)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use quantities::radians;

    #[test]
    fn five_thousand_stars_are_even_over_the_sphere_and_follow_the_law() {
        let sky = SeededSky { seed: 3, count: 5000, brightest: -1.5, faintest: 6.0 };
        let stars: Vec<Star> = sky.stars().collect();
        assert_eq!(stars.len(), 5000);
        assert!(stars.iter().all(|star| (star.direction.length() - 1.0).abs() < 1e-12));
        // The mean of 5000 unit vectors has 3 parts of variance 1/15000 each: 4 deviations.
        let mean = stars.iter().map(|star| star.direction).sum::<DVec3>() / 5000.0;
        assert!(mean.abs().max_element() < 4.0 / 15_000_f64.sqrt(), "{mean}");
        // Each of 8 octants has 625 with a deviation of 23.4.
        for octant in 0..8 {
            let sides = |star: &&Star| {
                star.direction
                    .to_array()
                    .iter()
                    .enumerate()
                    .all(|(axis, part)| (*part > 0.0) == (octant >> axis & 1 == 1))
            };
            let found = stars.iter().filter(sides).count() as f64;
            assert!((found - 625.0).abs() < 4.0 * 23.4, "octant {octant}: {found}");
        }
        for magnitude in [1.0, 2.0, 3.0, 4.0, 5.0, 5.5] {
            let ten = |power: f64| libm::pow(10.0, 0.5 * power);
            let share = (ten(magnitude) - ten(-1.5)) / (ten(6.0) - ten(-1.5));
            let (mean, found) =
                (5000.0 * share, stars.iter().filter(|star| star.magnitude < magnitude).count());
            let deviation = (mean * (1.0 - share)).sqrt();
            assert!((found as f64 - mean).abs() < 4.0 * deviation, "{magnitude}: {found} for {mean}");
        }
        let ends = |star: &Star| (-1.5..=6.0).contains(&star.magnitude);
        assert!(stars.iter().all(ends) && sky.magnitude(0.0) == -1.5 && sky.magnitude(1.0) == 6.0);
        let other = SeededSky { seed: 4, ..sky };
        assert_ne!(other.stars().next(), sky.stars().next());
    }

    #[test]
    fn colours_go_from_blue_to_red_through_white() {
        let [x, y] = chromaticity(6504.0);
        assert!((x - 0.3135).abs() < 1e-3 && (y - 0.3237).abs() < 1e-3, "{x} {y}");
        let [blue, white, red] = [-0.3, 0.45, 1.8].map(colour);
        assert!(blue[2] == 1.0 && blue[0] < 0.7 && red[0] == 1.0 && red[2] < 0.5, "{blue:?} {red:?}");
        assert!(white.into_iter().all(|part| part > 0.85), "{white:?}");
        for index in -5..=60 {
            let colour = colour(0.1 * f64::from(index));
            assert!(
                colour.into_iter().all(|part| (0.0..=1.0).contains(&part)) && colour.contains(&1.0),
                "{colour:?}"
            );
        }
    }

    #[test]
    fn a_sky_without_a_date_is_turned_and_never_mirrored() {
        let turned = |turn: [f64; 3]| {
            let source = StarSource::Seeded(SeededSky { seed: 1, count: 1, brightest: 0.0, faintest: 1.0 });
            StarWish { source, calligraphic: false, turn: turn.map(radians) }.to_ground(None)
        };
        // Right ascension grows to the west under the pole, as it does over the Earth's north pole.
        let up = turned([0.0; 3]);
        assert_eq!((up * DVec3::X, up * DVec3::Y, up * DVec3::Z), (DVec3::X, -DVec3::Y, DVec3::Z));
        // The pole of the sky on the northern horizon: the first point of Aries in the west.
        let level = turned([90.0, 90.0, 0.0]);
        assert!((level * DVec3::Z - DVec3::X).length() < 1e-15, "{}", level * DVec3::Z);
        assert!((level * DVec3::X + DVec3::Y).length() < 1e-15 && (level.determinant() + 1.0).abs() < 1e-15);
    }
}
