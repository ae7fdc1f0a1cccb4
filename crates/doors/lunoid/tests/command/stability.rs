//! `lunoid study stability`: what it leaves in a folder.

use std::fs;

use crate::scene::Scene;

#[test]
fn the_matrix_is_a_picture_with_every_case_and_every_method() {
    let scene = Scene::new();
    let only = ["--only", "time constant", "--only", "field", "--only", "limits"];
    let base = ["study", "stability", "--quick", "--no-progress", "--out", "s"];
    let (out, _) = scene.expect(0, &[&base[..], &only].concat());
    assert!(out.contains("0 do not hold"), "{out}");
    let files =
        ["matrix.png", "matrix.svg", "stability.csv", "stability.json", "stability.md"].map(str::to_owned);
    assert_eq!(scene.list("s"), files);
    let svg = fs::read_to_string(scene.join("s/matrix.svg")).unwrap();
    let csv = fs::read_to_string(scene.join("s/stability.csv")).unwrap();
    for line in csv.lines().skip(1) {
        let case = line.split('"').nth(1).unwrap();
        let method = line.split('"').nth(3).unwrap();
        for word in [case, method] {
            assert!(svg.contains(&format!("aria-label=\"{word}\"")), "{word}");
        }
    }
    // A view of 170 degrees is refused by all four machines; explicit steps have no bounds where a lag is short.
    assert_eq!(svg.matches("aria-label=\"refused\"").count(), 4);
    assert!(svg.matches("aria-label=\"inf\"").count() >= 4);
    assert!(fs::read(scene.join("s/matrix.png")).unwrap().starts_with(b"\x89PNG"));
    let page = fs::read_to_string(scene.join("s/stability.md")).unwrap();
    assert!(page.contains("](matrix.svg)"));
}
