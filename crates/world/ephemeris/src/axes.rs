//! The axes of the Moon: where its pole and its prime meridian point.
//!
//! B. Archinal and others, Report of the IAU Working Group on Cartographic Coordinates and Rotational Elements: 2015, Celestial
//! Mechanics and Dynamical Astronomy 130, 22, 2018, table 2. Mean-Earth, polar-axis system, which maps of the Moon use. The
//! report gives an error of about 150 m on the ground, 0.005 degrees.

use glam::DMat3;
use quantities::{radians, sin_cos};

use crate::ecliptic::{about_x, about_z};

/// An angle E of the report: its value at J2000.0 (deg), its rate (deg a day), and what it does to right ascension (sine),
/// declination (cosine) and prime meridian (sine) (deg).
type Libration = [f64; 5];

const LIBRATIONS: [Libration; 13] = [
    [125.045, -0.052_992_1, -3.8787, 1.5419, 3.5610],
    [250.089, -0.105_984_2, -0.1204, 0.0239, 0.1208],
    [260.008, 13.012_009_4, 0.0700, -0.0278, -0.0642],
    [176.625, 13.340_715_4, -0.0172, 0.0068, 0.0158],
    [357.529, 0.985_600_3, 0.0, 0.0, 0.0252],
    [311.589, 26.405_708_4, 0.0072, -0.0029, -0.0066],
    [134.963, 13.064_993_0, 0.0, 0.0009, -0.0047],
    [276.617, 0.328_714_6, 0.0, 0.0, -0.0046],
    [34.226, 1.748_487_7, 0.0, 0.0, 0.0028],
    [15.134, -0.158_976_3, -0.0052, 0.0008, 0.0052],
    [119.743, 0.003_609_6, 0.0, 0.0, 0.0040],
    [239.961, 0.164_357_3, 0.0, 0.0, 0.0019],
    [25.053, 12.958_908_8, 0.0043, -0.0009, -0.0044],
];

/// Matrix from the ICRF to the axes of the Moon: x to the prime meridian on the equator, z to the north pole. `centuries` is
/// terrestrial time after J2000.0; barycentric time, which the report means, is the same within 2 ms.
pub fn from_icrf(centuries: f64) -> DMat3 {
    let days = 36_525.0 * centuries;
    let mut right_ascension = 269.9949 + 0.0031 * centuries;
    let mut declination = 66.5392 + 0.0130 * centuries;
    let mut meridian = 38.3213 + days * (13.176_358_15 - 1.4e-12 * days);
    for [first, rate, to_right_ascension, to_declination, to_meridian] in LIBRATIONS {
        let (sin, cos) = sin_cos(radians(first + rate * days));
        right_ascension += to_right_ascension * sin;
        declination += to_declination * cos;
        meridian += to_meridian * sin;
    }
    let [right_ascension, declination, meridian] = [right_ascension, declination, meridian].map(radians);
    let quarter = std::f64::consts::FRAC_PI_2;
    about_z(-meridian) * about_x(declination - quarter) * about_z(-right_ascension - quarter)
}
