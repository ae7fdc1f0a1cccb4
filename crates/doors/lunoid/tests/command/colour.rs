//! Pictures in colour, by `compare` and `info`.

use picture::{ColourPicture, Depth, GreyPicture, write_png};
use serde_json::Value;

use crate::scene::Scene;

/// Three pictures of 12 x 12: two in colour, whose blue differs in one pixel, and a grey one.
fn pictures() -> Scene {
    let scene = Scene::new();
    let mut codes: Vec<u16> = (0..12 * 12).flat_map(|at| [at, 255 - at, 100]).collect();
    let write = |name: &str, codes: &[u16]| {
        let picture = ColourPicture::new(12, 12, Depth::Eight, codes.to_vec()).unwrap();
        write_png(scene.join(name), &picture, &[]).unwrap();
    };
    write("a.png", &codes);
    codes[3 * 17 + 2] = 130;
    write("b.png", &codes);
    let grey = GreyPicture::new(12, 12, Depth::Eight, vec![90; 144]).unwrap();
    write_png(scene.join("grey.png"), &grey, &[]).unwrap();
    scene
}

#[test]
fn channels_are_told_and_held_to_the_tolerance() {
    let scene = pictures();
    let (out, _) = scene.expect(0, &["compare", "a.png", "b.png", "--out", "d.png"]);
    assert!(out.contains("rmse of red 0.00000, green 0.00000, blue 0.00980; above of luminance"), "{out}");
    let (out, _) = scene.expect(0, &["compare", "a.png", "b.png", "--json"]);
    let document: Value = serde_json::from_str(&out).unwrap();
    let pair = &document["pictures"][0];
    assert_eq!(pair["compared_by"], "luminance");
    assert_eq!(pair["channels"]["blue"]["worst"]["column"], 5);
    assert_eq!(
        (&pair["channels"]["red"]["differing"], &pair["channels"]["blue"]["differing"]),
        (&0.into(), &1.into())
    );
    // The luminance is off by two levels at most, blue by thirty.
    scene.expect(1, &["compare", "a.png", "b.png", "--tolerance", "20"]);
    scene.expect(0, &["compare", "a.png", "b.png", "--tolerance", "30"]);
    let (out, _) = scene.expect(0, &["info", "d.png"]);
    assert!(out.contains("44 x 12 pixels of 8 bits, colour, pixel hash"), "{out}");
}

#[test]
fn colour_against_grey_is_compared_by_luminance() {
    let scene = pictures();
    let (out, _) = scene.expect(0, &["compare", "a.png", "grey.png"]);
    assert!(out.contains("one in colour, one grey: compared by luminance"), "{out}");
    let (out, _) = scene.expect(0, &["compare", "grey.png", "grey.png", "--json"]);
    let document: Value = serde_json::from_str(&out).unwrap();
    let keys: Vec<&String> = document["pictures"][0].as_object().unwrap().keys().collect();
    assert!(!keys.iter().any(|key| ["compared_by", "channels"].contains(&key.as_str())), "{keys:?}");
    // Any code above black leaves a pixel out.
    let (_, err) = scene.expect(3, &["compare", "grey.png", "grey.png", "--mask", "a.png"]);
    assert!(err.contains("the mask covers all 144 pixels"), "{err}");
}
