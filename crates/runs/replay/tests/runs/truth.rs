//! Ground truth beside a run: what `exact` says, whole or resumed.

use std::collections::BTreeMap;
use std::fs;
use std::ops::Range;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use files::{Npy, NpyData};
use generator::{Generator, Label, PlaneKind, Planes};
use landscape::parabolic_drop;
use picture::Depth;
use replay::{Control, Phases, Pictures, Progress, ReplayError, RunFolder, TruthOutcome, run, write_truth};
use scenario::{PixelRule, PoseRow, PoseTable, Scenario};
use serde_json::Value;
use signal::Probe;
use tempfile::tempdir;

use crate::stage::{SCENARIO, job, stage};

struct Wish {
    frames: Range<u64>,
    items: &'static str,
    scenario: String,
    fresh: bool,
    /// Cancel when this many frames have their truth.
    cancel_after: Option<u64>,
}

impl Default for Wish {
    fn default() -> Self {
        // Heading and pitch change over its hills, and some pixels are sky.
        let scenario = SCENARIO.replace("sweeps = 40", "sweeps = 24");
        let scenario = scenario.replace("samples_per_sweep = 80", "samples_per_sweep = 40");
        Self { frames: 0..6, items: "all", scenario, fresh: false, cancel_after: None }
    }
}

impl Wish {
    fn scenario(&self) -> Scenario {
        Scenario::parse("truth.toml", &self.scenario).expect("the scenario is right")
    }

    fn write(&self, out: &Path) -> Result<TruthOutcome, ReplayError> {
        let scenario = self.scenario();
        let pictures = Pictures { depth: Depth::Eight, colour: false, refresh: false, film: false };
        let job = job(&scenario, self.frames.clone(), pictures);
        let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build().expect("threads");
        let cancel = AtomicBool::new(false);
        let is_truth = AtomicBool::new(false);
        let progress = |progress| match progress {
            Progress::Begins { what, kept, .. } => {
                is_truth.store(what == "truth", Ordering::Relaxed);
                cancel.fetch_or(what == "truth" && self.cancel_after == Some(kept), Ordering::Relaxed);
            }
            Progress::Frame { done } if is_truth.load(Ordering::Relaxed) => {
                cancel.fetch_or(self.cancel_after == Some(done), Ordering::Relaxed);
            }
            _ => {}
        };
        let control = Control { pool: &pool, cancel: &cancel, progress: &progress };
        let folder = RunFolder::claim(out, self.fresh)?;
        run(&job, &folder, &control, &mut Phases::since(Instant::now()))?;
        write_truth(&job, &self.items.parse().expect("a list"), &folder, &control)
    }

    /// Poses and planes from `exact` itself.
    fn asked_directly(&self, kinds: &[PlaneKind]) -> Vec<(PoseRow, Planes)> {
        let scenario = self.scenario();
        let mut stage = stage(&scenario);
        stage.settings.laws.pixel_rule = PixelRule::Centre;
        let (raster, update) = (stage.settings.raster, stage.settings.timebase.update);
        let (yoke, frames) = (stage.settings.yoke, self.frames.clone());
        let table = PoseTable::resolve(&scenario, &stage.landscape, update, yoke, frames).expect("poses");
        let session = exact::Exact.prepare(stage.stage()).expect("a session");
        let draw = |row: &PoseRow| {
            let mut planes = Planes::new(raster.columns as usize, raster.lines as usize, kinds);
            session.frame(row.frame, &row.pose, &mut planes, &mut Probe::off()).expect("a frame");
            (*row, planes)
        };
        table.rows().iter().map(draw).collect()
    }
}

fn done(frames: u64, made: u64) -> TruthOutcome {
    TruthOutcome { frames, done: frames, made }
}

/// Every file of the truth.
fn content(out: &Path) -> BTreeMap<String, Vec<u8>> {
    let entries = fs::read_dir(out.join("truth")).expect("a folder").map(|entry| entry.expect("an entry"));
    let read = |entry: fs::DirEntry| {
        (entry.file_name().to_string_lossy().into_owned(), fs::read(entry.path()).expect("a file"))
    };
    entries.map(read).collect()
}

