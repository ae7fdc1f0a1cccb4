//! Maps beside frames: places, north, course and rays.

use std::sync::Arc;

use briefing::{Briefing, BriefingError, Place};
use generator::Stage;
use landscape::{Attitude, Bank, Landscape, Level, Sun};
use photograph::{Map, MapUnit, Photograph, Placement};
use picture::{ColourPicture, Depth, GAP, GreyPicture};
use quantities::{Rate, radians};
use scenario::{Curvature, Display, FieldOfView, Laws, Pose, Scenery, View};

/// Columns and lines of a frame.
const SIZE: [usize; 2] = [120, 80];
/// Colours of the course flown and still to fly, and of the eye.
const COLOURS: [[u16; 3]; 3] = [[255, 170, 0], [140, 95, 20], [90, 200, 255]];

/// Level ground, 400 m to the north and 300 m to the east.
fn ground() -> Landscape {
    let level = Level::new(100.0, [0.0; 2], [5, 4], vec![[0.0; 9]; 20]).unwrap();
    Landscape::new(Bank::new("level", vec![level], None).unwrap(), 0.5)
}

fn stage(landscape: Landscape) -> Stage {
    let rate = Rate::new(10, 1).unwrap();
    Stage {
        landscape: Arc::new(landscape),
        scenery: Arc::new(Scenery::still(Sun { azimuth: 1.0, elevation: radians(30.0) })),
        view: View {
            columns: SIZE[0] as u32,
            lines: SIZE[1] as u32,
            field: FieldOfView { tan_half_width: 1.0, tan_half_height: 0.75 },
            update: rate,
            refresh: rate,
            display: Display { white: 1.0, gamma: 1.0 },
            laws: Laws { curvature: Curvature::None, ..Laws::default() },
            ranges: [1.0, 500.0],
            yoke: None,
            levels: None,
            shadows: None,
        },
    }
}

fn pose(north: f64, east: f64, heading: f64) -> Pose {
    let attitude = Attitude { roll: 0.3, pitch: -0.2, heading };
    Pose { time: 0.0, eye: [north, east, 50.0], attitude, yoke: 0.0 }
}

/// A photograph of the ground whose northern half is white and whose southern half is black.
fn photograph() -> Photograph {
    let codes = (0..60 * 80).map(|pixel| if pixel < 60 * 40 { 255 } else { 0 }).collect();
    let picture = GreyPicture::new(60, 80, Depth::Eight, codes).unwrap();
    let map = Map::new([5.0, 0.0, 0.0], [0.0, -5.0, 400.0], MapUnit::Metre).unwrap();
    Photograph::new(picture, Placement::Map(map), Default::default()).unwrap()
}

fn code(map: &ColourPicture, place: [f64; 2]) -> [u16; 3] {
    map.pixel(place[0] as usize, place[1] as usize)
}

#[test]
fn all_the_ground_fits_and_its_middle_is_in_the_middle() {
    let place = Place::fitting([0.0, 0.0, 400.0, 300.0], SIZE);
    assert_eq!(place.scale(), 5.0);
    assert_eq!(place.pixel([200.0, 150.0]), [60.0, 40.0]);
    assert_eq!(place.pixel([400.0, 0.0]), [30.0, 0.0]);
    assert_eq!(place.ground([90.0, 80.0]), [0.0, 300.0]);
    let wide = Place::fitting([0.0, 0.0, 100.0, 300.0], SIZE);
    assert_eq!((wide.scale(), wide.pixel([0.0, 300.0])), (2.5, [120.0, 60.0]));
}

#[test]
fn ground_without_photographs_has_the_light_of_its_sun() {
    let map = Briefing::new(&stage(ground()), vec![pose(20.0, 20.0, 0.0)]).unwrap().map(0).unwrap();
    // Albedo 0.5 under a sun of 30 degrees: a quarter of white. Beside the ground it is black.
    assert_eq!((code(&map, [60.0, 20.0]), code(&map, [10.0, 20.0])), ([64; 3], [0; 3]));
}

#[test]
fn north_is_up() {
    let landscape = ground().with_photographs(vec![photograph()].into());
    let map = Briefing::new(&stage(landscape), vec![pose(20.0, 20.0, 3.0)]).unwrap().map(0).unwrap();
    assert_eq!([10.0, 30.0, 50.0, 65.0].map(|line| code(&map, [60.0, line])[0]), [255, 255, 0, 0]);
}

#[test]
fn course_eye_and_rays_stand_where_they_are() {
    // Northward along the middle. Half the field is 45 degrees to each side.
    let course = vec![pose(20.0, 150.0, 0.0), pose(200.0, 150.0, 0.0), pose(380.0, 150.0, 0.0)];
    let briefing = Briefing::new(&stage(ground()), course).unwrap();
    let map = briefing.map(1).unwrap();
    let [flown, ahead, eye] = COLOURS;
    assert_eq!(code(&map, [60.0, 60.0]), flown);
    assert_eq!(code(&map, [60.0, 15.0]), ahead);
    assert_eq!(code(&map, [60.0, 40.0]), eye);
    // Ten pixels along each ray, whose line is narrower than its corners: mostly its colour.
    for column in [70.0, 49.0] {
        let [red, _, blue] = code(&map, [column, 29.0]);
        assert!(blue > 120 && red < 100, "{column}: {red} {blue}");
    }
    assert_eq!(code(&map, [70.0, 51.0]), [64; 3], "no ray leads back");
    assert!(matches!(briefing.map(3), Err(BriefingError::Frame { frame: 3, frames: 3 })));
}

#[test]
fn a_heading_to_the_east_turns_the_rays() {
    let briefing = Briefing::new(&stage(ground()), vec![pose(200.0, 150.0, radians(90.0))]).unwrap();
    let map = briefing.map(0).unwrap();
    let blue = |place: [f64; 2]| code(&map, place)[2] > 120;
    assert!(blue([70.0, 29.0]) && blue([70.0, 50.0]));
    assert!(!blue([49.0, 29.0]) && !blue([49.0, 50.0]));
}

#[test]
fn a_page_has_the_frame_on_the_left() {
    let briefing = Briefing::new(&stage(ground()), vec![pose(200.0, 150.0, 0.0)]).unwrap();
    let frame = |columns| {
        GreyPicture::new(columns, SIZE[1], Depth::Sixteen, vec![65_535; columns * SIZE[1]]).unwrap().into()
    };
    let page = briefing.page(&frame(SIZE[0]), 0).unwrap();
    assert_eq!([page.columns(), page.lines()], [2 * SIZE[0] + GAP, SIZE[1]]);
    assert_eq!(page.pixel(60, 40), [255; 3]);
    assert_eq!(page.pixel(SIZE[0] + GAP + 60, 40), COLOURS[2]);
    assert!(matches!(briefing.page(&frame(60), 0), Err(BriefingError::Picture(_))));
}
