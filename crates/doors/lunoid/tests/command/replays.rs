use std::fs;

use crate::scene::{Scene, lunoid};

/// Bytes of the frames of a run, in their order.
pub fn frames(scene: &Scene, folder: &str) -> Vec<Vec<u8>> {
    let folder = scene.join(folder).join("frames");
    let mut files: Vec<_> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    files.into_iter().map(|file| fs::read(file).unwrap()).collect()
}

#[test]
fn a_scenario_becomes_a_folder() {
    let scene = Scene::new();
    let (out, err) = scene.expect(0, &["replay", "tiny.toml", "--apng"]);
    assert!(out.contains("runs/tiny: frames 0..4, 4 drawn now"), "{out}");
    assert_eq!(err, "");
    let names = [
        "animation.png",
        "camera.json",
        "contact-sheet.png",
        "frames",
        "index.html",
        "page.json",
        "performance.json",
        "poses.csv",
        "run.json",
    ];
    assert_eq!(scene.list("runs/tiny"), names);
    let expected: Vec<String> = (0..4).map(|n| format!("frame-{n:06}.png")).collect();
    assert_eq!(scene.list("runs/tiny/frames"), expected);
    let record = fs::read_to_string(scene.join("runs/tiny/run.json")).unwrap();
    let record: serde_json::Value = serde_json::from_str(&record).unwrap();
    assert_eq!(record["schema"], "lunoid.run/2");
    assert_eq!(record["scenario"]["file"]["file"], "tiny.toml");
    let text = fs::read(scene.join("tiny.toml")).unwrap();
    assert_eq!(
        record["scenario"]["file"]["blake3"],
        run_record::file_hash(&scene.join("tiny.toml")).unwrap()
    );
    assert!(!text.is_empty() && record["model"]["values"].as_array().unwrap().len() > 10);
    let (again, _) = scene.expect(0, &["replay", "tiny.toml"]);
    assert_eq!(again, "runs/tiny: frames 0..4, all there already\nopen runs/tiny/index.html\n");
    let (info, _) = scene.expect(0, &["info", "runs/tiny"]);
    assert!(info.contains("frames 0..4 of \"Tiny\" by hybrid (ideal), 40 sweeps of 80 samples"), "{info}");
}

/// Names of the phases of a run.
fn phases(scene: &Scene, folder: &str) -> Vec<String> {
    let text = fs::read_to_string(scene.join(folder).join("performance.json")).unwrap();
    let times: serde_json::Value = serde_json::from_str(&text).unwrap();
    let name = |phase: &serde_json::Value| phase["phase"].as_str().unwrap().to_owned();
    times["phases"].as_array().unwrap().iter().map(name).collect()
}

#[test]
fn every_phase_of_a_command_stands_in_its_times() {
    let scene = Scene::new();
    scene.expect(0, &["replay", "tiny.toml"]);
    let run = ["start", "read", "landscape", "prepare", "begin", "draw", "finish"];
    let page = ["sight", "timing", "probe", "page"];
    assert_eq!(phases(&scene, "runs/tiny"), [&run[..], &page, &["summary"]].concat());
    let (out, _) = scene.expect(
        0,
        &[
            "replay",
            "tiny.toml",
            "--no-page",
            "--truth",
            "range",
            "--y4m",
            "film.y4m",
            "--out",
            "a",
            "--json",
        ],
    );
    let all = [&run[..], &["truth", "film", "summary"]].concat();
    assert_eq!(phases(&scene, "a"), all);
    let out: serde_json::Value = serde_json::from_str(&out).unwrap();
    assert_eq!(out["performance"]["phases"].as_array().unwrap().len(), all.len());
    scene.expect(0, &["replay", "tiny.toml", "--machine", "ideal", "--machine", "exact", "--out", "b"]);
    let [before, between] = [&["start", "read"][..], &["landscape", "prepare", "begin", "draw", "finish"]];
    let after = [&page[..], &["summary"]].concat();
    assert_eq!(phases(&scene, "b/ideal"), [before, &["others"], between, &after].concat());
}

#[test]
fn threads_and_ways_of_asking_change_no_bit() {
    let scene = Scene::new();
    scene.expect(0, &["replay", "tiny.toml", "--jobs", "1", "--out", "a"]);
    let mut command = lunoid();
    let command = command.current_dir(scene.path()).env("LUNOID_THREADS", "3");
    assert!(command.args(["replay", "tiny.toml", "--out", "b"]).output().unwrap().status.success());
    scene.expect(0, &["replay", "tiny.toml", "--frames", "2..", "--out", "c"]);
    scene.expect(0, &["replay", "tiny.toml", "--frames", "0..2", "--out", "c"]);
    assert_eq!(frames(&scene, "a"), frames(&scene, "b"));
    assert_eq!(frames(&scene, "a"), frames(&scene, "c"));
    let read = |folder: &str| fs::read(scene.join(folder).join("run.json")).unwrap();
    assert_eq!(read("a"), read("b"));
    assert_eq!(read("a"), read("c"));
}

