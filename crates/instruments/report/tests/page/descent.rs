//! The page of a descent in a real browser, from a file.

use std::sync::MutexGuard;
use std::thread::sleep;
use std::time::{Duration, Instant};

use picture::{Depth, GreyPicture, encode_png};
use report::{DescentPage, DescentPicture, DescentPlace, DescentShot, DescentWay, place_pixels};
use tempfile::TempDir;
use timing::LevelChange;

use crate::browser::quiet;
use crate::webdriver::{Browser, turn};

const RIGHT: &str = "\u{e014}";
const RASTER: [usize; 2] = [96, 48];

/// Ground of a metre a pixel: a pixel lies as far east as its column, and as far south as its line. Its upper quarter is sky.
fn place(column: usize, line: usize) -> Option<DescentPlace> {
    let map = [1000.0 - line as f64, column as f64];
    (line >= 12).then_some(DescentPlace { map, degrees: Some([3.0 + column as f64 * 1e-3, 26.0]) })
}

fn picture(grey: u16) -> DescentPicture {
    let picture =
        GreyPicture::new(RASTER[0], RASTER[1], Depth::Eight, vec![grey; RASTER[0] * RASTER[1]]).unwrap();
    let [columns, lines] = place_pixels(RASTER);
    let places = lines.iter().flat_map(|line| columns.iter().map(move |column| place(*column, *line)));
    DescentPicture { png: encode_png(&picture, &[]).unwrap(), places: places.collect() }
}

/// Frames 10 to 110, whose first way jumps in frame 60 where two tiles take another level; three frames have pictures.
fn page() -> DescentPage {
    let change = |tile: &str, west: f64| LevelChange {
        tile: tile.into(),
        from: 1,
        to: 0,
        distance_m: 445.5,
        fraction: 0.5,
        borders_m: [960.0, west, 980.0, west + 20.0],
    };
    let shot = |frame: u64, changes: Vec<LevelChange>| {
        let grey = (frame % 100) as u16;
        DescentShot { frame, changes, pictures: vec![picture(grey), picture(grey + 100)] }
    };
    let way = |name: &str, pop: f64| DescentWay {
        name: name.into(),
        off: (0..101).map(|index| f64::from(index) / 100.0).collect(),
        pops: (0..101).map(|index| if index == 50 { pop } else { 0.0 }).collect(),
    };
    DescentPage {
        title: "Down".into(),
        facts: "frames 10..111".into(),
        raster: RASTER,
        first: 10,
        times: (0..101).map(|index| f64::from(index) / 10.0).collect(),
        ways: vec![way("switching", 0.59), way("morphing", 1e-13)],
        shots: vec![
            shot(10, vec![]),
            shot(60, vec![change("tile.3.7", 20.0), change("tile.4.7", 40.0)]),
            shot(110, vec![]),
        ],
    }
}

fn shown() -> Option<(TempDir, Browser, MutexGuard<'static, ()>)> {
    let turn = turn();
    let browser = Browser::open([1000, 1400], false)?;
    let folder = tempfile::tempdir().unwrap();
    let path = page().leave(folder.path()).unwrap();
    browser.go(&format!("file://{}", path.display()));
    Some((folder, browser, turn))
}

/// Waits until an expression has a value: pictures and places come from files beside the page.
fn until(browser: &Browser, expression: &str, expected: &serde_json::Value) {
    let end = Instant::now() + Duration::from_secs(20);
    while &browser.value(expression) != expected && Instant::now() < end {
        sleep(Duration::from_millis(20));
    }
    assert_eq!(&browser.value(expression), expected, "{expression}");
}

#[test]
fn a_jump_leads_to_its_tiles_and_the_ground_to_its_place() {
    let Some((_folder, browser, _turn)) = shown() else { return };
    // It opens at the largest jump.
    assert!(browser.text("now").starts_with("frame 60, 5.00 s, picture 2 of 3"), "{}", browser.text("now"));
    assert_eq!(
        browser.text("changed"),
        "tile.3.7: level 1 to 0, 445.5 m away\ntile.4.7: level 1 to 0, 445.5 m away"
    );
    let told = browser.value("document.querySelector('[data-told=switching]').textContent");
    assert_eq!(told, "0.500 m off the finest ground; pops by 0.590 m");
    assert_eq!(browser.value("document.querySelectorAll('.jumps button').length"), 1);
    browser.click("canvas[data-way=morphing]", [0.5, 0.75]);
    let expected = "964.00 m north, 48.00 m east (pixel 48, 36 of morphing)\n\
                    lunoid terrain add FILE --id mine --crater 3.0480000,26.0000000,RADIUS_M --wall-percent 4 --depth-percent 20";
    until(&browser, "document.getElementById('place').textContent", &expected.into());
    browser.click("canvas[data-way=switching]", [0.5, 0.1]);
    until(&browser, "document.getElementById('place').textContent", &"No ground there.".into());
    // A place belongs to its picture.
    browser.click("#after", [0.5, 0.5]);
    until(
        &browser,
        "document.getElementById('place').textContent",
        &"Click on the ground for its place.".into(),
    );
    quiet(&browser);
}

#[test]
fn curves_and_keys_go_from_picture_to_picture() {
    let Some((_folder, browser, _turn)) = shown() else { return };
    let frame = || browser.text("now").split(',').next().unwrap().to_owned();
    // A click at the right end of the curves is nearest to the last picture.
    browser.click("#curves", [0.97, 0.3]);
    assert_eq!((frame().as_str(), browser.text("changed").as_str()), ("frame 110", "None in this frame."));
    browser.click("#curves", [0.1, 0.3]);
    assert_eq!(frame(), "frame 10");
    browser.press(RIGHT);
    assert_eq!(frame(), "frame 60");
    browser.click("#after", [0.5, 0.5]);
    assert_eq!(frame(), "frame 110");
    browser.click(".jumps button", [0.5, 0.5]);
    assert_eq!(frame(), "frame 60");
    assert_eq!(browser.value("document.querySelector('.jumps button').getAttribute('aria-pressed')"), "true");
}
