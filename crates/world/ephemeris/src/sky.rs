//! Sun and Earth as they stand over a place.

use glam::{DMat3, DVec3};
use quantities::{sin_cos, wrap_heading};

use crate::Instant;
use crate::axes::from_icrf;
use crate::earth_orbit::sun_from_earth;
use crate::ecliptic::to_icrf;
use crate::moon_orbit::moon_from_earth;

/// Mean radius of the Moon (m; IAU 2015).
pub const MOON_RADIUS: f64 = 1_737_400.0;
/// Radius of the Sun (m; IAU 2015, resolution B3).
const SUN_RADIUS: f64 = 695_700_000.0;
/// Mean radius of the Earth (m; IAU 2015).
const EARTH_RADIUS: f64 = 6_371_008.4;
/// Speed of light (m/s).
const LIGHT: f64 = 299_792_458.0;
/// Seconds of a Julian century.
const CENTURY: f64 = 36_525.0 * 86_400.0;

/// A place on the Moon: mean-Earth, polar-axis system, planetocentric.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// Longitude, positive east (rad).
    pub longitude: f64,
    /// Latitude, positive north (rad), -pi/2 to pi/2.
    pub latitude: f64,
    /// Distance from the centre of the Moon (m).
    pub radius: f64,
}

impl Place {
    /// Where the Moon's surface is nearest to something that lies in direction `of` from its centre.
    fn under(of: DVec3) -> Self {
        let of = of.normalize();
        Self {
            longitude: libm::atan2(of.y, of.x),
            latitude: libm::asin(of.z.clamp(-1.0, 1.0)),
            radius: MOON_RADIUS,
        }
    }

    /// Unit vectors to the north, to the east and up, in the axes of the Moon. At a pole north points as for a place just
    /// beside it on the same meridian.
    fn axes(self) -> [DVec3; 3] {
        let ((sin_l, cos_l), (sin_b, cos_b)) = (sin_cos(self.longitude), sin_cos(self.latitude));
        let north = DVec3::new(-sin_b * cos_l, -sin_b * sin_l, cos_b);
        let east = DVec3::new(-sin_l, cos_l, 0.0);
        let up = DVec3::new(cos_b * cos_l, cos_b * sin_l, sin_b);
        [north, east, up]
    }
}

/// A body as it is seen from a place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Seen {
    /// Clockwise from true north (rad), 0 to 2 pi.
    pub azimuth: f64,
    /// Of its centre above the horizontal (rad). The Moon has no air that would lift it.
    pub elevation: f64,
    /// Distance from the place (m).
    pub distance: f64,
    /// Angle that its disc fills (rad).
    pub angular_diameter: f64,
}

/// Sun and Earth over a place of the Moon at an instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sky {
    /// The Sun as it is seen from the place.
    pub sun: Seen,
    /// The Earth as it is seen from the place.
    pub earth: Seen,
    /// Share of the Earth's disc that is lit, 0 (new) to 1 (full).
    pub earth_lit: f64,
    /// Angle at the Earth between Sun and place (rad), 0 (full) to pi (new).
    pub earth_phase_angle: f64,
    /// Whether the lit share of the Earth grows.
    pub earth_waxes: bool,
    /// Place that has the Sun overhead.
    pub sub_solar: Place,
    /// Place that has the Earth overhead.
    pub sub_earth: Place,
}

impl Sky {
    /// What stands over `place` at `instant`: as it is seen there, with the time that light takes and the aberration of light.
    pub fn over(place: Place, instant: Instant) -> Self {
        let [sun, earth] = bodies(instant.centuries());
        let axes = place.axes();
        let at = place.radius * axes[2];
        let (from_sun, from_earth) = (sun - at, earth - at);
        let phase_angle = angle_between(sun - earth, -from_earth);
        // The Sun goes west over the Moon and the Earth stays: with the Sun to its west the Earth goes from new to full.
        let earth_waxes = sun.cross(earth).z > 0.0;
        Self {
            sun: seen(from_sun, axes, SUN_RADIUS),
            earth: seen(from_earth, axes, EARTH_RADIUS),
            earth_lit: 0.5 * (1.0 + libm::cos(phase_angle)),
            earth_phase_angle: phase_angle,
            earth_waxes,
            sub_solar: Place::under(sun),
            sub_earth: Place::under(earth),
        }
    }
}

/// Matrix from the ICRF to north, east, up at `place` at `instant`. It is a turn and a reflection: north, east and up are a
/// left-handed system, and the ICRF is a right-handed one.
pub fn icrf_to_local(place: Place, instant: Instant) -> DMat3 {
    let [north, east, up] = place.axes();
    DMat3::from_cols(north, east, up).transpose() * from_icrf(instant.centuries())
}

/// Sun and Earth as they are seen from the centre of the Moon, in its axes (m).
fn bodies(centuries: f64) -> [DVec3; 2] {
    let axes = from_icrf(centuries);
    // Light time and aberration together: where both bodies were when the light left.
    let geometric = sun_from_earth(centuries).distance;
    let earlier = centuries - geometric / LIGHT / CENTURY;
    let sun = to_icrf(earlier) * (sun_from_earth(earlier).vector() - moon_from_earth(earlier).vector());
    // The series of the Moon has the light time between Earth and Moon in it.
    let earth = to_icrf(centuries) * -moon_from_earth(centuries).vector();
    [axes * sun, axes * earth]
}

fn seen(from: DVec3, [north, east, up]: [DVec3; 3], radius: f64) -> Seen {
    let distance = from.length();
    let azimuth = wrap_heading(libm::atan2(from.dot(east), from.dot(north)));
    let elevation = libm::asin((from.dot(up) / distance).clamp(-1.0, 1.0));
    Seen { azimuth, elevation, distance, angular_diameter: 2.0 * libm::asin((radius / distance).min(1.0)) }
}

/// The angle between two directions (rad), 0 to pi.
fn angle_between(one: DVec3, other: DVec3) -> f64 {
    libm::atan2(one.cross(other).length(), one.dot(other))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The Sun's direction in the ICRF, turned to the place, is where [`Sky::over`] has it.
    #[test]
    fn directions_of_the_icrf_are_those_of_the_sky() {
        for (at, longitude, latitude) in [
            ("1972-12-11T22:00:00Z", 0.53, 0.35),
            ("2026-03-01T05:00:00Z", -2.0, -1.2),
            ("1990-07-07T00:00:00Z", 3.0, 1.5),
        ] {
            let instant: Instant = at.parse().unwrap();
            let place = Place { longitude, latitude, radius: MOON_RADIUS };
            let centuries = instant.centuries();
            let earlier = centuries - sun_from_earth(centuries).distance / LIGHT / CENTURY;
            let from_moon = sun_from_earth(earlier).vector() - moon_from_earth(earlier).vector();
            let to_local = icrf_to_local(place, instant);
            let local = to_local * (to_icrf(earlier) * from_moon) - DVec3::new(0.0, 0.0, MOON_RADIUS);
            let (sun, direction) = (Sky::over(place, instant).sun, local.normalize());
            let ((sin_e, cos_e), (sin_a, cos_a)) = (sin_cos(sun.elevation), sin_cos(sun.azimuth));
            assert!((direction - DVec3::new(cos_e * cos_a, cos_e * sin_a, sin_e)).length() < 1e-9, "{at}");
            assert!((to_local.determinant() + 1.0).abs() < 1e-12);
        }
    }
}
