//! Landscapes in closed form: ground whose shadow is known.

use features::{Crater, Features, Shape};
use landscape::{Bank, Landscape, Level};
use sight::{Curvature, Point, Raster, Sight, Terrain};

/// Ground on a flat datum.
pub const FLAT: Curvature = Curvature::FLAT;

/// A level whose words at each corner (x, y) are those of a function of place.
pub fn level(corners: usize, region: f64, words: impl FnMut(f64, f64) -> [f64; 9]) -> Level {
    let mut words = words;
    let corner = |at: usize| words(region * (at / corners) as f64, region * (at % corners) as f64);
    let words = (0..corners * corners).map(corner).collect();
    Level::new(region, [0.0; 2], [corners; 2], words).unwrap()
}

/// The ground of levels with craters.
pub fn terrain(levels: Vec<Level>, craters: Vec<Crater>) -> Terrain {
    let bank = Bank::new("test", levels, None).unwrap();
    Terrain::new(Landscape::new(bank, 0.2).with_features(Features::new(craters)))
}

fn flat_with(crater: Crater) -> Terrain {
    terrain(vec![level(11, 50.0, |_, _| [0.0; 9])], vec![crater])
}

#[test]
fn a_plane_hides_nothing() {
    // h = 3 + 0.2 x - 0.1 y.
    let plane = |x: f64, y: f64| [3.0 + 0.2 * x - 0.1 * y, -5.0, 0.0, 10.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    let ground = terrain(vec![level(11, 50.0, plane)], vec![]);
    let targets = Raster { size: [26, 26], corner: [500.0, 0.0], spacing: 20.0 };
    for height in [0.001, 2.0, 1e6] {
        let eye = Point::above_ground([133.0, 271.0], height);
        let seen = ground.viewshed(&eye, &targets, 0.0, FLAT, &|| ()).unwrap();
        assert!(seen.iter().all(|&sight| sight == Sight::Visible), "{height}");
        let least = ground.least_heights(&eye, &targets, FLAT, &|| ()).unwrap();
        assert!(least.iter().all(|&least| least < 1e-9), "{height}");
        let line =
            ground.line_of_sight(&eye, &Point::above_ground([10.0, 10.0], 0.5 * height), FLAT).unwrap();
        assert!((line.clearance - 0.5 * height).abs() < 1e-9 * (1.0 + height), "{}", line.clearance);
    }
}

/// On h = -k x^2 an eye e above the top sees as far as `sqrt(e / k)`. Behind, a target must stand `(sqrt(k) s - sqrt(e))^2` high.
#[test]
fn a_paraboloid_has_a_horizon() {
    let k = 1e-4;
    let bowl =
        |x: f64, _: f64| [-k * x * x, 0.0, 0.0, -2.0 * k * x * 50.0, 0.0, 0.0, -2.0 * k * 2500.0, 0.0, 0.0];
    let ground = terrain(vec![level(11, 50.0, bowl)], vec![]);
    for height in [0.1, 1.0, 9.0] {
        let eye = Point::above_ground([0.0, 250.0], height);
        for distance in [40.0, 99.0, 101.0, 180.0, 333.0, 500.0] {
            let line =
                ground.line_of_sight(&eye, &Point::above_ground([distance, 250.0], 0.0), FLAT).unwrap();
            let lacks = k.sqrt() * distance - height.sqrt();
            let expected = if lacks > 0.0 { lacks * lacks } else { 0.0 };
            assert_eq!(line.sight == Sight::Hidden, lacks > 0.0, "{height} {distance}");
            let least = line.least_height.unwrap();
            assert!((least - expected).abs() < 1e-8, "{height} {distance}: {least} {expected}");
            // The line to the ground is a chord: it lies k s (d - s) - e (1 - s / d) below the ground at most.
            if let Some(blocker) = line.blocker {
                let meets = height / (k * distance);
                assert!((blocker.distance - meets).abs() < 1e-6, "{} {meets}", blocker.distance);
            }
        }
    }
}

/// From h above flat ground, at D from the edge of a bowl, the line over the edge falls by h / D.
#[test]
fn the_edge_of_a_bowl_hides_its_near_wall() {
    let bowl = Crater::new([250.0, 250.0], Shape::Bowl { r1: 100.0 }, 20.0, 0.0).unwrap();
    let ground = flat_with(bowl);
    let (height, from_edge) = (15.0, 120.0);
    let eye = Point::above_ground([250.0, 30.0], height);
    for distance in [130.0, 180.0, 220.0, 290.0, 315.0, 400.0] {
        let line =
            ground.line_of_sight(&eye, &Point::above_ground([250.0, 30.0 + distance], 0.0), FLAT).unwrap();
        let target = bowl.profile((distance - 220.0f64).abs())[0];
        let expected = (-height * (distance - from_edge) / from_edge - target).max(0.0);
        let expected = if distance > from_edge { expected } else { 0.0 };
        let least = line.least_height.unwrap();
        assert!((least - expected).abs() < 1e-9, "{distance}: {least} {expected}");
        assert_eq!(line.sight == Sight::Hidden, expected > 0.0, "{distance}");
    }
}

/// The line from flat ground that touches the crest of a rim, which is a parabola along a line through the centre.
#[test]
fn the_rim_of_a_crater_is_a_parabola() {
    let crater = Crater::new([250.0, 250.0], Shape::RimmedBowl { r1: 60.0, r2: 100.0 }, 30.0, 8.0).unwrap();
    let ground = flat_with(crater);
    let height = 2.0;
    let eye = Point::above_ground([250.0, 20.0], height);
    // z = 8 (1 - (u / 20)^2), u from the crest at 150 m. From (-150, 2): tangent where 8 + k u^2 + 300 k u = 2, k = 8 / 400.
    let (crest, k) = (250.0_f64 - 80.0 - 20.0, 8.0 / 400.0);
    let u = -crest + (crest * crest - 6.0 / k).sqrt();
    let slope = -2.0 * k * u;
    let distance = 230.0;
    let line = ground.line_of_sight(&eye, &Point::above_ground([250.0, 250.0], 0.0), FLAT).unwrap();
    let expected = height + slope * distance + 30.0;
    assert!((line.least_height.unwrap() - expected).abs() < 1e-8, "{:?} {expected}", line.least_height);
    // The line to the floor falls from 2 m by 32 m over 230 m, and the rim begins 130 m away: the ground before it is met first.
    let meets = height * distance / 32.0;
    assert!((line.blocker.unwrap().distance - meets).abs() < 1e-6, "{:?} {meets}", line.blocker);
}

/// Terrain alone would not reach the line: the rim does.
#[test]
fn a_rim_on_flat_ground_hides_what_stands_behind_it() {
    let crater = Crater::new([250.0, 250.0], Shape::RimmedBowl { r1: 60.0, r2: 100.0 }, 30.0, 8.0).unwrap();
    let ground = flat_with(crater);
    for (height, clearance) in [(5.0, -3.0), (7.9, -0.1), (9.0, 1.0)] {
        let [eye, target] = [20.0, 480.0].map(|east| Point::above_ground([250.0, east], height));
        let line = ground.line_of_sight(&eye, &target, FLAT).unwrap();
        assert!((line.clearance - clearance).abs() < 1e-9, "{height}: {}", line.clearance);
        assert_eq!(line.sight == Sight::Hidden, clearance < 0.0, "{height}");
        // The rim reaches the line where 8 (1 - (u / 20)^2) is the height; its crest stands 150 m away.
        let meets = line.blocker.map(|blocker| blocker.distance);
        let expected = (height < 8.0).then(|| 150.0 - 20.0 * (1.0 - height / 8.0_f64).sqrt());
        assert!(meets.zip(expected).is_none_or(|(a, b)| (a - b).abs() < 1e-6), "{meets:?} {expected:?}");
        assert_eq!(meets.is_some(), expected.is_some());
    }
}

#[test]
fn points_and_grids_that_cannot_be_are_refused() {
    let ground = terrain(vec![level(3, 50.0, |_, _| [5.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0])], vec![]);
    let other = Point::above_ground([10.0, 10.0], 1.0);
    let told = |point: Point| ground.line_of_sight(&point, &other, FLAT).unwrap_err().to_string();
    assert!(told(Point::above_ground([-1.0, 3.0], 1.0)).contains("no ground at (-1, 3) m"));
    assert!(told(Point::above_datum([1.0, 3.0], 4.0)).contains("m below the ground"));
    let beside = Point::above_datum([-1.0, 3.0], 9.0);
    assert_eq!(ground.line_of_sight(&beside, &other, FLAT).unwrap().sight, Sight::Visible);
    let same = ground.line_of_sight(&other, &other, FLAT).unwrap();
    assert_eq!((same.distance, same.clearance, same.least_height), (0.0, 1.0, Some(0.0)));
    for targets in [
        Raster { size: [0, 4], corner: [0.0; 2], spacing: 1.0 },
        Raster { size: [4, 4], corner: [0.0; 2], spacing: 0.0 },
        Raster { size: [4, 4], corner: [f64::NAN, 0.0], spacing: 1.0 },
    ] {
        assert!(ground.viewshed(&other, &targets, 0.0, FLAT, &|| ()).is_err());
        assert!(ground.least_heights(&other, &targets, FLAT, &|| ()).is_err());
    }
    let targets = Raster { size: [2, 2], corner: [10.0, 0.0], spacing: 1.0 };
    assert!(ground.viewshed(&other, &targets, -1.0, FLAT, &|| ()).is_err());
}
