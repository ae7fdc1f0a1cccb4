//! The light of posts: planes and a wall in closed form.

use landscape::Sun;
use photo_check::Relief;
use quantities::radians;

use crate::{elevation, from_above, from_the_south, ground};

fn sun(azimuth: f64, elevation: f64) -> Sun {
    Sun { azimuth: radians(azimuth), elevation: radians(elevation) }
}

/// Slopes of a plane are exact at every post, the edges among them, in both orders of lines.
#[test]
fn a_plane_has_the_light_of_its_normal() {
    let (north, east) = (0.2, -0.3);
    let heights = |n: f64, e: f64| north * n + east * e;
    for made in [elevation([6, 7], heights), from_the_south([6, 7], heights)] {
        let ground = ground(&made, &from_above());
        for sun in [sun(30.0, 40.0), sun(250.0, 60.0)] {
            let relief = Relief::new(&ground, &sun);
            let [to_north, to_east, up] = sun.direction();
            let length = (1.0 + north * north + east * east).sqrt();
            let expected = (up - north * to_north - east * to_east) / length;
            for post in [[0, 0], [5, 6], [2, 3], [0, 4]] {
                let found = relief.light(post).expect("known");
                assert!((found - expected).abs() < 1e-12, "{post:?}: {found}, not {expected}");
            }
        }
    }
}

/// A wall of 40 m casts a shadow of 40 m over the tangent of the elevation, away from the sun, whichever side the sun is on.
#[test]
fn a_wall_casts_its_shadow() {
    let heights = |_: f64, e: f64| if (e - 200.0).abs() < 1.0 { 40.0 } else { 0.0 };
    for made in [elevation([5, 41], heights), from_the_south([5, 41], heights)] {
        let ground = ground(&made, &from_above());
        for (azimuth, away) in [(90.0, -1.0), (270.0, 1.0)] {
            // 40 m / tan = 114.3 m: eleven posts behind the wall are dark, the twelfth is lit.
            let relief = Relief::new(&ground, &sun(azimuth, 19.29));
            for posts in 1..=20_i32 {
                let column = (20 + (away as i32) * posts) as usize;
                let light = relief.light([2, column]).expect("known");
                assert_eq!(light == 0.0, posts <= 11, "{azimuth}, {posts} posts: {light}");
                let before = (20 - (away as i32) * posts) as usize;
                assert!(relief.light([2, before]).expect("known") > 0.0, "{azimuth}, {posts} posts before");
            }
        }
    }
}

/// The sun in the north-west: shadow falls to the south-east, in lines as in columns.
#[test]
fn shadow_falls_away_from_the_sun() {
    let heights =
        |n: f64, e: f64| if (n - 200.0).abs() < 1.0 && (e - 200.0).abs() < 1.0 { 60.0 } else { 0.0 };
    let ground = ground(&elevation([41, 41], heights), &from_above());
    let relief = Relief::new(&ground, &sun(315.0, 30.0));
    let dark = |line: usize, column: usize| relief.light([line, column]).expect("known") == 0.0;
    // The post stands in line 20; south lies at greater lines.
    assert!(dark(24, 24) && !dark(16, 16) && !dark(16, 24) && !dark(24, 16));
}
