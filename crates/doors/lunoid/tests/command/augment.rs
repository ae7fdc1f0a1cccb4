//! `augment`: the shadow in the pictures of a run, what is told of it, what is refused.

use std::fs;

use serde_json::Value;

use crate::scene::Scene;

/// The pictures of `tiny.toml`: the rover drives at 32 degrees, so a sun at 212 stands behind it.
fn run() -> Scene {
    let scene = Scene::new();
    scene.expect(0, &["replay", "tiny.toml", "-q", "--frames", "0..2", "--out", "run"]);
    scene
}

const PICTURES: [&str; 4] = ["augment", "run/frames", "run/poses.csv", "--vehicle"];

fn augment(scene: &Scene, code: i32, rest: &[&str]) -> (String, String) {
    scene.expect(code, &[&PICTURES[..], rest].concat())
}

#[test]
fn the_shadow_of_a_run_is_put_in_and_told() {
    let scene = run();
    let (out, _) = augment(&scene, 0, &["rover", "--sun", "212,6", "--out", "new", "--json"]);
    let record: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(fs::read_to_string(scene.join("new/augment.json")).unwrap(), out);
    assert_eq!(scene.list("new"), ["augment.json", "frame-000000.png", "frame-000001.png"]);
    assert_eq!(record["schema"], "lunoid.augment/1");
    assert_eq!(record["camera"]["roll_drawn"], false);
    assert_eq!(record["timing"]["picture_period_s"], 0.1);
    let frame = &record["frames"][1];
    let number = |key: &str| frame[key].as_f64().unwrap();
    assert!(number("dark") > 0.01 && number("dark") < 0.5, "{frame}");
    assert_eq!(number("points"), record["vehicle"]["points"].as_f64().unwrap());
    let expected = 90e-6 * number("points") + 25e-6 * number("intersections");
    assert!((number("setup_s") - expected).abs() < 1e-9);
    let pixels = |name: &str| fs::read(scene.join(name)).unwrap();
    assert_ne!(pixels("new/frame-000001.png"), pixels("run/frames/frame-000001.png"));
    // True ground has the sun of the scenario, which stands beside the rover, unless another is asked for.
    let ground = ["rover", "--ground", "tiny.toml", "--json", "--out"];
    let (beside, _) = augment(&scene, 0, &[&ground[..], &["beside"]].concat());
    let (behind, _) = augment(&scene, 0, &[&ground[..], &["behind", "--sun", "212,6"]].concat());
    let [beside, behind]: [Value; 2] = [beside, behind].map(|out| serde_json::from_str(&out).unwrap());
    assert!(beside["frames"][1]["dark"].as_f64().unwrap() < 0.5 * number("dark"));
    let dark = behind["frames"][1]["dark"].as_f64().unwrap();
    assert!((dark / number("dark") - 1.0).abs() < 0.4, "{dark} for {}", number("dark"));
    assert!(beside["sun_deg"].is_null() && behind["ground"] == "tiny.toml");
}

#[test]
fn pictures_that_are_there_stay() {
    let scene = run();
    let (whole, _) = augment(&scene, 0, &["rover", "--sun", "212,6", "--out", "new", "--json"]);
    let picture = |frame: u32| scene.join(&format!("new/frame-{frame:06}.png"));
    let made = |frame: u32| fs::metadata(picture(frame)).unwrap().modified().unwrap();
    let (bytes, first) = (fs::read(picture(1)).unwrap(), made(0));
    // As a run leaves it that was killed between its pictures, and one of them damaged since.
    fs::remove_file(scene.join("new/augment.json")).unwrap();
    fs::write(picture(1), &bytes[..bytes.len() - 30]).unwrap();
    let (again, _) = augment(&scene, 0, &["rover", "--sun", "212,6", "--out", "new", "--json"]);
    assert_eq!((again, fs::read(picture(1)).unwrap()), (whole, bytes.clone()));
    assert_eq!(made(0), first, "it was not made again");
    // Under another sun all are, in place of the earlier ones only where that is asked for.
    let (_, err) = augment(&scene, 4, &["rover", "--sun", "213,6", "--out", "new"]);
    assert!(err.contains("sun_deg.0 (212.0 there, 213.0 now)"), "{err}");
    augment(&scene, 0, &["rover", "--sun", "213,6", "--out", "new", "--fresh"]);
    assert_ne!(fs::read(picture(1)).unwrap(), bytes);
    assert_ne!(made(0), first);
}

