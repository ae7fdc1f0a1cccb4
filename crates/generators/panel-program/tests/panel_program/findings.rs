//! Each finding alone against the repaired program: its sign and its size, as the data sheet tells them.

use glam::DVec3;
use panel_program::{Fill, NO_PANEL, Picture, Posts, Program, Restrictions, Settings, View};
use photo_camera::{Axes, Ellipsoid, Light};
use photograph::{Photograph, Placement};
use picture::{Depth, GreyPicture};

use crate::block::{FRAME, block, camera, lie, observer, photograph, place, usual};

fn draw(posts: &Posts, restrictions: Restrictions, view: &View) -> (Program, Picture) {
    let settings = Settings {
        restrictions,
        fill: Fill::EdgeBuffer,
        outside: 0.0,
        marks_voids: false,
        blends_borders: false,
    };
    let program = Program::new(posts, lie(), usual(), settings).unwrap();
    let picture = program.draw(view).unwrap();
    (program, picture)
}

/// The block from the first observer, with one finding.
fn near(key: Option<&str>) -> (Program, Picture) {
    let restrictions = key.map_or(Restrictions::default(), |key| Restrictions::only(key).unwrap());
    draw(&block(0.0), restrictions, &observer(1))
}

fn drawn(picture: &Picture) -> usize {
    picture.panel.iter().filter(|panel| **panel != NO_PANEL).count()
}

/// Share (percent) of the pixels that either picture draws, and that show another panel.
fn changed(a: &Picture, b: &Picture) -> f64 {
    let either = a.panel.iter().zip(&b.panel).filter(|(a, b)| **a != NO_PANEL || **b != NO_PANEL);
    let (all, other) =
        either.fold((0_usize, 0_usize), |(all, other), (a, b)| (all + 1, other + usize::from(a != b)));
    100.0 * other as f64 / all as f64
}

/// Mean distance of greys over panels (grey levels of 255).
fn greys_apart(a: &Program, b: &Program) -> f64 {
    let pairs = a.panels().iter().zip(b.panels());
    pairs.map(|(a, b)| 255.0 * (a.grey.light - b.grey.light).abs()).sum::<f64>() / a.panels().len() as f64
}

/// The data sheet, whose table of findings these tests fill.
const SHEET: &str = include_str!("../../../../../docs/blocks/panels.md");

/// The row of a key in the sheet tells this size.
fn told(key: &str, size: &str) {
    let row = SHEET.lines().find(|line| line.starts_with(&format!("| `panels.{key}` | finding")));
    let row = row.unwrap_or_else(|| panic!("no row of {key} in the sheet"));
    assert!(row.contains(size), "{key}: {size} is not in: {row}");
}

fn near_to(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance, "{found}, expected {expected}");
}

#[test]
fn repaired_draws_every_panel_before_the_eye_once() {
    let (program, picture) = near(None);
    assert_eq!((picture.counts.panels(), picture.counts.discarded, picture.counts.lost), (176, 0, 0));
    let pixels = program.panels().iter().map(|panel| panel.grey.pixels).min().unwrap();
    assert!(pixels > 200, "{pixels}");
    assert_eq!(drawn(&picture), 9994);
}

#[test]
fn the_quadrant_enlarges_twice() {
    let [repaired, found] = [None, Some("quadrant")].map(|key| drawn(&near(key).1) as f64);
    near_to(found / repaired, 4.0, 0.1);
    told("quadrant", &format!("{:.2} times", found / repaired));
}

#[test]
fn numbers_of_24_bits_move_posts() {
    let posts = |key: Option<&str>| near(key).0.posts_on_screen(&observer(1));
    let apart = posts(None)
        .into_iter()
        .zip(posts(Some("real4")))
        .map(|((a, _), (b, _))| libm::hypot(a[0] - b[0], a[1] - b[1]));
    let most = apart.fold(0.0, f64::max);
    assert!((0.1..1.0).contains(&most), "{most}");
    told("real4", &format!("{most:.2} pixel"));
}