/// The arrays of an NPZ file without compression, found by their magic bytes and by the names before them.
fn arrays(bytes: &[u8]) -> BTreeMap<String, Npy> {
    let starts: Vec<usize> = (0..bytes.len()).filter(|at| bytes[*at..].starts_with(b"PK\x03\x04")).collect();
    let number =
        |at: usize, size: usize| bytes[at..at + size].iter().rev().fold(0, |n, b| n << 8 | usize::from(*b));
    let entry = |start: &usize| {
        let (size, name, extra) = (number(start + 18, 4), number(start + 26, 2), number(start + 28, 2));
        let text = String::from_utf8_lossy(&bytes[start + 30..start + 30 + name]).into_owned();
        let data = start + 30 + name + extra;
        let array = Npy::parse(&bytes[data..data + size]).expect("an array");
        (text.trim_end_matches(".npy").to_owned(), array)
    };
    starts.iter().map(entry).collect()
}

fn document(out: &Path, name: &str) -> Value {
    serde_json::from_slice(&content(out)[name]).expect("JSON")
}

#[test]
fn every_array_is_what_exact_says() {
    let at = tempdir().unwrap();
    let wish = Wish { frames: 1..3, ..Wish::default() };
    assert_eq!(wish.write(at.path()).unwrap(), done(2, 2));
    let record = document(at.path(), "truth.json");
    for (row, planes) in wish.asked_directly(&PlaneKind::ALL) {
        let held = arrays(&content(at.path())[&format!("frame-{:06}.npz", row.frame)]);
        let names: Vec<&str> = held.keys().map(String::as_str).collect();
        assert_eq!(names, ["distance", "height", "label", "normal", "range", "reflectivity", "shadow"]);
        let plane = |kind| planes.get(kind).unwrap().to_vec();
        for (name, kind) in [
            ("range", PlaneKind::Range),
            ("height", PlaneKind::Height),
            ("reflectivity", PlaneKind::Reflectivity),
            ("distance", PlaneKind::Distance),
        ] {
            assert_eq!(held[name].data(), &NpyData::F32(plane(kind)), "{name}");
        }
        for (name, kind) in [("shadow", PlaneKind::Shadow), ("label", PlaneKind::Label)] {
            let codes: Vec<u8> = plane(kind).iter().map(|code| *code as u8).collect();
            assert_eq!(held[name].data(), &NpyData::U8(codes), "{name}");
        }
        let normal = [PlaneKind::NormalNorth, PlaneKind::NormalEast, PlaneKind::NormalUp].map(plane);
        let normal: Vec<f32> =
            (0..normal[0].len()).flat_map(|at| [normal[0][at], normal[1][at], normal[2][at]]).collect();
        assert_eq!(held["normal"].data(), &NpyData::F32(normal));
        for about in record["planes"].as_array().unwrap().iter().filter(|about| about["shape"].is_array()) {
            let array = &held[about["name"].as_str().unwrap()];
            assert_eq!(about["shape"], serde_json::json!(array.shape()), "{about}");
        }
        assert!(plane(PlaneKind::Range).iter().any(|range| range.is_infinite()));
        assert!(plane(PlaneKind::Range).iter().any(|range| range.is_finite()));
    }
}

/// As `docs/truth-format.md` has it: pixel, range and pose lead to a point (north, east, height; m), one a pixel of
/// frame after frame, with the frame, and the label of what is there; the sky has none.
fn points(out: &Path) -> Vec<(u64, u8, [f64; 3])> {
    let poses = document(out, "poses.json");
    let numbers = |value: &Value| -> Vec<f64> {
        value.as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect()
    };
    let half = numbers(&poses["camera"]["tan_half_field"]);
    let mut found = Vec::new();
    for frame in poses["frames"].as_array().unwrap() {
        let number = frame["frame"].as_u64().unwrap();
        let held = arrays(&content(out)[&format!("frame-{number:06}.npz")]);
        let [lines, columns] = *held["range"].shape() else { panic!("two dimensions") };
        let eye = numbers(&frame["eye_m"]);
        let rotation: Vec<Vec<f64>> = frame["rotation"].as_array().unwrap().iter().map(numbers).collect();
        let labels = held["label"].data().to_f64();
        for (index, range) in held["range"].data().to_f64().into_iter().enumerate() {
            if range.is_infinite() {
                continue;
            }
            let (line, column) = ((index / columns) as f64, (index % columns) as f64);
            let x = half[0] * (2.0 * column + 1.0 - columns as f64) / columns as f64;
            let y = half[1] * (2.0 * line + 1.0 - lines as f64) / lines as f64;
            let d: Vec<f64> = rotation.iter().map(|row| row[0] + row[1] * x + row[2] * y).collect();
            let over = (d[0] * d[0] + d[1] * d[1]).sqrt();
            let height = eye[2] - range * d[2] / over + parabolic_drop(range);
            let point = [eye[0] + range * d[0] / over, eye[1] + range * d[1] / over, height];
            found.push((number, labels[index] as u8, point));
        }
    }
    found
}

