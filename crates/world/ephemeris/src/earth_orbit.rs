//! Where the Earth is, seen from the Sun.
//!
//! VSOP87, version D (P. Bretagnon and G. Francou, Astronomy and Astrophysics 202, 309, 1988), as J. Meeus abridges it
//! (Astronomical Algorithms, 2nd ed., appendix III), cut off below 1e-6 rad and 5e-6 au. Mean ecliptic and equinox of date.

use crate::ecliptic::Spherical;

/// Astronomical unit (m; IAU 2012, resolution B2).
pub const ASTRONOMICAL_UNIT: f64 = 149_597_870_700.0;

/// `amplitude cos(phase + rate t)`: amplitude in 1e-8 rad or 1e-8 au, rad, rad a thousand years.
type Term = [f64; 3];

/// Longitude, one series for each power of the time.
const LONGITUDE: [&[Term]; 5] = [
    &[
        [175_347_046.0, 0.0, 0.0],
        [3_341_656.0, 4.669_256_8, 6_283.075_85],
        [34_894.0, 4.626_1, 12_566.151_7],
        [3_497.0, 2.744_1, 5_753.384_9],
        [3_418.0, 2.828_9, 3.523_1],
        [3_136.0, 3.627_7, 77_713.771_5],
        [2_676.0, 4.418_1, 7_860.419_4],
        [2_343.0, 6.135_2, 3_930.209_7],
        [1_324.0, 0.742_5, 11_506.769_8],
        [1_273.0, 2.037_1, 529.691],
        [1_199.0, 1.109_6, 1_577.343_5],
        [990.0, 5.233, 5_884.927],
        [902.0, 2.045, 26.298],
        [857.0, 3.508, 398.149],
        [780.0, 1.179, 5_223.694],
        [753.0, 2.533, 5_507.553],
        [505.0, 4.583, 18_849.228],
        [492.0, 4.205, 775.523],
        [357.0, 2.92, 0.067],
        [317.0, 5.849, 11_790.629],
        [284.0, 1.899, 796.298],
        [271.0, 0.315, 10_977.079],
        [243.0, 0.345, 5_486.778],
        [206.0, 4.806, 2_544.314],
        [205.0, 1.869, 5_573.143],
        [202.0, 2.458, 6_069.777],
        [156.0, 0.833, 213.299],
        [132.0, 3.411, 2_942.463],
        [126.0, 1.083, 20.775],
        [115.0, 0.645, 0.98],
        [103.0, 0.636, 4_694.003],
        [102.0, 0.976, 15_720.839],
        [102.0, 4.267, 7.114],
    ],
    &[
        [628_331_966_747.0, 0.0, 0.0],
        [206_059.0, 2.678_235, 6_283.075_85],
        [4_303.0, 2.635_1, 12_566.151_7],
        [425.0, 1.59, 3.523],
        [119.0, 5.796, 26.298],
        [109.0, 2.966, 1_577.344],
    ],
    &[[52_919.0, 0.0, 0.0], [8_720.0, 1.072_1, 6_283.075_8], [309.0, 0.867, 12_566.152]],
    &[[289.0, 5.844, 6_283.076]],
    &[[-114.0, 0.0, 0.0]],
];

/// Series of the latitude, likewise.
const LATITUDE: [&[Term]; 1] = [&[[280.0, 3.199, 84_334.662], [102.0, 5.422, 5_507.553]]];

/// Series of the distance, likewise.
const DISTANCE: [&[Term]; 3] = [
    &[
        [100_013_989.0, 0.0, 0.0],
        [1_670_700.0, 3.098_463_5, 6_283.075_85],
        [13_956.0, 3.055_25, 12_566.151_7],
        [3_084.0, 5.198_5, 77_713.771_5],
        [1_628.0, 1.173_9, 5_753.384_9],
        [1_576.0, 2.846_9, 7_860.419_4],
        [925.0, 5.453, 11_506.77],
        [542.0, 4.564, 3_930.21],
    ],
    &[[103_019.0, 1.107_49, 6_283.075_85], [1_721.0, 1.064_4, 12_566.151_7], [-702.0, 0.0, 0.0]],
    &[[4_359.0, 5.784_6, 6_283.075_8]],
];

/// The Sun as the Earth sees it, geometric: the Earth's place turned round. `centuries` is terrestrial time after J2000.0.
pub fn sun_from_earth(centuries: f64) -> Spherical {
    let millennia = centuries / 10.0;
    Spherical {
        longitude: 1e-8 * sum(&LONGITUDE, millennia) + std::f64::consts::PI,
        latitude: -1e-8 * sum(&LATITUDE, millennia),
        distance: 1e-8 * sum(&DISTANCE, millennia) * ASTRONOMICAL_UNIT,
    }
}

/// Sum of the series, each times its power of the time.
fn sum(series: &[&[Term]], time: f64) -> f64 {
    let value = |terms: &&[Term]| -> f64 {
        terms.iter().map(|[amplitude, phase, rate]| amplitude * libm::cos(phase + rate * time)).sum()
    };
    series.iter().rev().fold(0.0, |sum, terms| sum * time + value(terms))
}

#[cfg(test)]
mod tests {
    use super::{ASTRONOMICAL_UNIT, sun_from_earth};
    use quantities::degrees;

    /// Meeus, example 25.b: 1992 October 13, 0h TD, by the complete VSOP87.
    #[test]
    fn the_sun_of_example_25_b() {
        let sun = sun_from_earth((2_448_908.5 - 2_451_545.0) / 36_525.0);
        let longitude = degrees(sun.longitude).rem_euclid(360.0);
        // 199.907372 is of FK5, 0.09 seconds of arc behind.
        assert!((longitude - 199.907_397).abs() < 3.0 / 3600.0, "{longitude}");
        assert!((3600.0 * degrees(sun.latitude) - 0.62).abs() < 0.5, "{}", 3600.0 * degrees(sun.latitude));
        assert!((sun.distance / ASTRONOMICAL_UNIT - 0.997_607_75).abs() < 2e-5);
    }
}
