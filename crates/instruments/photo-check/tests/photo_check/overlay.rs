//! Both pictures over one another: north up, one place a pixel, and how alike they are.

use landscape::Sun;
use photo_check::{Ground, Overlay, Relief};
use photograph::{MapUnit, Photograph};
use quantities::radians;

use crate::{elevation, from_above, from_the_south, ground, map, picture};

fn bumps(north: f64, east: f64) -> f64 {
    6.0 * libm::sin(0.05 * north) + 4.0 * libm::cos(0.07 * east)
}

fn sun() -> Sun {
    Sun { azimuth: radians(300.0), elevation: radians(40.0) }
}

fn overlay(ground: &Ground, photo: &Photograph) -> Overlay {
    Overlay::new(ground, photo, &Relief::new(ground, &sun()), None)
}

/// A map whose codes are the relief itself, in the order of [`elevation`]: `code(light)`.
fn of_relief(code: impl Fn(f64) -> f64) -> Photograph {
    let made = elevation([20, 30], bumps);
    let blank = map(picture([30, 20], |_, _| 0), MapUnit::Metre);
    let relief = Relief::new(&ground(&made, &blank), &sun());
    let codes =
        |column: usize, line: usize| (65_535.0 * code(relief.light([line, column]).expect("known"))) as u16;
    map(picture([30, 20], codes), MapUnit::Metre)
}

#[test]
fn a_photograph_of_the_relief_correlates_fully() {
    for made in [elevation([20, 30], bumps), from_the_south([20, 30], bumps)] {
        let photo = of_relief(|light| 0.2 + 0.7 * light);
        let likeness = overlay(&ground(&made, &photo), &photo).likeness().expect("both vary");
        assert!(likeness.correlation > 0.9999, "{likeness:?}");
        assert_eq!((likeness.offset, likeness.at_the_end), ([0.0, 0.0], false));
        let negative = of_relief(|light| 0.9 - 0.7 * light);
        let likeness = overlay(&ground(&made, &negative), &negative).likeness().expect("both vary");
        assert!(likeness.correlation < -0.9999, "{likeness:?}");
    }
    let flat = map(picture([30, 20], |_, _| 9), MapUnit::Metre);
    assert_eq!(overlay(&ground(&elevation([20, 30], bumps), &flat), &flat).likeness(), None);
}

/// A photograph whose features lie three posts east and two south is found there, on bumps that do not repeat within the reach.
#[test]
fn an_offset_is_found_with_its_sign() {
    let heights = |n: f64, e: f64| bumps(n, e) + 3.0 * libm::sin(0.011 * n + 0.017 * e);
    let made = elevation([60, 70], heights);
    let blank = map(picture([70, 60], |_, _| 0), MapUnit::Metre);
    let relief = Relief::new(&ground(&made, &blank), &sun());
    let light = |column: usize, line: usize| relief.light([line, column]).expect("known");
    let moved = |column: usize, line: usize| light(column.saturating_sub(3), line.saturating_sub(2));
    let photo =
        map(picture([70, 60], |column, line| (60_000.0 * moved(column, line)) as u16), MapUnit::Metre);
    let ground = ground(&made, &photo);
    // Two pixels of the overlay for each post.
    let found = Overlay::new(&ground, &photo, &relief, Some(5.0)).likeness().expect("both vary");
    let [east, north] = found.offset;
    assert!((east - 30.0).abs() < 2.6 && (north + 20.0).abs() < 2.6, "{found:?}");
    assert!(found.best_correlation > 0.99 && found.correlation < 0.9 && !found.at_the_end, "{found:?}");
}

/// The picture is north up and west to the left: the code of the photograph grows to the right and downward.
#[test]
fn both_pictures_are_north_up() {
    let heights = |_: f64, _: f64| 0.0;
    for made in [elevation([19, 19], heights), from_the_south([19, 19], heights)] {
        let photo = from_above();
        let found = overlay(&ground(&made, &photo), &photo);
        assert_eq!(found.size(), [18, 18]);
        let light = |column: usize, line: usize| 65_535.0 * found.lights(column, line)[0].expect("inside");
        assert!(light(12, 5) - light(5, 5) > 10_000.0);
        let down = light(5, 12) - light(5, 5);
        assert!((down - 35.0).abs() < 0.1, "{down}");
    }
}

/// The pictures have the finer of both samples, and what lies beside the photograph is marked.
#[test]
fn size_and_what_is_beside() {
    let made = elevation([61, 41], |_, _| 0.0);
    let photo = from_above();
    let ground = ground(&made, &photo);
    let relief = Relief::new(&ground, &sun());
    assert_eq!(Overlay::new(&ground, &photo, &relief, Some(4.0)).size(), [100, 150]);
    let coarse = Overlay::new(&ground, &photo, &relief, Some(1e-4));
    assert_eq!(coarse.size(), [800, 1200]);
    // The photograph reaches from 0 to 200 m; the grid from 0 to 600 m to the north.
    let ([none, relief], [photo, _]) = (coarse.lights(10, 10), coarse.lights(10, 1190));
    assert!(none.is_none() && photo.is_some());
    assert!((relief.expect("known") - sun().reflectivity([0.0; 2])).abs() < 1e-12);
    let picture = coarse.photo().expect("a picture");
    assert_eq!(picture.pixel(10, 10), [18, 26, 52]);
}

/// The camera stands 1000 m above (100, 100): a wall of 400 m at 150 m east hides the ground up to 400 / 600 of 50 m behind it.
#[test]
fn ground_behind_a_wall_is_hidden() {
    let wall = |_: f64, e: f64| if (e - 150.0).abs() < 1.0 { 400.0 } else { 0.0 };
    for made in [elevation([21, 21], wall), from_the_south([21, 21], wall)] {
        let photo = from_above();
        let ground = ground(&made, &photo);
        let found = Overlay::new(&ground, &photo, &Relief::new(&ground, &sun()), Some(2.0));
        assert_eq!(found.size(), [100, 100]);
        // Pixel i of line 50 lies 2 i + 1 m east.
        let hidden: Vec<f64> = (0..100)
            .filter(|column| found.lights(*column, 50)[0].is_none())
            .map(|column| 2.0 * column as f64 + 1.0)
            .collect();
        let [first, last] = [hidden[0], hidden[hidden.len() - 1]];
        assert!((150.0..156.0).contains(&first) && (179.0..184.0).contains(&last), "{hidden:?}");
        assert_eq!(hidden.len() as f64, (last - first) / 2.0 + 1.0, "{hidden:?}");
        assert!(found.hidden() > 0.1 && found.hidden() < 0.2, "{}", found.hidden());
        let column = ((hidden[3] - 1.0) / 2.0) as usize;
        assert_eq!(found.photo().expect("a picture").pixel(column, 50), [96, 40, 110]);
    }
    // A map has no camera from which anything could be hidden.
    let flat = map(picture([21, 21], |_, _| 9), MapUnit::Metre);
    let ground = ground(&elevation([21, 21], wall), &flat);
    assert_eq!(overlay(&ground, &flat).hidden(), 0.0);
}
