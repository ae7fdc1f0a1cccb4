//! Diameter and intensity by distance and magnitude.

use light_points::{Blending, Disc, LeastDiameter, Light, crossover, projected_diameter};
use raster::{Pattern, Sampling};

use crate::{assert_published, focal};

const DIAMETER: f64 = 0.3;

fn least() -> LeastDiameter {
    LeastDiameter::new(LeastDiameter::DEFAULT, &Sampling::new(Pattern::Four)).expect("wide enough")
}

fn lamp(distance: f64) -> Disc {
    let projected = projected_diameter(DIAMETER, distance, focal()).expect("sound figures");
    Disc::of_lamp(projected, 1.0, least())
}

#[test]
fn a_lamp_of_the_check_values() {
    assert_published(focal(), 1072.253460254779);
    assert_published(crossover(DIAMETER, focal(), least()), 214.450692050956);
    for [distance, diameter, intensity, translucency, light] in [
        [50.0, 6.433520761529, 1.0, 0.0, 32.507778728809],
        [100.0, 3.216760380764, 1.0, 0.0, 8.126944682202],
        [crossover(DIAMETER, focal(), least()), 1.5, 1.0, 0.0, 1.767145867644],
        [400.0, 1.5, 0.287431870757, 0.712568129243, 0.507934042638],
        [1000.0, 1.5, 0.045989099321, 0.954010900679, 0.081269446822],
        [5000.0, 1.5, 0.001839563973, 0.998160436027, 0.003250777873],
    ] {
        let disc = lamp(distance);
        assert_published(disc.diameter, diameter);
        assert_published(disc.intensity, intensity);
        assert_published(Light::new(disc.intensity, Blending::Hiding).translucency, translucency);
        assert_published(disc.light(), light);
    }
}

#[test]
fn light_goes_on_as_the_inverse_square_over_the_crossover() {
    let at_1_m = lamp(1.0).light();
    for step in 0..400 {
        let distance = 50.0 * libm::pow(100.0, f64::from(step) / 399.0);
        let ratio = lamp(distance).light() * distance * distance / at_1_m;
        assert!((ratio - 1.0).abs() < 1e-12, "{ratio} at {distance} m");
    }
    let edge = crossover(DIAMETER, focal(), least());
    assert_eq!(lamp(edge * 0.999).intensity, 1.0);
    assert!(lamp(edge * 1.001).intensity < 1.0 && lamp(edge * 1.001).diameter == 1.5);
}

#[test]
fn stars_of_the_check_values() {
    let star = |magnitude| Disc::of_star(magnitude + 1.46, least()).expect("sound figures");
    for (magnitude, intensity) in [(0.03, 0.253512863050), (2.0, 0.041304750199), (4.0, 0.006546361741)] {
        assert_published(star(magnitude).intensity, intensity);
        assert_eq!(star(magnitude).diameter, 1.5);
    }
    assert_eq!((star(-1.46).diameter, star(-1.46).intensity), (1.5, 1.0));
    let hundredfold = star(-6.46);
    assert!((hundredfold.diameter - 15.0).abs() < 1e-12 && hundredfold.intensity == 1.0, "{hundredfold:?}");
}

/// Earth and sun are discs of their own: far wider than any least diameter.
#[test]
fn earth_and_sun_are_wider_than_points() {
    let across = |half_angle: f64| 2.0 * focal() * libm::tan(half_angle);
    let earth = libm::asin(6371.0 / 384400.0);
    assert_published(2.0 * earth.to_degrees(), 1.899313867357);
    assert!((across(earth) - 35.547686).abs() < 1e-6, "{}", across(earth));
    let sun = across(0.532906214492f64.to_radians() / 2.0);
    assert!((sun - 9.973).abs() < 5e-4, "{sun}");
}

#[test]
fn figures_that_no_lamp_has_are_refused() {
    for wrong in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        for place in 0..3 {
            let mut figures = [0.3, 100.0, 1000.0];
            figures[place] = wrong;
            let [diameter, distance, focal] = figures;
            assert!(projected_diameter(diameter, distance, focal).is_err(), "{figures:?}");
        }
    }
    for wrong in [f64::NAN, 101.0, -101.0, f64::INFINITY] {
        assert!(Disc::of_star(wrong, least()).is_err(), "{wrong}");
    }
    let message = projected_diameter(0.0, 1.0, 1.0).unwrap_err().to_string();
    assert_eq!(message, "diameter of a lamp (m) is 0: expected a number above 0");
}