#[test]
fn a_pixel_leads_back_to_the_ground() {
    let at = tempdir().unwrap();
    let wish = Wish { items: "range,label,pose", ..Wish::default() };
    wish.write(at.path()).unwrap();
    let ground = stage(&wish.scenario()).landscape;
    let off = |[x, y, height]: [f64; 3]| (height - ground.height(x, y).expect("on the ground")).abs();
    let worst = points(at.path()).into_iter().map(|(_, _, point)| off(point)).fold(0.0, f64::max);
    assert!(worst > 0.0 && worst < 1e-3, "{worst}");
}

/// Held against the direction of the pixel's ray alone: ground range over the cosine of its elevation.
#[test]
fn distance_is_range_along_the_ray() {
    let at = tempdir().unwrap();
    let scenario = format!("{}{DRESSED}", Wish::default().scenario);
    let wish = Wish { items: "range,pose,distance", frames: 2..4, scenario, ..Wish::default() };
    wish.write(at.path()).unwrap();
    let poses = document(at.path(), "poses.json");
    let (mut worst, mut seen) = (0.0_f64, 0);
    for frame in poses["frames"].as_array().unwrap() {
        let held = arrays(&content(at.path())[&format!("frame-{:06}.npz", frame["frame"].as_u64().unwrap())]);
        let (ranges, distances) = (held["range"].data().to_f64(), held["distance"].data().to_f64());
        for (index, (range, distance)) in ranges.into_iter().zip(distances).enumerate() {
            let columns = held["range"].shape()[1];
            let pixel = Pixel { line: (index / columns) as f64, column: (index % columns) as f64 };
            if range.is_infinite() {
                assert!(distance.is_infinite());
                continue;
            }
            let [north, east, down] = pixel.ray(&poses, frame, held["range"].shape());
            let cosine = libm::hypot(north, east) / libm::hypot(libm::hypot(north, east), down);
            (worst, seen) = (worst.max((distance * cosine / range - 1.0).abs()), seen + 1);
        }
    }
    assert!(seen > 300 && worst < 1e-4, "{seen} {worst}");
}

/// Craters, a lander beside the way, and a camera that rolls with the slope.
const DRESSED: &str = r#"
[[features.population]]
seed = 1
kind = "fresh"
density_per_m2 = 0.02
smallest_radius_m = 1
largest_radius_m = 15
area_m = [90, 170, 180, 240]

[[object]]
id = "lm"
model = "lander"
x_m = 118
y_m = 204

[shadows]

[roll]
display = "yoke"
"#;