/// The format and the comparison are those of `lunoid timing`.
#[test]
fn timing_is_held_to_a_baseline() {
    let scene = run();
    let rover = ["rover", "--out", "new", "--sun"];
    let with = |code, rest: &[&str]| augment(&scene, code, &[&rover[..], rest].concat());
    with(0, &["212,6", "--timing", "timing.json"]);
    let record: Value = serde_json::from_slice(&fs::read(scene.join("timing.json")).unwrap()).unwrap();
    let frame = &record["frames"][1];
    let told: Value = serde_json::from_slice(&fs::read(scene.join("new/augment.json")).unwrap()).unwrap();
    let told = &told["frames"][1];
    assert_eq!(frame["units"][0]["busy"], (1e6 * told["setup_s"].as_f64().unwrap()).round() as u64);
    assert_eq!((&frame["events"], &frame["events_blake3"]), (&told["events"], &told["events_blake3"]));
    assert!(frame["events"].as_u64().unwrap() > 20, "{frame}");
    // From kept pictures as from new ones.
    let (out, _) = with(0, &["212,6", "--baseline", "timing.json", "--json"]);
    let out: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(out["timing_check"]["met"], true, "{out}");
    // Other gear, another sun: of another run.
    let (out, _) = with(1, &["212,6", "--baseline", "timing.json", "--dac-bits", "6", "--fresh"]);
    assert!(out.contains("events"), "{out}");
    let (out, _) = with(1, &["212,7", "--baseline", "timing.json", "--fresh"]);
    assert!(out.contains("inputs"), "{out}");
    scene.write("half.json", "{");
    let (_, err) = with(3, &["212,6", "--baseline", "half.json"]);
    assert!(err.contains("half.json:1:") && err.contains("expected a timing record"), "{err}");
}

