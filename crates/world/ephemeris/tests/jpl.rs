//! Sun and Earth against JPL's DE421, whose package has the Moon's librations.
//!
//! Needs a Python with jplephem and de421: `python3 -m venv V && V/bin/pip install numpy jplephem de421`, then
//! `LUNOID_JPL_PYTHON=V/bin/python cargo test -p ephemeris --test jpl -- --nocapture`. It is skipped loudly without.

use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

use ephemeris::{FIRST, Instant, LAST, MOON_RADIUS, Place, Seen, Sky};
use quantities::{degrees, radians, unit_interval};

/// Places and dates that are compared.
const COUNT: u64 = 50_000;

/// Largest error of a direction (deg) that the docs promise.
const ALLOWED: f64 = 0.02;

/// Number `index` of the dates, even over all years, with a place drawn at random, some of them at the poles.
fn draw(index: u64) -> (Instant, Place) {
    let begin =
        |year: i64| format!("{year}-01-01T00:00:00Z").parse::<Instant>().expect("a year that is measured");
    let length = begin(LAST).since(begin(FIRST)) + 365.0 * 86_400.0;
    let random = |which: u64| unit_interval(0x5011, &[index, which]);
    let instant = begin(FIRST).later(((index as f64 + random(0)) / COUNT as f64 * length).floor());
    let latitude = match index % 10 {
        0 => radians(90.0 - 2.0 * random(1)),
        1 => radians(2.0 * random(1) - 90.0),
        _ => libm::asin(2.0 * random(1) - 1.0),
    };
    let longitude = radians(360.0 * random(2) - 180.0);
    (instant, Place { longitude, latitude, radius: MOON_RADIUS + 10_000.0 * (random(3) - 0.5) })
}

/// What DE421 says of each, one row of numbers; nothing, and a loud line, if there is no Python for it.
fn jpl(asked: &str) -> Option<Vec<Vec<f64>>> {
    let Some(python) = std::env::var_os("LUNOID_JPL_PYTHON") else {
        println!("SKIPPED: LUNOID_JPL_PYTHON does not name a Python with jplephem and de421");
        return None;
    };
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/jpl.py");
    let mut running = Command::new(python)
        .arg(script)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("the Python of LUNOID_JPL_PYTHON starts");
    running.stdin.take().expect("a pipe").write_all(asked.as_bytes()).expect("the script reads all lines");
    let done = running.wait_with_output().expect("the script ends");
    assert!(done.status.success(), "the script says why above");
    let text = String::from_utf8(done.stdout).expect("numbers");
    let row = |line: &str| line.split_whitespace().map(|word| word.parse().expect("a number")).collect();
    Some(text.lines().map(row).collect())
}

fn direction(azimuth: f64, elevation: f64) -> [f64; 3] {
    let level = libm::cos(elevation);
    [level * libm::cos(azimuth), level * libm::sin(azimuth), libm::sin(elevation)]
}

/// Angle between two directions (deg), sharp for small ones too.
fn apart(one: [f64; 2], other: [f64; 2]) -> f64 {
    let (a, b) = (direction(one[0], one[1]), direction(other[0], other[1]));
    let chord = (0..3).map(|k| (a[k] - b[k]) * (a[k] - b[k])).sum::<f64>().sqrt();
    degrees(2.0 * libm::asin(0.5 * chord))
}

#[test]
fn directions_are_those_of_de421() {
    let drawn: Vec<_> = (0..COUNT).map(draw).collect();
    let line = |(instant, place): &(Instant, Place)| {
        format!(
            "{instant} {:.17} {:.17} {:.6}\n",
            degrees(place.longitude),
            degrees(place.latitude),
            place.radius
        )
    };
    let Some(rows) = jpl(&drawn.iter().map(line).collect::<String>()) else { return };
    assert_eq!(rows.len(), drawn.len());
    // Sun, Earth, sub-solar and sub-Earth point: largest angle (deg), sum of squares, where it is largest.
    let mut worst = [
        (0.0, 0.0, String::new()),
        (0.0, 0.0, String::new()),
        (0.0, 0.0, String::new()),
        (0.0, 0.0, String::new()),
    ];
    let mut relative = [0.0_f64; 2];
    let mut lit = 0.0_f64;
    for ((instant, place), row) in drawn.iter().zip(&rows) {
        let sky = Sky::over(*place, *instant);
        let of = |seen: &Seen| [seen.azimuth, seen.elevation];
        let point = |place: &Place| [place.longitude, place.latitude];
        let pair = |at: usize| [radians(row[at]), radians(row[at + 1])];
        let found = [
            apart(of(&sky.sun), pair(0)),
            apart(of(&sky.earth), pair(3)),
            apart(point(&sky.sub_solar), pair(7)),
            apart(point(&sky.sub_earth), pair(9)),
        ];
        for (worst, found) in worst.iter_mut().zip(found) {
            worst.1 += found * found;
            if found > worst.0 {
                (worst.0, worst.2) = (found, instant.to_string());
            }
        }
        relative[0] = relative[0].max((sky.sun.distance / row[2] - 1.0).abs());
        relative[1] = relative[1].max((sky.earth.distance / row[5] - 1.0).abs());
        lit = lit.max((sky.earth_lit - row[6]).abs());
    }
    for (what, (most, squares, when)) in
        ["sun", "earth", "sub-solar point", "sub-earth point"].iter().zip(&worst)
    {
        println!("{what}: at most {most:.4} deg ({when}), rms {:.4} deg", (squares / COUNT as f64).sqrt());
    }
    println!(
        "distances: sun {:.1e}, earth {:.1e} of it; lit share of the earth: {lit:.1e}",
        relative[0], relative[1]
    );
    assert!(worst.iter().all(|(most, ..)| *most < ALLOWED), "{worst:?}");
    assert!(relative[0] < 5e-5 && relative[1] < 2e-4 && lit < 1e-3);
}