#[test]
fn a_pixel_of_a_full_scene_leads_back_to_what_its_label_says() {
    let at = tempdir().unwrap();
    let scenario = format!("{}{DRESSED}", Wish::default().scenario);
    let wish = Wish { items: "range,label,pose", frames: 2..4, scenario, ..Wish::default() };
    wish.write(at.path()).unwrap();
    let stage = stage(&wish.scenario());
    let poses = document(at.path(), "poses.json");
    let mut pixels = [0; 7];
    for (frame, label, [x, y, height]) in points(at.path()) {
        let label = Label::of_code(label).expect("a label");
        pixels[usize::from(label.code())] += 1;
        let at = glam::DVec3::new(x, y, height);
        if matches!(label, Label::Rock | Label::Culture) {
            let time = poses["frames"][(frame - 2) as usize]["time_s"].as_f64().unwrap();
            let outside = |body: &solids::Body| {
                let faces = body.normals().enumerate();
                faces.map(|(face, normal)| normal.dot(at - body.on_face(face))).fold(f64::MIN, f64::max)
            };
            let nearest = stage.scenery.bodies(time).map(outside).min_by(|a, b| a.abs().total_cmp(&b.abs()));
            assert!(nearest.is_some_and(|distance| distance.abs() < 1e-3), "{label:?}: {nearest:?}");
        } else {
            let ground = stage.landscape.height(x, y).expect("on the ground");
            assert!((height - ground).abs() < 1e-3, "{label:?}: {height}, {ground}");
        }
    }
    println!("{pixels:?}");
    let count = |label: Label| pixels[usize::from(label.code())];
    assert!(
        count(Label::Terrain) > 200 && count(Label::Feature) > 50 && count(Label::Culture) > 20,
        "{pixels:?}"
    );
}

/// The numbers of the worked example in `docs/truth-format.md`.
#[test]
fn the_example_of_the_page() {
    let at = tempdir().unwrap();
    let wish = Wish { frames: 0..1, items: "range,pose", ..Wish::default() };
    wish.write(at.path()).unwrap();
    let page = include_str!("../../../../../docs/truth-format.md");
    let poses = document(at.path(), "poses.json");
    let range = &arrays(&content(at.path())["frame-000000.npz"])["range"];
    let columns = range.shape()[1];
    let found = range.data().to_f64()[10 * columns + 20];
    let point = EXAMPLE.point(&poses, found, range.shape());
    let line = format!(
        "range[10, 20] = {found:.3}, eye_m = [{:.3}, {:.3}, {:.3}]: x = {:.3}, y = {:.3}, height = {:.3}",
        poses["frames"][0]["eye_m"][0].as_f64().unwrap(),
        poses["frames"][0]["eye_m"][1].as_f64().unwrap(),
        poses["frames"][0]["eye_m"][2].as_f64().unwrap(),
        point[0],
        point[1],
        point[2]
    );
    assert!(page.contains(&line), "the page should have: {line}");
}

/// A pixel by line and column, from the top left.
struct Pixel {
    line: f64,
    column: f64,
}

const EXAMPLE: Pixel = Pixel { line: 10.0, column: 20.0 };

impl Pixel {
    /// Direction of its ray: north, east, down.
    fn ray(&self, poses: &Value, frame: &Value, shape: &[usize]) -> [f64; 3] {
        let number = |value: &Value| value.as_f64().unwrap();
        let half = |axis: usize| number(&poses["camera"]["tan_half_field"][axis]);
        let (lines, columns) = (shape[0] as f64, shape[1] as f64);
        let ray = [
            1.0,
            half(0) * (2.0 * self.column + 1.0 - columns) / columns,
            half(1) * (2.0 * self.line + 1.0 - lines) / lines,
        ];
        let row = |i: usize| (0..3).map(|j| number(&frame["rotation"][i][j]) * ray[j]).sum::<f64>();
        [row(0), row(1), row(2)]
    }

    /// The recipe of the page, for frame 0.
    fn point(&self, poses: &Value, range: f64, shape: &[usize]) -> [f64; 3] {
        let frame = &poses["frames"][0];
        let number = |value: &Value| value.as_f64().unwrap();
        let d = self.ray(poses, frame, shape);
        let over = (d[0] * d[0] + d[1] * d[1]).sqrt();
        let eye: [f64; 3] = std::array::from_fn(|axis| number(&frame["eye_m"][axis]));
        let height = eye[2] - range * d[2] / over + range * range / (2.0 * 1_737_400.0);
        [eye[0] + range * d[0] / over, eye[1] + range * d[1] / over, height]
    }
}