#[test]
fn the_command_line_wins() {
    let scene = Scene::new();
    let record = |arguments: &[&str]| {
        let arguments = [&["replay", "tiny.toml", "--frames", "0", "--fresh", "--json"], arguments].concat();
        let (out, _) = scene.expect(0, &arguments);
        assert_eq!(serde_json::from_str::<serde_json::Value>(&out).unwrap()["schema"], "lunoid.replay/1");
        let text = fs::read_to_string(scene.join("runs/tiny/run.json")).unwrap();
        serde_json::from_str::<serde_json::Value>(&text).unwrap()
    };
    let settings = |arguments: &[&str]| record(arguments)["settings"].clone();
    assert_eq!(settings(&[])["raster"]["sweeps"], 40);
    assert_eq!(settings(&["--sweeps", "24"])["raster"]["sweeps"], 24);
    assert_eq!(settings(&["--set", "raster.sweeps=32"])["raster"]["sweeps"], 32);
    assert_eq!(settings(&["--samples", "99"])["raster"]["samples_per_sweep"], 99);
    assert_eq!(settings(&["--scalar", "f64"])["scalar"], "f64");
    assert_eq!(record(&["--set", "dpp.curvature=none"])["view"]["laws"]["curvature"], "none");
    scene.write("over.toml", "format = 1\n[loader]\naccess_ns = 950\n");
    assert_eq!(settings(&["--overlay", "over.toml"])["loader"]["access_ticks"], 950);
}

#[test]
fn exact_draws_nearly_the_same_and_compare_says_so() {
    let scene = Scene::new();
    let base = ["replay", "tiny.toml", "--samples", "1000", "--frames", "0..2"];
    scene.expect(0, &[&base[..], &["--out", "machine"]].concat());
    scene.expect(0, &[&base[..], &["--out", "exact", "--machine", "exact"]].concat());
    let (out, _) = scene.expect(0, &["compare", "machine", "exact", "--json", "--out", "difference.png"]);
    let document: serde_json::Value = serde_json::from_str(&out).unwrap();
    assert_eq!(document["schema"], "lunoid.compare/1");
    assert_eq!(document["pictures"].as_array().unwrap().len(), 2);
    assert!(document["pictures"][0]["rmse"].as_f64().unwrap() < 0.05, "{out}");
    assert!(scene.join("difference.png").exists());
    let frame = |folder: &str| format!("{folder}/frames/frame-000000.png");
    let (same, other) = (frame("machine"), frame("exact"));
    scene.expect(0, &["compare", &same, &same, "--max-rmse", "0"]);
    scene.expect(0, &["compare", &same, &other, "--tolerance", "2", "--share", "100"]);
    let (out, _) = scene.expect(1, &["compare", &same, &other, "--max-rmse", "0"]);
    assert!(out.contains("beyond the tolerance"), "{out}");
    scene.expect(1, &["compare", &same, &other, "--tolerance", "0"]);
    scene.expect(
        0,
        &["compare", &same, &other, "--tolerance", "0", "--mask", &all_but_one_pixel(&scene, &same, &other)],
    );
}

#[test]
fn ridge_lines_are_left_out_and_measured() {
    let scene = Scene::new();
    let base = ["replay", "tiny.toml", "-q", "--samples", "2000", "--frames", "0..2"];
    scene.expect(0, &[&base[..], &["--out", "machine"]].concat());
    scene.expect(0, &[&base[..], &["--out", "exact", "--machine", "exact"]].concat());
    let compare = ["compare", "machine", "exact", "--ridges", "tiny.toml"];
    let (out, _) = scene.expect(0, &[&compare[..], &["--json", "--max-ridge", "1"]].concat());
    let document: serde_json::Value = serde_json::from_str(&out).unwrap();
    let (masked, columns) =
        (&document["pictures"][1]["masked"], &document["pictures"][1]["horizon_lines"]["columns"]);
    assert!(masked.as_u64().unwrap() >= 40, "{out}");
    assert_eq!(columns.as_u64().unwrap(), 40, "{out}");
    let (out, _) = scene.expect(0, &compare);
    assert!(out.contains("frame 1: ") && out.contains("horizon off by 0 lines (median)"), "{out}");
    scene.vary("other.toml", "end_m = 300", "end_m = 200");
    let (_, err) = scene.expect(3, &["compare", "machine", "exact", "--ridges", "other.toml"]);
    assert!(err.contains("view.ranges_m") && err.contains("name the scenario of the run"), "{err}");
    let frame = "exact/frames/frame-000000.png";
    scene.expect(2, &["compare", frame, frame, "--ridges", "tiny.toml"]);
}