/// A line of the picture stands for a sweep: the same formats and records as those of `lunoid probe`.
#[test]
fn lines_of_a_picture_are_probed() {
    let scene = run();
    let rover = ["rover", "--sun", "212,6", "--out", "new", "--probe"];
    let probe = |code, rest: &[&str]| augment(&scene, code, &[&rover[..], rest].concat());
    let (out, _) = probe(0, &["1:20..22:vs.video.*,vs.dark", "--waveforms", "lines.csv"]);
    assert!(out.contains("lines.csv: frame 1, lines 20..22: vs.video.in, vs.dark, vs.video.out\n"), "{out}");
    let text = fs::read_to_string(scene.join("lines.csv")).unwrap();
    let [old, new] = ["run/frames", "new"].map(|folder| Picture::read(&scene, folder));
    assert_eq!(text.lines().count(), 1 + 2 * old.columns);
    let mut lines = text.lines();
    let heading = "frame,sweep,index,time [s],vs.video.in [1],vs.dark [1],vs.video.out [1]";
    assert_eq!(lines.next(), Some(heading));
    let mut dark = 0.0;
    for (index, row) in lines.enumerate() {
        let cells: Vec<f64> = row.split(',').map(|cell| cell.parse().unwrap()).collect();
        let (line, column) = (20 + index / old.columns, index % old.columns);
        assert_eq!((cells[1], cells[2]), (line as f64, column as f64));
        let [before, after] =
            [&old, &new].map(|picture| f64::from(picture.codes[line * old.columns + column]));
        assert_eq!((cells[4], (cells[6] + 0.5).floor()), (before, after), "{row}");
        dark += cells[5];
        // A tenth of a second parts into lines, and these into columns.
        let expected = 0.1 * (line * old.columns + column) as f64 / old.codes.len() as f64;
        assert!((cells[3] - expected).abs() < 1e-12, "{row}");
    }
    assert!(dark > 1.0, "{dark}");
    for format in ["fst", "vcd", "npz", "json", "raw", "sr"] {
        let file = format!("lines.{format}");
        let (out, _) = probe(0, &["0:..", "--waveforms", &file, "--json"]);
        let record: Value = serde_json::from_str(&out).unwrap();
        assert_eq!(record["probe"]["format"], format);
        assert_eq!(record["probe"]["lines"], serde_json::json!([0, new.codes.len() / new.columns]));
        assert_eq!(record["probe"]["signals"].as_array().unwrap().len(), 5);
        assert_eq!(record["probe"]["files"][0], file);
    }
    let beside: Value = serde_json::from_slice(&fs::read(scene.join("lines.npz.json")).unwrap()).unwrap();
    assert_eq!(
        (&beside["signals"][0]["full_scale"], &beside["signals"][0]["block"]),
        (&255.0.into(), &"vehicle-shadow".into())
    );
    // A scan converter has no D/A converters.
    let tube = ["--fresh", "--method", "scan-converter", "--waveforms", "tube.json"];
    probe(0, &[&["0:20"][..], &tube].concat());
    let tube_has: Value = serde_json::from_slice(&fs::read(scene.join("tube.json")).unwrap()).unwrap();
    let signals = tube_has["traces"][0]["signals"].as_object().unwrap();
    assert_eq!(signals.keys().collect::<Vec<_>>(), ["vs.dark", "vs.gate", "vs.video.in", "vs.video.out"]);
    let (_, err) = probe(2, &[&["0:20:vs.blank"][..], &tube].concat());
    assert!(err.contains("vs.blank: no signal of this name under this method"), "{err}");
    let (out, _) = scene.expect(0, &["signals", "vs.*", "--json"]);
    let listed: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(listed["signals"].as_array().unwrap().len(), 6);
}

#[test]
fn lines_that_are_not_there_are_refused() {
    let scene = run();
    for (code, probe, file, words) in [
        (2, "2:20", "a.csv", "--probe 2:20..21: no such frame; expected one of the pictures, 0 to 1"),
        (2, "1:23", "a.csv", "the picture has lines 0.."),
        (2, "1:3..3", "a.csv", "expected FRAME:LINE"),
        (2, "1", "a.csv", "expected FRAME:LINE"),
        (2, "1:3:tg.height", "a.csv", "tg.height: no signal of this name"),
        (2, "1:3:vs.tracks", "a.csv", "expected some of vs.video.in, vs.gate, vs.blank"),
        (2, "1:3:", "a.csv", "no signal of this name"),
        (2, "1:3", "a.png", "expected a name that ends in .csv, .vcd"),
        (4, "1:3", "gone/a.csv", "gone/a.csv: cannot write here"),
    ] {
        let rest = ["rover", "--sun", "212,6", "--out", "new", "--probe", probe, "--waveforms", file];
        let (_, err) = augment(&scene, code, &rest);
        assert!(err.contains(words), "{probe} {file}: {err}");
        assert!(!scene.join("new").exists() && !scene.join("a.csv").exists(), "{probe} {file}");
    }
    for half in [&["--probe", "1:3"][..], &["--waveforms", "a.csv"], &["--large"]] {
        let (_, err) = augment(&scene, 2, &[&["rover", "--sun", "212,6", "--out", "new"], half].concat());
        assert!(err.contains("required"), "{half:?}: {err}");
    }
    // A day and a second between two pictures: no line of a television picture lasts that long.
    let poses = fs::read_to_string(scene.join("run/poses.csv")).unwrap();
    scene.write("run/poses.csv", poses.replace("\n1,0.1,", "\n1,86401,"));
    let rest = ["rover", "--sun", "212,6", "--out", "new", "--probe", "1:3", "--waveforms", "a.csv"];
    let (_, err) = augment(&scene, 2, &rest);
    assert!(err.contains("pictures 86401 s apart; expected at most a day"), "{err}");
}