#[test]
fn a_resumed_truth_is_the_uninterrupted_one() {
    let at = tempdir().unwrap();
    let (whole, again) = (at.path().join("whole"), at.path().join("again"));
    assert_eq!(Wish::default().write(&whole).unwrap(), done(6, 6));
    Wish::default().write(&again).unwrap();
    assert_eq!(content(&whole), content(&again), "two runs");
    for after in [0, 1, 4] {
        let out = at.path().join(format!("cut-{after}"));
        let cut = Wish { cancel_after: Some(after), ..Wish::default() }.write(&out).unwrap();
        assert_eq!(cut, TruthOutcome { frames: 6, done: after, made: after });
        assert!(!out.join("truth/truth.json").exists());
        // As after kill -9: half a file, and one that the journal does not know.
        fs::write(out.join("truth/.frame-000005.npz.77-1.tmp"), "half").unwrap();
        for name in ["truth/frame-000005.npz", "truth/frame-000050.npz"] {
            fs::copy(whole.join("truth/frame-000002.npz"), out.join(name)).unwrap();
        }
        assert_eq!(Wish::default().write(&out).unwrap(), done(6, 6 - after));
        assert_eq!(content(&whole), content(&out));
    }
}

#[test]
fn missing_and_damaged_truth_is_made_again() {
    let at = tempdir().unwrap();
    Wish::default().write(at.path()).unwrap();
    let before = content(at.path());
    fs::remove_file(at.path().join("truth/frame-000002.npz")).unwrap();
    let mut bytes = before["frame-000004.npz"].clone();
    bytes[700] ^= 1;
    fs::write(at.path().join("truth/frame-000004.npz"), bytes).unwrap();
    fs::write(at.path().join("truth/poses.csv"), "").unwrap();
    assert_eq!(Wish::default().write(at.path()).unwrap(), done(6, 2));
    assert_eq!(content(at.path()), before);
    assert_eq!(Wish::default().write(at.path()).unwrap(), done(6, 0));
}

#[test]
fn frames_asked_for_join_those_that_have_it() {
    let at = tempdir().unwrap();
    let some = |frames: Range<u64>| Wish { frames, items: "label,pose", ..Wish::default() };
    assert_eq!(some(0..2).write(at.path()).unwrap(), done(2, 2));
    assert_eq!(some(1..4).write(at.path()).unwrap(), done(4, 2));
    let csv = String::from_utf8(content(at.path())["poses.csv"].clone()).unwrap();
    assert_eq!(csv.lines().count(), 5);
    let columns = csv.lines().map(|line| line.split(',').count()).collect::<Vec<_>>();
    assert_eq!(columns, [23; 5]);
}

#[test]
fn truth_of_other_kinds_is_refused() {
    let at = tempdir().unwrap();
    let label = Wish { items: "label", ..Wish::default() };
    label.write(at.path()).unwrap();
    let before = content(at.path());
    let refused = Wish { items: "label,range", ..Wish::default() }.write(at.path());
    assert!(
        matches!(&refused, Err(ReplayError::OtherTruth { asked, .. }) if asked == "range,label"),
        "{refused:?}"
    );
    assert_eq!(content(at.path()), before);
    fs::write(at.path().join("truth/truth.json"), "{").unwrap();
    assert!(matches!(label.write(at.path()), Err(ReplayError::TruthRecord { .. })));
}

#[test]
fn poses_alone_draw_nothing() {
    let at = tempdir().unwrap();
    Wish { items: "pose", ..Wish::default() }.write(at.path()).unwrap();
    assert_eq!(content(at.path()).into_keys().collect::<Vec<_>>(), ["poses.csv", "poses.json", "truth.json"]);
}

#[test]
fn a_fresh_run_takes_the_truth_with_it_and_nothing_else() {
    let at = tempdir().unwrap();
    Wish::default().write(at.path()).unwrap();
    fs::write(at.path().join("truth/notes.txt"), "mine").unwrap();
    let other = Wish { fresh: true, frames: 0..1, items: "pose", ..Wish::default() };
    other.write(at.path()).unwrap();
    let names: Vec<String> = content(at.path()).into_keys().collect();
    assert_eq!(names, ["notes.txt", "poses.csv", "poses.json", "truth.json"]);
}

#[test]
fn truth_needs_a_finished_run() {
    let at = tempdir().unwrap();
    let mut wish = Wish { frames: 0..2, ..Wish::default() };
    wish.write(at.path()).unwrap();
    wish.scenario = wish.scenario.replace("elevation_deg = 15", "elevation_deg = 16");
    assert!(matches!(wish.write(at.path()), Err(ReplayError::OtherRun { .. })));
}