#[test]
fn edges_are_left_out_and_their_share_told() {
    let scene = Scene::new();
    let base = ["replay", "tiny.toml", "-q", "--frames", "0..1"];
    scene.expect(0, &[&base[..], &["--out", "machine"]].concat());
    scene.expect(0, &[&base[..], &["--out", "exact", "--machine", "exact"]].concat());
    let compare = ["compare", "machine", "exact", "--edges", "tiny.toml"];
    let (out, _) = scene.expect(0, &[&compare[..], &["--json"]].concat());
    let document: serde_json::Value = serde_json::from_str(&out).unwrap();
    let edges = &document["pictures"][0]["edges"];
    assert_eq!(edges["masked"], document["pictures"][0]["masked"], "{out}");
    assert!(edges["ridges"].as_u64().unwrap() >= 40 && edges["share"].as_f64().unwrap() < 0.5, "{out}");
    assert!(document["pictures"][0]["linear"]["maximum"].is_number(), "{out}");
    let (out, _) = scene.expect(0, &["compare", "machine", "exact", "--json"]);
    let whole: serde_json::Value = serde_json::from_str(&out).unwrap();
    assert!(whole["pictures"][0]["linear"]["rmse"].as_f64().unwrap() > 0.0, "{out}");
    let (out, _) = scene.expect(0, &compare);
    assert!(out.contains("%) along edges (ridges "), "{out}");
    scene.expect(2, &[&compare[..], &["--ridges", "tiny.toml"]].concat());
    scene.expect(2, &["compare", "machine", "exact", "--max-ridge", "1"]);
}

#[test]
fn ground_truth_comes_with_any_machine() {
    let scene = Scene::new();
    for (machine, out) in [("ideal", "a"), ("exact", "b")] {
        let truth = ["--truth", "range,label,pose", "--frames", "0..2"];
        let base = ["replay", "tiny.toml", "--machine", machine, "--out", out];
        let (said, _) = scene.expect(0, &[&base[..], &truth].concat());
        assert!(said.contains("ground truth of 2 frames, 2 made now"), "{said}");
    }
    let files = ["frame-000000.npz", "frame-000001.npz", "poses.csv", "poses.json", "truth.json"];
    assert_eq!(scene.list("a/truth"), files);
    for file in &files[..4] {
        let read = |run: &str| fs::read(scene.join(run).join("truth").join(file)).unwrap();
        assert_eq!(read("a"), read("b"), "{file}");
    }
    let (_, err) = scene.expect(2, &["replay", "tiny.toml", "--truth", "range,depth"]);
    assert!(err.contains("`depth`") && err.contains("reflectivity, shadow, label, pose"), "{err}");
    let (_, err) = scene.expect(4, &["replay", "tiny.toml", "--out", "a", "--truth", "height"]);
    assert!(err.contains("ground truth of other kinds"), "{err}");
}

/// A mask that leaves one pixel, equal in both: the sky at the top left.
fn all_but_one_pixel(scene: &Scene, a: &str, b: &str) -> String {
    let limits = picture::Limits::default();
    let [a, b] = [a, b].map(|name| picture::read_png(scene.join(name), &limits).unwrap());
    assert_eq!(a.code(0, 0), b.code(0, 0));
    let codes = (0..a.codes().len()).map(|at| if at == 0 { 0 } else { 255 }).collect();
    let mask = picture::GreyPicture::new(a.columns(), a.lines(), picture::Depth::Eight, codes).unwrap();
    picture::write_png(scene.join("mask.png"), &mask, &[]).unwrap();
    "mask.png".into()
}

#[test]
fn films_go_to_a_file_or_a_pipe() {
    let scene = Scene::new();
    let (out, _) = scene.expect(0, &["replay", "tiny.toml", "--y4m", "film.y4m"]);
    assert!(out.contains("4 drawn now"), "{out}");
    let film = fs::read(scene.join("film.y4m")).unwrap();
    assert!(film.starts_with(b"YUV4MPEG2 W40 "));
    let output = scene.run(&["replay", "tiny.toml", "--y4m", "-"]);
    assert_eq!(output.stdout, film);
    assert!(String::from_utf8_lossy(&output.stderr).contains("all there already"));
}