/// Codes of frame 1 in a folder, by another reader than the command's.
struct Picture {
    columns: usize,
    codes: Vec<u8>,
}

impl Picture {
    fn read(scene: &Scene, folder: &str) -> Self {
        let file = fs::File::open(scene.join(&format!("{folder}/frame-000001.png"))).unwrap();
        let mut reader = png::Decoder::new(std::io::BufReader::new(file)).read_info().unwrap();
        let mut codes = vec![0; reader.output_buffer_size().unwrap()];
        let frame = reader.next_frame(&mut codes).unwrap();
        assert_eq!((frame.color_type, frame.bit_depth), (png::ColorType::Grayscale, png::BitDepth::Eight));
        Self { columns: frame.width as usize, codes }
    }
}

#[test]
fn tracks_want_ground() {
    let scene = run();
    let (_, err) = augment(&scene, 2, &["rover", "--sun", "212,6", "--tracks", "--out", "new"]);
    assert!(err.contains("tracks need ground data") && err.contains("gives no heights"), "{err}");
    let tracks = ["rover", "--ground", "tiny.toml", "--tracks", "--out", "new", "--json"];
    let (out, _) = augment(&scene, 0, &tracks);
    let record: Value = serde_json::from_str(&out).unwrap();
    // 0.1 s at 1.9 m/s: one patch of each rear wheel.
    assert_eq!(record["track_patches"], 2, "{record}");
}

#[test]
fn what_cannot_be_is_refused() {
    let scene = run();
    fs::copy(scene.join("run/poses.csv"), scene.join("poses.csv")).unwrap();
    fs::create_dir(scene.join("none")).unwrap();
    for (code, rest, words) in [
        (2, &["rover"][..], "--out"),
        (2, &["rover", "--out", "new"], "flat ground has no sun of its own"),
        (2, &["rover", "--sun", "212,0", "--out", "new"], "frame 0: the sun at an elevation of 0 deg"),
        (2, &["rover", "--sun", "212,0.2", "--penumbra", "--out", "new"], "expected more than 0.2666"),
        (2, &["rover", "--sun", "212", "--out", "new"], "expected two numbers"),
        (2, &["rover", "--sun", "212,6", "--out", "run/frames"], "would replace the old ones"),
        (2, &["rover", "--sun", "212,6", "--gain", "2", "--out", "new"], "expected 0 to 1"),
        (2, &["rover", "--sun", "212,6", "--field", "50,180", "--out", "new"], "below 170 degrees"),
        (3, &["rowboat", "--sun", "212,6", "--out", "new"], "no vehicle has the name `rowboat`"),
        (3, &["gone.obj", "--sun", "212,6", "--out", "new"], "gone.obj: no such file"),
        (3, &["rover", "--sun", "212,6", "--camera", "tiny.toml", "--out", "new"], "tiny.toml: "),
        (3, &["rover", "--ground", "gone.toml", "--out", "new"], "gone.toml"),
    ] {
        let (_, err) = augment(&scene, code, rest);
        assert!(err.contains(words), "{rest:?}: {err}");
        assert!(!scene.join("new").exists(), "{rest:?} leaves a folder");
    }
    for (frames, poses, words) in [
        ("none", "run/poses.csv", "no picture here"),
        ("gone", "run/poses.csv", "cannot list this folder"),
        ("run/frames", "gone.csv", "gone.csv: no such file"),
        ("run/frames", "poses.csv", "no camera.json beside the poses"),
    ] {
        let rest = ["augment", frames, poses, "--vehicle", "rover", "--sun", "212,6", "--out", "new"];
        let (_, err) = scene.expect(3, &rest);
        assert!(err.contains(words), "{frames} {poses}: {err}");
    }
}
