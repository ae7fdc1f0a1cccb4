//! Where the Moon is, seen from the Earth.
//!
//! ELP 2000-82 (M. Chapront-Touze and J. Chapront, Astronomy and Astrophysics 124, 50, 1983) as J. Meeus abridges it
//! (Astronomical Algorithms, 2nd ed., chapter 47: 10 seconds of arc in longitude, 4 in latitude). Mean ecliptic and equinox of
//! date; the time that light takes from the Moon to the Earth is in the mean longitude.

use quantities::radians;

use crate::ecliptic::Spherical;

/// Multiples of D, M, M' and F; coefficient of the sine in longitude (1e-6 deg) and of the cosine in distance (m).
type Term = ([i8; 4], [f64; 2]);

/// Terms of Meeus, table 47.A.
const LONGITUDE_AND_DISTANCE: [Term; 60] = [
    ([0, 0, 1, 0], [6_288_774.0, -20_905_355.0]),
    ([2, 0, -1, 0], [1_274_027.0, -3_699_111.0]),
    ([2, 0, 0, 0], [658_314.0, -2_955_968.0]),
    ([0, 0, 2, 0], [213_618.0, -569_925.0]),
    ([0, 1, 0, 0], [-185_116.0, 48_888.0]),
    ([0, 0, 0, 2], [-114_332.0, -3_149.0]),
    ([2, 0, -2, 0], [58_793.0, 246_158.0]),
    ([2, -1, -1, 0], [57_066.0, -152_138.0]),
    ([2, 0, 1, 0], [53_322.0, -170_733.0]),
    ([2, -1, 0, 0], [45_758.0, -204_586.0]),
    ([0, 1, -1, 0], [-40_923.0, -129_620.0]),
    ([1, 0, 0, 0], [-34_720.0, 108_743.0]),
    ([0, 1, 1, 0], [-30_383.0, 104_755.0]),
    ([2, 0, 0, -2], [15_327.0, 10_321.0]),
    ([0, 0, 1, 2], [-12_528.0, 0.0]),
    ([0, 0, 1, -2], [10_980.0, 79_661.0]),
    ([4, 0, -1, 0], [10_675.0, -34_782.0]),
    ([0, 0, 3, 0], [10_034.0, -23_210.0]),
    ([4, 0, -2, 0], [8_548.0, -21_636.0]),
    ([2, 1, -1, 0], [-7_888.0, 24_208.0]),
    ([2, 1, 0, 0], [-6_766.0, 30_824.0]),
    ([1, 0, -1, 0], [-5_163.0, -8_379.0]),
    ([1, 1, 0, 0], [4_987.0, -16_675.0]),
    ([2, -1, 1, 0], [4_036.0, -12_831.0]),
    ([2, 0, 2, 0], [3_994.0, -10_445.0]),
    ([4, 0, 0, 0], [3_861.0, -11_650.0]),
    ([2, 0, -3, 0], [3_665.0, 14_403.0]),
    ([0, 1, -2, 0], [-2_689.0, -7_003.0]),
    ([2, 0, -1, 2], [-2_602.0, 0.0]),
    ([2, -1, -2, 0], [2_390.0, 10_056.0]),
    ([1, 0, 1, 0], [-2_348.0, 6_322.0]),
    ([2, -2, 0, 0], [2_236.0, -9_884.0]),
    ([0, 1, 2, 0], [-2_120.0, 5_751.0]),
    ([0, 2, 0, 0], [-2_069.0, 0.0]),
    ([2, -2, -1, 0], [2_048.0, -4_950.0]),
    ([2, 0, 1, -2], [-1_773.0, 4_130.0]),
    ([2, 0, 0, 2], [-1_595.0, 0.0]),
    ([4, -1, -1, 0], [1_215.0, -3_958.0]),
    ([0, 0, 2, 2], [-1_110.0, 0.0]),
    ([3, 0, -1, 0], [-892.0, 3_258.0]),
    ([2, 1, 1, 0], [-810.0, 2_616.0]),
    ([4, -1, -2, 0], [759.0, -1_897.0]),
    ([0, 2, -1, 0], [-713.0, -2_117.0]),
    ([2, 2, -1, 0], [-700.0, 2_354.0]),
    ([2, 1, -2, 0], [691.0, 0.0]),
    ([2, -1, 0, -2], [596.0, 0.0]),
    ([4, 0, 1, 0], [549.0, -1_423.0]),
    ([0, 0, 4, 0], [537.0, -1_117.0]),
    ([4, -1, 0, 0], [520.0, -1_571.0]),
    ([1, 0, -2, 0], [-487.0, -1_739.0]),
    ([2, 1, 0, -2], [-399.0, 0.0]),
    ([0, 0, 2, -2], [-381.0, -4_421.0]),
    ([1, 1, 1, 0], [351.0, 0.0]),
    ([3, 0, -2, 0], [-340.0, 0.0]),
    ([4, 0, -3, 0], [330.0, 0.0]),
    ([2, -1, 2, 0], [327.0, 0.0]),
    ([0, 2, 1, 0], [-323.0, 1_165.0]),
    ([1, 1, -1, 0], [299.0, 0.0]),
    ([2, 0, 3, 0], [294.0, 0.0]),
    ([2, 0, -1, -2], [0.0, 8_752.0]),
];