#[test]
fn refresh_gives_the_pictures_of_the_tube() {
    let scene = Scene::new();
    scene.expect(0, &["replay", "tiny.toml", "--refresh", "--frames", "1..2", "--depth", "16", "-q"]);
    let names = ["frame-000003.png", "frame-000004.png", "frame-000005.png"];
    assert_eq!(scene.list("runs/tiny/frames"), names);
    let (out, _) = scene.expect(0, &["info", "runs/tiny/frames/frame-000004.png"]);
    assert!(out.contains("of 16 bits"), "{out}");
}

#[test]
fn another_run_is_refused_unless_fresh() {
    let scene = Scene::new();
    scene.expect(0, &["replay", "tiny.toml", "-q"]);
    let before = frames(&scene, "runs/tiny");
    let (_, err) = scene.expect(4, &["replay", "tiny.toml", "-q", "--sweeps", "20"]);
    assert!(err.contains("holds another run") && err.contains("--fresh"), "{err}");
    assert_eq!(frames(&scene, "runs/tiny"), before);
    scene.expect(0, &["replay", "tiny.toml", "-q", "--sweeps", "20", "--fresh"]);
    assert_ne!(frames(&scene, "runs/tiny"), before);
}

#[test]
fn waveforms_of_a_sweep() {
    let scene = Scene::new();
    let base = [
        "probe",
        "tiny.toml",
        "--frame",
        "1",
        "--sweep",
        "3..5",
        "--signals",
        "tg.height,sweep.x,sweep.fold.x",
    ];
    let (out, _) = scene.expect(0, &[&base[..], &["--out", "w.csv"]].concat());
    assert_eq!(out, "w.csv: frame 1, sweeps 3..5: sweep.x, sweep.fold.x, tg.height\n");
    let csv = fs::read_to_string(scene.join("w.csv")).unwrap();
    let mut lines = csv.lines();
    assert_eq!(lines.next(), Some("frame,sweep,index,time [s],sweep.x [d],sweep.fold.x [1],tg.height [m]"));
    assert_eq!(lines.count(), 2 * 80);
    scene.expect(0, &[&base[..], &["--out", "w.npz", "--json"]].concat());
    assert!(fs::read(scene.join("w.npz")).unwrap().starts_with(b"PK"));
}

/// A picture shows one sweep; gates and curves are drawn, lines of the display are not.
#[test]
fn a_sweep_as_a_picture() {
    let scene = Scene::new();
    let probe = |sweep, signals, out| {
        ["probe", "tiny.toml", "--frame", "1", "--sweep", sweep, "--signals", signals, "--out", out]
    };
    scene.expect(0, &probe("3", "tg.*,dpp.blank", "w.png"));
    assert!(fs::read(scene.join("w.png")).unwrap().starts_with(b"\x89PNG"));
    let (_, err) = scene.expect(2, &probe("3..5", "tg.*", "two.png"));
    assert!(err.contains("a picture shows one sweep"), "{err}");
    let (_, err) = scene.expect(2, &probe("3", "sm.write", "lines.png"));
    assert!(err.contains("none of them runs along the sweep"), "{err}");
    assert!(!scene.join("two.png").exists() && !scene.join("lines.png").exists());
}

/// A first Ctrl-C ends the run with whole frames; the same command draws the rest.
#[cfg(target_os = "linux")]
#[test]
fn ctrl_c_and_resume() {
    use std::process::{Command, Stdio};
    use std::time::{Duration, Instant};

    let scene = Scene::new();
    scene.vary("long.toml", "frames = 4", "frames = 400");
    let mut command = Command::new(assert_cmd::cargo::cargo_bin("lunoid"));
    let command = command.current_dir(scene.path()).args(["replay", "long.toml", "--samples", "4000"]);
    let child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let began = Instant::now();
    while scene.list("runs/long/frames").len() < 5 && began.elapsed() < Duration::from_secs(60) {
        std::thread::sleep(Duration::from_millis(2));
    }
    assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
    let output = child.wait_with_output().unwrap();
    let err = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(130), "{err}");
    assert!(err.contains("frames are whole; the same command again draws the rest"), "{err}");
    assert!(!scene.join("runs/long/run.json").exists());
    let kept = scene.list("runs/long/frames").len();
    assert!((5..400).contains(&kept), "{kept}");
    let (out, _) = scene.expect(0, &["replay", "long.toml", "--samples", "4000"]);
    assert!(out.contains(&format!("{} drawn now", 400 - kept)), "{kept}: {out}");
    assert_eq!(scene.list("runs/long/frames").len(), 400);
    assert!(!scene.join("runs/long/frames.journal").exists());
}
