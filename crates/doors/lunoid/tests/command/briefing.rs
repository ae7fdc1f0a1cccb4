//! `lunoid photo brief`: a run as a film with the map beside it.

use std::fs;

use serde_json::Value;

use crate::scene::Scene;

#[test]
fn a_run_becomes_a_film_with_its_map() {
    let scene = Scene::new();
    scene.expect(0, &["replay", "tiny.toml", "--frames", "0..2", "--out", "run"]);
    let (out, _) = scene.expect(0, &["photo", "brief", "run", "--out", "film.png", "--json"]);
    let told: Value = serde_json::from_str(&out).unwrap();
    assert_eq!((&told["schema"], &told["pictures"]), (&"lunoid.briefing/1".into(), &2.into()));
    let film = fs::read(scene.join("film.png")).unwrap();
    // The chunk that says how many pictures an animated PNG has.
    let at = film.windows(4).position(|chunk| chunk == b"acTL").expect("an animated PNG");
    assert_eq!(film[at + 4..at + 8], 2_u32.to_be_bytes());
    // Twice as wide as a frame, and a gap of 4 pixels.
    let frame = fs::read(scene.join("run/frames/frame-000000.png")).unwrap();
    let size =
        |png: &[u8]| [16, 20].map(|at| u32::from_be_bytes(png[at..at + 4].try_into().expect("four bytes")));
    let ([columns, lines], found) = (size(&frame), size(&film));
    assert_eq!(found, [2 * columns + 4, lines]);
}

#[test]
fn what_is_no_run_is_refused() {
    let scene = Scene::new();
    scene.expect(3, &["photo", "brief", "run", "--out", "film.png"]);
    scene.expect(0, &["replay", "tiny.toml", "--frames", "0..1", "--out", "run"]);
    let (_, err) = scene.expect(2, &["photo", "brief", "run", "--out", "film.gif"]);
    assert!(err.contains(".png"), "{err}");
    scene.expect(0, &["replay", "tiny.toml", "--frames", "0..1", "--no-page", "--out", "bare"]);
    let (_, err) = scene.expect(3, &["photo", "brief", "bare", "--out", "film.png"]);
    assert!(err.contains("page.json") && !scene.join("film.png").exists(), "{err}");
}