/// Table 47.B: multiples of D, M, M' and F; coefficient of the sine in latitude (1e-6 deg).
const LATITUDE: [([i8; 4], f64); 60] = [
    ([0, 0, 0, 1], 5_128_122.0),
    ([0, 0, 1, 1], 280_602.0),
    ([0, 0, 1, -1], 277_693.0),
    ([2, 0, 0, -1], 173_237.0),
    ([2, 0, -1, 1], 55_413.0),
    ([2, 0, -1, -1], 46_271.0),
    ([2, 0, 0, 1], 32_573.0),
    ([0, 0, 2, 1], 17_198.0),
    ([2, 0, 1, -1], 9_266.0),
    ([0, 0, 2, -1], 8_822.0),
    ([2, -1, 0, -1], 8_216.0),
    ([2, 0, -2, -1], 4_324.0),
    ([2, 0, 1, 1], 4_200.0),
    ([2, 1, 0, -1], -3_359.0),
    ([2, -1, -1, 1], 2_463.0),
    ([2, -1, 0, 1], 2_211.0),
    ([2, -1, -1, -1], 2_065.0),
    ([0, 1, -1, -1], -1_870.0),
    ([4, 0, -1, -1], 1_828.0),
    ([0, 1, 0, 1], -1_794.0),
    ([0, 0, 0, 3], -1_749.0),
    ([0, 1, -1, 1], -1_565.0),
    ([1, 0, 0, 1], -1_491.0),
    ([0, 1, 1, 1], -1_475.0),
    ([0, 1, 1, -1], -1_410.0),
    ([0, 1, 0, -1], -1_344.0),
    ([1, 0, 0, -1], -1_335.0),
    ([0, 0, 3, 1], 1_107.0),
    ([4, 0, 0, -1], 1_021.0),
    ([4, 0, -1, 1], 833.0),
    ([0, 0, 1, -3], 777.0),
    ([4, 0, -2, 1], 671.0),
    ([2, 0, 0, -3], 607.0),
    ([2, 0, 2, -1], 596.0),
    ([2, -1, 1, -1], 491.0),
    ([2, 0, -2, 1], -451.0),
    ([0, 0, 3, -1], 439.0),
    ([2, 0, 2, 1], 422.0),
    ([2, 0, -3, -1], 421.0),
    ([2, 1, -1, 1], -366.0),
    ([2, 1, 0, 1], -351.0),
    ([4, 0, 0, 1], 331.0),
    ([2, -1, 1, 1], 315.0),
    ([2, -2, 0, -1], 302.0),
    ([0, 0, 1, 3], -283.0),
    ([2, 1, 1, -1], -229.0),
    ([1, 1, 0, -1], 223.0),
    ([1, 1, 0, 1], 223.0),
    ([0, 1, -2, -1], -220.0),
    ([2, 1, -1, -1], -220.0),
    ([1, 0, 1, 1], -185.0),
    ([2, -1, -2, -1], 181.0),
    ([0, 1, 2, 1], -177.0),
    ([4, 0, -2, -1], 176.0),
    ([4, -1, -1, -1], 166.0),
    ([1, 0, 1, -1], -164.0),
    ([4, 0, 1, -1], 132.0),
    ([1, 0, -1, -1], -119.0),
    ([4, -1, 0, -1], 115.0),
    ([2, -2, 0, 1], 107.0),
];

