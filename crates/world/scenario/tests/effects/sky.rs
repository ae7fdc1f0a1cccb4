//! Sun, Earth and a sky that a date turns.

use super::*;

#[test]
fn the_disc_of_the_sun_is_where_the_light_comes_from() {
    let drift = "disc = true\nstep_s = 1\ndrift = [{ t_s = 2, azimuth_deg = 30, elevation_deg = 6 }]\n";
    let scenery = made(&format!("{drift}{EARTH}"));
    for time in [0.0, 0.9, 1.0, 2.5] {
        let [earth, sun] = scenery.effects(time).discs[..] else { panic!("two discs") };
        let to_sun = |time: f64| DVec3::from_array(scenery.sun(time).direction());
        assert_eq!((sun.direction, sun.face), (to_sun(time), DiscFace::Sun { colour: [1.0; 3] }));
        assert_eq!((sun.angular_diameter, earth.angular_diameter), (radians(0.533), radians(1.9)));
        assert_eq!(earth.face, DiscFace::Ball { albedo: [0.38, 0.43, 0.54], sun: to_sun(0.0) });
    }
}

#[test]
fn a_star_where_the_sun_is_coincides_with_the_sun() {
    let at = "1972-12-11T22:00:00Z";
    let instant: Instant = at.parse().unwrap();
    let sun = Sky::over(APOLLO, instant).sun;
    let local = landscape::Sun { azimuth: sun.azimuth, elevation: sun.elevation }.direction();
    let icrf = icrf_to_local(APOLLO, instant).transpose() * DVec3::from_array(local);
    let (right_ascension, declination) = (libm::atan2(icrf.y, icrf.x), libm::asin(icrf.z));
    let row = format!("{:?},{:?},1,\n", degrees(right_ascension), degrees(declination));
    for true_north in [0.0, 0.4, -2.0] {
        let (_, scenery) =
            dated(at, &format!("{HEADER}{row}"), &format!("disc = true\n{CATALOGUE}[earth]\n"), true_north);
        let effects = scenery.effects(0.0);
        let to_sun = DVec3::from_array(scenery.sun(0.0).direction());
        // The radius of the bank's sphere differs by some metres from the Moon's.
        assert!((directions(&effects)[0] - to_sun).length() < 1e-6, "{true_north}");
        let [earth, disc] = effects.discs[..] else { panic!("two discs") };
        let sky = scenery.sky().unwrap();
        assert_eq!((disc.direction, disc.angular_diameter), (to_sun, sky.sky.sun.angular_diameter));
        assert_eq!(earth.angular_diameter, sky.sky.earth.angular_diameter);
        assert!((degrees(libm::asin(earth.direction.z)) - degrees(sky.sky.earth.elevation)).abs() < 1e-9);
        let azimuth = libm::atan2(earth.direction.y, earth.direction.x) - sky.sky.earth.azimuth - true_north;
        assert!(libm::sin(azimuth).abs() < 1e-9 && libm::cos(azimuth) > 0.0, "{azimuth}");
    }
}

/// At equinoxes and solstices the Sun seen from the Earth is at a known place. Seen from the Moon it is 0.15 degrees beside it
/// at most: 384 400 km over 149.6 million km. Equinox and equator of the year differ by less than 0.02 degrees from the ICRF.
#[test]
fn the_sun_of_equinoxes_and_solstices_is_where_it_is_known_to_be() {
    for (at, right_ascension, declination) in [
        ("2000-03-20T07:35:00Z", 0.0, 0.0),
        ("2000-06-21T01:48:00Z", 90.0, 23.44),
        ("2000-09-22T17:28:00Z", 180.0, 0.0),
        ("2000-12-21T13:37:00Z", 270.0, -23.44),
    ] {
        let under = Sky::over(APOLLO, at.parse().unwrap()).sub_solar;
        // Beside the place that has the sun overhead, so that azimuths count.
        let [longitude, latitude] = [degrees(under.longitude) + 30.0, degrees(under.latitude) + 20.0];
        let place = format!("place = {{ longitude_deg = {longitude}, latitude_deg = {latitude} }}\n");
        let row = format!("{HEADER}{right_ascension},{declination},1,\n");
        let (_, scenery) = dated(at, &row, &format!("{place}{CATALOGUE}"), 0.0);
        let to_sun = DVec3::from_array(scenery.sun(0.0).direction());
        let beside = degrees((directions(&scenery.effects(0.0))[0] - to_sun).length());
        assert!(beside < 0.17, "{at}: {beside}");
    }
}

#[test]
fn a_date_turns_the_sky_and_nothing_else_may() {
    let keys = "at = '1972-12-11T22:00:00Z'\nplace = { longitude_deg = 30.77, latitude_deg = 20.19 }";
    let good = GOOD.replace("azimuth_deg = 10\nelevation_deg = 12", keys);
    for (tables, line, expected) in [
        ("[stars]\nseed = 1\ncount = 2\nturn_deg = [0, 0, 0]\n", 3, "`stars.turn_deg` beside `sun.at`"),
        ("[earth]\nazimuth_deg = 3\n", 1, "`earth.azimuth_deg` beside `sun.at`"),
        ("[earth]\nelevation_deg = 3\n", 1, "`earth.elevation_deg` beside `sun.at`"),
        ("[earth]\ndiameter_deg = 3\n", 1, "`earth.diameter_deg` beside `sun.at`"),
    ] {
        let list = Scenario::parse("t.toml", &format!("{good}{tables}")).unwrap_err();
        let [problem] = &list.iter().collect::<Vec<_>>()[..] else { panic!("{list}") };
        assert!(problem.record().line == Some(MORE + line) && problem.title.contains(expected), "{list}");
    }
    assert!(Scenario::parse("t.toml", &format!("{good}[stars]\nseed = 1\ncount = 2\n[earth]\n")).is_ok());
}
