//! The text file: what is read, and every fault by its place.

use std::path::Path;

use terrain_builder::{BaseWish, Description, Kind, SizeLaw, Switch};

use crate::{FEATURES, HEAD, described, file_of};

fn refused(text: &str) -> String {
    Description::parse("ground.toml", text, Path::new("")).expect_err("refused").to_string()
}

#[test]
fn a_file_of_every_kind_is_read_in_the_order_of_names() {
    let description = described(&file_of(&[0, 1, 2, 3, 4, 5]));
    let names: Vec<_> = description.features.iter().map(|feature| feature.id.as_str()).collect();
    assert_eq!(names, ["a-rock", "hill", "north-crater", "plain", "rocks", "small-craters"]);
    assert_eq!(description.base, BaseWish::Level(0.0));
    assert_eq!(description.title, "Test ground");
    let Kind::Boulders { distribution, .. } = &description.features[4].kind else { panic!("boulders") };
    assert_eq!((distribution.sizes, distribution.separation), (SizeLaw::PowerLaw(2.0), 30.0));
    let Kind::Craters { wall, depth, .. } = &description.features[5].kind else { panic!("craters") };
    assert_eq!((*wall, *depth), ([0.02, 0.06], [0.1, 0.3]));
}

#[test]
fn base_light_and_switches_are_read() {
    let more = "[base]\nfile = \"moon.tif\"\nband = 2\n[light]\nsub_solar_deg = [1.5, 80.0]\n";
    let text = format!("as_reported = [\"roughness-lift\"]\n{HEAD}{more}");
    let read = Description::parse("ground.toml", &text, Path::new("folder")).unwrap();
    let path = Path::new("folder").join("moon.tif");
    assert_eq!(read.base, BaseWish::File { path, band: Some(2) });
    assert!(read.reported.has(Switch::RoughnessLift) && !read.reported.has(Switch::GrowthSums));
    let light = read.light.unwrap();
    assert_eq!((light.ambient, light.diffuse), ([0.0; 3], [1.0; 3]));
    assert_eq!(described(&format!("{HEAD}[base]\nheight_m = -7.5\n")).base, BaseWish::Level(-7.5));
}

#[test]
fn every_fault_is_told_by_its_place() {
    let cases = [
        (HEAD.replace("format = 1", "format = 2"), "format 2 is newer"),
        (HEAD.replace("26.1]", "25.0]"), "`area.latitude_deg` is [26, 25]: expected south and north"),
        (HEAD.replace("50.0", "0"), "`area.resolution_m` is 0: expected a length"),
        (HEAD.replace("resolution_m", "resolution"), "unknown key `area.resolution`"),
        (format!("{HEAD}[base]\nfile = \"a\"\nheight_m = 1\n"), "`base.height_m` beside `base.file`"),
        (format!("as_reported = [\"growth-sum\"]\n{HEAD}"), "did you mean \"growth-sums\"?"),
        (format!("{HEAD}[light]\nsub_solar_deg = [0, 0]\nambient = [0, 0, 2]\n"), "`light.ambient`"),
        (format!("{HEAD}{}", FEATURES[0].replace("= 20.0", "= 120.0")), "`feature[0].depth_percent` is 120"),
        (format!("{HEAD}{}", FEATURES[0].replace("\"crater\"", "\"crate\"")), "did you mean \"crater\"?"),
        (
            format!("{HEAD}{}", FEATURES[0].replace("scale_m = 2.0", "scale_m = -2.0")),
            "`feature[0].roughness.scale_m`",
        ),
        (format!("{HEAD}{}", FEATURES[1].replace("height_m = 120.0", "height = 1")), "points[0].height`"),
        (
            format!("{HEAD}{}", FEATURES[1].replace("iterations = 3", "iterations = 0")),
            "`feature[0].iterations` is 0",
        ),
        (
            format!("{HEAD}{}", FEATURES[1].replace(", { at_deg = [3.06, 26.04], height_m = 80.0 }", "")),
            "has 1 picks",
        ),
        (format!("{HEAD}{}", FEATURES[2].replace("= 6.0", "= 1e9")), "items,: expected at most 10 million"),
        (
            format!("{HEAD}{}", FEATURES[2].replace("[20.0, 300.0]", "[300.0, 20.0]")),
            "`feature[0].radius_m` is [300, 20]",
        ),
        (format!("{HEAD}{}wall_percent = [5, 2]\n", FEATURES[2]), "`feature[0].wall_percent` is [5, 2]"),
        (format!("{HEAD}{}", FEATURES[4].replace("= 0.0", "= 0.95")), "`feature[0].burial` is 0.95"),
        (format!("{HEAD}{}", FEATURES[4].replace("a-rock", "a rock")), "`feature[0].id` must be"),
        (format!("{HEAD}{0}{0}", FEATURES[4]), "a feature before it has the name \"a-rock\""),
        (
            format!("{HEAD}{}roughness = {{ seeds = [1], scale_m = 1 }}\n", FEATURES[4]),
            "unknown key `feature[0].roughness`",
        ),
    ];
    for (text, expected) in cases {
        let told = refused(&text);
        assert!(told.contains(expected), "expected {expected}, told:\n{told}");
        assert!(told.contains("ground.toml:"), "no place:\n{told}");
        assert_eq!(
            told.matches("error: ").count(),
            1 + usize::from(expected.contains("key `area")) + usize::from(expected.contains("height`")),
            "{told}"
        );
    }
}

/// A fault names the feature: its number in the file, its kind and its name, where it has them.
#[test]
fn a_fault_of_a_feature_names_it() {
    let both = |second: String| refused(&format!("{HEAD}{}{second}", FEATURES[0]));
    let told = both(FEATURES[4].replace("= 0.0", "= 0.95"));
    assert!(told.contains("`feature[1].burial` is 0.95") && told.contains("ground.toml:"), "{told}");
    assert!(told.contains("(feature 2 of the file, boulder \"a-rock\")"), "{told}");
    let told = both(FEATURES[4].replace("burial", "buried"));
    assert!(
        told.contains("unknown key `feature[1].buried` (feature 2 of the file, boulder \"a-rock\")"),
        "{told}"
    );
    let told = both(FEATURES[1].replace("height_m = 120.0", "height_m = true"));
    assert!(told.contains("(feature 2 of the file, growth \"hill\")"), "{told}");
    let nameless = both(FEATURES[4].replace("id = ", "name = "));
    assert!(nameless.contains("(feature 2 of the file, boulder)"), "{nameless}");
    let place = refused(&HEAD.replace("50.0", "0"));
    assert!(!place.contains("of the file"), "{place}");
}

#[test]
fn damaged_text_is_refused_and_never_a_panic() {
    let text = file_of(&[0, 1, 2, 3, 4, 5]);
    for end in (0..text.len()).step_by(7) {
        let _ = Description::parse("ground.toml", &text[..end], Path::new(""));
    }
    for (at, _) in text.match_indices('=').step_by(1) {
        for value in ["= nan #", "= -1 #", "= \"x\" #", "= [] #", "= 1e300 #", "= {} #"] {
            let damaged = format!("{}{value}{}", &text[..at], &text[at + 1..]);
            let _ = Description::parse("ground.toml", &damaged, Path::new(""));
        }
    }
}

#[test]
fn a_missing_file_is_told() {
    let told = Description::read(Path::new("no-such-folder/ground.toml")).expect_err("refused").to_string();
    assert!(told.contains("no-such-folder/ground.toml"), "{told}");
}