/// Mean distance of the Moon (m).
const MEAN_DISTANCE: f64 = 385_000_560.0;

/// The Moon as the Earth sees it, without nutation. `centuries` is terrestrial time after J2000.0.
pub fn moon_from_earth(centuries: f64) -> Spherical {
    let t = centuries;
    let angle = |polynomial: [f64; 3]| radians(polynomial[0] + t * (polynomial[1] + t * polynomial[2]));
    // Terms in the third and fourth power of the time stay below 1e-6 degrees within a century.
    let mean_longitude = angle([218.316_447_7, 481_267.881_234_21, -0.001_578_6]);
    let arguments = [
        angle([297.850_192_1, 445_267.111_403_4, -0.001_881_9]),
        angle([357.529_109_2, 35_999.050_290_9, -0.000_153_6]),
        angle([134.963_396_4, 477_198.867_505_5, 0.008_741_4]),
        angle([93.272_095, 483_202.017_523_3, -0.003_653_9]),
    ];
    let [_, _, anomaly, latitude_argument] = arguments;
    let venus = angle([119.75, 131.849, 0.0]);
    let jupiter = angle([53.09, 479_264.29, 0.0]);
    let third = angle([313.45, 481_266.484, 0.0]);
    let eccentricity = 1.0 - t * (0.002_516 + 0.000_007_4 * t);
    let at = |multiples: &[i8; 4]| -> (f64, f64) {
        let argument = multiples.iter().zip(arguments).map(|(times, angle)| f64::from(*times) * angle).sum();
        let weight = match multiples[1].abs() {
            0 => 1.0,
            1 => eccentricity,
            _ => eccentricity * eccentricity,
        };
        (argument, weight)
    };
    let (mut longitude, mut distance, mut latitude) = (0.0, 0.0, 0.0);
    for (multiples, [of_sine, of_cosine]) in &LONGITUDE_AND_DISTANCE {
        let (argument, weight) = at(multiples);
        longitude += weight * of_sine * libm::sin(argument);
        distance += weight * of_cosine * libm::cos(argument);
    }
    for (multiples, of_sine) in &LATITUDE {
        let (argument, weight) = at(multiples);
        latitude += weight * of_sine * libm::sin(argument);
    }
    longitude += 3958.0 * libm::sin(venus)
        + 1962.0 * libm::sin(mean_longitude - latitude_argument)
        + 318.0 * libm::sin(jupiter);
    latitude += -2235.0 * libm::sin(mean_longitude)
        + 382.0 * libm::sin(third)
        + 175.0 * (libm::sin(venus - latitude_argument) + libm::sin(venus + latitude_argument))
        + 127.0 * libm::sin(mean_longitude - anomaly)
        - 115.0 * libm::sin(mean_longitude + anomaly);
    Spherical {
        longitude: mean_longitude + radians(1e-6 * longitude),
        latitude: radians(1e-6 * latitude),
        distance: MEAN_DISTANCE + distance,
    }
}

#[cfg(test)]
mod tests {
    use super::moon_from_earth;
    use quantities::degrees;

    /// Meeus, example 47.a: 1992 April 12, 0h TD.
    #[test]
    fn the_moon_of_example_47_a() {
        let moon = moon_from_earth((2_448_724.5 - 2_451_545.0) / 36_525.0);
        assert!((degrees(moon.longitude).rem_euclid(360.0) - 133.162_655).abs() < 2e-6);
        assert!((degrees(moon.latitude) + 3.229_126).abs() < 1e-6);
        assert!((moon.distance - 368_409.7e3).abs() < 50.0, "{}", moon.distance);
    }
}
