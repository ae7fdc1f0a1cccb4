//! The sky against published values: Apollo landings, worked examples, eclipses.

use ephemeris::{Instant, MOON_RADIUS, Place, Sky};
use proptest::prelude::{ProptestConfig, prop_assert, proptest};
use quantities::{degrees, radians};

fn sky(at: &str, longitude: f64, latitude: f64) -> Sky {
    let place = Place { longitude: radians(longitude), latitude: radians(latitude), radius: MOON_RADIUS };
    Sky::over(place, at.parse().unwrap_or_else(|error| panic!("{at}: {error}")))
}

/// R. Orloff, Apollo by the Numbers (NASA SP-2000-4029): landing sites, times of touchdown, and the Sun's elevation then, to a
/// tenth of a degree. Apollo 16 landed 5 h 43 min late; the elevation is that of the plan, and so is the time here. The
/// morning sun stands in the east.
#[test]
fn suns_of_the_apollo_landings() {
    for (mission, at, longitude, latitude, elevation) in [
        (11, "1969-07-20T20:17:39Z", 23.47297, 0.67408, 10.8),
        (12, "1969-11-19T06:54:36Z", -23.42157, -3.01239, 5.1),
        (14, "1971-02-05T09:18:13Z", -17.47136, -3.64530, 10.3),
        (15, "1971-07-30T22:16:29Z", 3.63386, 26.13222, 12.2),
        (16, "1972-04-20T20:40:42Z", 15.50019, -8.97301, 11.9),
        (17, "1972-12-11T19:54:58Z", 30.77168, 20.19080, 13.3),
    ] {
        let sun = sky(at, longitude, latitude).sun;
        let found = [sun.elevation, sun.azimuth].map(degrees);
        println!("Apollo {mission}: elevation {:.2}, azimuth {:.2}", found[0], found[1]);
        assert!((found[0] - elevation).abs() < 0.25, "Apollo {mission}: {found:?}, published {elevation}");
        assert!((85.0..100.0).contains(&found[1]), "Apollo {mission}: {found:?}");
    }
}

/// Meeus, Astronomical Algorithms, 2nd ed., example 53.a: 1992 April 12, 0h TD, which is 58.7 s before 0h UTC. Meeus means the
/// principal axes of the Moon; the poles of those and of the mean-Earth axes lie 0.022 degrees apart.
#[test]
fn libration_and_sun_of_example_53_a() {
    let Sky { sub_earth, sub_solar, .. } = sky("1992-04-11T23:59:01Z", 0.0, 0.0);
    let near = |place: Place, longitude: f64, latitude: f64, within: f64| {
        let found = [place.longitude, place.latitude].map(degrees);
        assert!((found[0] - longitude).abs() < within && (found[1] - latitude).abs() < within, "{found:?}");
    };
    near(sub_earth, -1.23, 4.20, 0.03);
    near(sub_solar, 67.89, 1.46, 0.03);
}

/// F. Espenak and J. Meeus, Five Millennium Canon of Lunar Eclipses (NASA/TP-2006-214141): greatest eclipse of 2018 July 27 at
/// 20:21:44 UT, the axis of the shadow 0.1168 radii of the Earth from the Moon's centre.
#[test]
fn a_lunar_eclipse_puts_the_sun_behind_the_earth() {
    let Sky { earth, sub_solar, sub_earth, earth_lit, .. } = sky("2018-07-27T20:21:44Z", 0.0, 0.0);
    let apart = libm::acos(
        libm::sin(sub_solar.latitude) * libm::sin(sub_earth.latitude)
            + libm::cos(sub_solar.latitude)
                * libm::cos(sub_earth.latitude)
                * libm::cos(sub_solar.longitude - sub_earth.longitude),
    );
    let expected = libm::atan(0.1168 * 6_378_137.0 / (earth.distance + MOON_RADIUS));
    assert!(degrees(apart - expected).abs() < 0.005, "{} {}", degrees(apart), degrees(expected));
    assert!(earth_lit < 1e-3);
}

/// New moon is full Earth: the same canon has the solar eclipse of 2017 August 21 at 18:25:32 UT.
#[test]
fn a_solar_eclipse_is_a_full_earth() {
    let full = sky("2017-08-21T18:25:32Z", 0.0, 0.0);
    assert!(full.earth_lit > 0.9999 && degrees(full.earth_phase_angle) < 1.5);
    let [before, after] = ["2017-08-18T18:25:32Z", "2017-08-24T18:25:32Z"].map(|at| sky(at, 0.0, 0.0));
    assert!(before.earth_waxes && !after.earth_waxes);
    assert!(before.earth_lit < 0.95 && after.earth_lit < 0.95);
}

/// Sun and Earth are disks of about half a degree and of two.
#[test]
fn angular_diameters() {
    let Sky { sun, earth, .. } = sky("1972-12-11T22:00:00Z", 30.77, 20.19);
    assert!((degrees(sun.angular_diameter) - 0.5415).abs() < 0.001, "{}", degrees(sun.angular_diameter));
    assert!((1.79..2.05).contains(&degrees(earth.angular_diameter)));
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]
    /// What stands over a place follows from the points below Sun and Earth.
    #[test]
    fn elevations_are_those_over_the_points_below(
        seconds in 0.0..2.8e9f64, longitude in -180.0..180.0f64, latitude in -90.0..90.0f64,
    ) {
        let instant = "1960-01-01T00:00:00Z".parse::<Instant>().unwrap().later(seconds);
        let place = Place { longitude: radians(longitude), latitude: radians(latitude), radius: MOON_RADIUS };
        let sky = Sky::over(place, instant);
        let (own, sun) = (place, sky.sub_solar);
        let cos = libm::sin(own.latitude) * libm::sin(sun.latitude)
            + libm::cos(own.latitude) * libm::cos(sun.latitude) * libm::cos(own.longitude - sun.longitude);
        // Seen from the ground the Sun is up to 2.5 seconds of arc lower than from the centre.
        prop_assert!((libm::sin(sky.sun.elevation) - cos).abs() < 2e-5);
        // The Sun stays within 1.6 degrees of the equator of the Moon, the Earth within 8 of the middle of its disc.
        prop_assert!(degrees(sun.latitude).abs() < 1.6);
        prop_assert!(degrees(sky.sub_earth.latitude).abs() < 7.0 && degrees(sky.sub_earth.longitude).abs() < 8.2);
        prop_assert!((0.0..std::f64::consts::TAU).contains(&sky.sun.azimuth));
        prop_assert!((0.0..=1.0).contains(&sky.earth_lit));
    }
}