#[test]
fn signed_bytes_cancel() {
    // Pixels of 120 and 136 side by side.
    let codes = (0..512 * 512).map(|pixel| if pixel % 2 == 0 { 120 } else { 136 }).collect();
    let picture = GreyPicture::new(512, 512, Depth::Eight, codes).unwrap();
    let placement = Placement::Camera { camera: camera(FRAME), axes: Axes::Body(Ellipsoid::CLARKE_1866) };
    let photograph = Photograph::new(picture, placement, Light::default()).unwrap();
    let of = |restrictions| {
        let settings = Settings {
            restrictions,
            fill: Fill::Span,
            outside: 0.0,
            marks_voids: false,
            blends_borders: false,
        };
        let program = Program::new(&block(0.0), lie(), &photograph, settings).unwrap();
        program.panels().iter().map(|panel| 255.0 * panel.grey.light).collect::<Vec<f64>>()
    };
    assert!(of(Restrictions::default()).iter().all(|code| (code - 128.0).abs() < 2.0));
    // 120 and -120: a mean of a few pixels more of one of them; -1 shows as 255.
    let signed = of(Restrictions::only("signed_bytes").unwrap());
    let from_0 = signed.iter().map(|code| code.min(256.0 - code)).fold(0.0, f64::max);
    assert!(from_0 < 12.0, "{from_0}");
    told("signed_bytes", &format!("within {from_0:.0} of 0"));
}

#[test]
fn the_box_is_no_triangle() {
    let apart = greys_apart(&near(None).0, &near(Some("box_average")).0);
    assert!((0.1..20.0).contains(&apart), "{apart}");
    told("box_average", &format!("{apart:.2} of 255"));
}

#[test]
fn skewed_axes_turn_the_picture_down() {
    let rows = |key: Option<&str>| {
        let places = near(key).0.posts_on_screen(&observer(1));
        places.iter().map(|(place, _)| place[1]).sum::<f64>() / places.len() as f64
    };
    // 0.1876 degrees between the two verticals, at 2400 pixels of focal length.
    let moved = rows(Some("skewed_axes")) - rows(None);
    assert!((1.0..8.0).contains(&moved), "{moved}");
    told("skewed_axes", &format!("{moved:.1} rows"));
}

#[test]
fn linear_depth_is_too_far_inside_a_panel() {
    let ([_, repaired], [_, found]) = {
        let of = |key| {
            let picture = near(key).1;
            [0.0, mean_distance(&picture)]
        };
        (of(None), of(Some("linear_depth")))
    };
    let apart = found - repaired;
    assert!(apart > 0.0, "linear between corners lies behind the plane: {apart}");
    told("linear_depth", &format!("{apart:.2} m"));
}

/// Mean distance (m) of what is drawn.
fn mean_distance(picture: &Picture) -> f64 {
    let finite = || picture.distance.iter().filter(|distance| distance.is_finite());
    finite().map(|distance| f64::from(*distance)).sum::<f64>() / finite().count() as f64
}

#[test]
fn ground_behind_the_eye_is_mirrored_into_the_sky() {
    // The eye stands north of the posts and looks north.
    let [north, east] = place(150.0, 177.5);
    let view = View { eye: DVec3::new(north, east, 160.0), ..observer(1) };
    let of = |key: Option<&str>| {
        let restrictions = key.map_or(Restrictions::default(), |key| Restrictions::only(key).unwrap());
        drawn(&draw(&block(0.0), restrictions, &view).1)
    };
    assert_eq!(of(None), 0);
    told("mirror_behind", &format!("{} pixels", of(Some("mirror_behind"))));
    assert!(of(Some("mirror_behind")) > 1000);
}

#[test]
fn the_mean_makes_a_cliff_of_a_void() {
    // A slope of 4 m a row with one void in its middle row but one.
    let posts = {
        let mut posts = crate::block::posts(0.0, |row, _| 4.0 * (row - 71) as f64);
        posts.places[6 * 12 + 5].z = f64::NAN;
        posts
    };
    let of = |key: Option<&str>| {
        let restrictions = key.map_or(Restrictions::default(), |key| Restrictions::only(key).unwrap());
        draw(&posts, restrictions, &observer(1))
    };
    let ((repaired, _), (found, picture)) = (of(None), of(Some("mean_void")));
    let place = |program: &Program| program.posts_on_screen(&observer(1))[6 * 12 + 5].0[1];
    // Row 6 has 24 m; the mean of the known posts is 15.9 m, cut to 15.
    let lower = place(&found) - place(&repaired);
    told("mean_void", &format!("{lower:.1} rows"));
    assert!((3.0..9.0).contains(&lower), "9 m lower at 2.9 km, 2400 pixels of focal length: {lower}");
    assert_eq!(found.panels().iter().filter(|panel| panel.touches_void).count(), 6);
    assert!(drawn(&picture) > 0);
}

#[test]
fn panels_at_the_border_are_lost() {
    let (_, repaired) = near(None);
    let (_, found) = near(Some("discard_partial"));
    assert_eq!(repaired.counts.discarded, 0);
    let lost = drawn(&repaired) - drawn(&found);
    assert!(found.counts.discarded > 0 && lost > 0);
    told("discard_partial", &format!("{} panels, {lost} pixels", found.counts.discarded));
    // What is drawn is drawn alike.
    let kept = found.panel.iter().zip(&repaired.panel).filter(|(panel, _)| **panel != NO_PANEL);
    assert!(kept.clone().count() > 0 && kept.filter(|(a, b)| a != b).count() * 200 < drawn(&found));
}

#[test]
fn both_ends_draw_borders_twice() {
    let (_, repaired) = near(None);
    let (_, found) = near(Some("both_ends"));
    let per_pixel = |picture: &Picture| picture.work.found as f64 / drawn(picture) as f64;
    let more = per_pixel(&found) / per_pixel(&repaired);
    assert!(more > 1.05, "{more}");
    told("both_ends", &format!("{more:.2} times"));
    told("both_ends", &format!("{:.0} %", changed(&repaired, &found)));
}

#[test]
fn figure_3_9_comes_back_when_the_block_moves_30_seconds_north() {
    // The least shift in whole seconds at which observer 3 sees the whole top of the upper block while panels are lost at the border.
    let of = |shift: u32, photograph: &Photograph, limits: bool| {
        let restrictions = Restrictions { limits, ..Restrictions::as_written() };
        let settings = Settings {
            restrictions,
            fill: Fill::EdgeBuffer,
            outside: 0.0,
            marks_voids: false,
            blends_borders: false,
        };
        let program = Program::new(&block(f64::from(shift)), lie(), photograph, settings).unwrap();
        let picture = program.draw(&observer(3)).unwrap();
        let is_top = |number: usize| (3..5).contains(&(number / 22)) && (4..7).contains(&(number % 22 / 2));
        let top = (0..176).filter(|number| is_top(*number));
        let seen = top.filter(|number| picture.panel.contains(&(*number as u32))).count();
        (seen, picture.counts)
    };
    // Where panels fall does not depend on their greys.
    let all: Vec<_> = (0..60).map(|shift| of(shift, usual(), false)).collect();
    let first = all.iter().position(|(_, counts)| counts.filled > 0);
    let whole = all.iter().position(|(seen, counts)| *seen == 12 && counts.discarded > 0);
    assert_eq!((first, whole), (Some(3), Some(30)));
    assert_eq!([all[30].1.filled, all[30].1.discarded], [109, 67]);
    let shift = 30.0_f64;
    let moved = photograph([FRAME[0], FRAME[1] + (29.55 * shift).round()], shift);
    assert_eq!(of(30, &moved, true), all[30], "one frame of photograph holds it");
}
