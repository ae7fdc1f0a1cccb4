//! Elevation files that are no ground, and surveys that cannot be.

use crate::build::{Tiff, doubles, npy};
use crate::room::{INPUT, KEYFRAMES, Room, USAGE};

const LABEL: &str = include_str!("../../../../world/survey/tests/ground.lbl");

fn survey<'a>(file: &'a str, options: &[&'a str]) -> Vec<&'a str> {
    [&["survey", file, "-o", "x.bank", "--picture", "x.png"], options].concat()
}

fn refused(room: &Room, file: &str, words: &[&str]) {
    room.refused(INPUT, &survey(file, &["--region-size-m", "40"]), &[&[file][..], words].concat());
}

#[test]
fn files_that_are_none() {
    let room = Room::new();
    room.write("empty.tif", "");
    room.write("text.tif", "hello\n");
    refused(&room, "gone.tif", &["no such file"]);
    refused(&room, "folder", &["this is a folder, expected a file", "name a file inside it"]);
    room.write("picture.png", "\u{89}PNG".chars().map(|letter| letter as u8).collect::<Vec<u8>>());
    refused(&room, "picture.png", &["the mark of a PNG picture"]);
    refused(&room, "empty.tif", &["the file is empty", "expected a TIFF"]);
    refused(&room, "text.tif", &["starts with 68 65", "gdal_translate"]);
}

#[test]
fn geotiff_that_is_cut_short_or_empty() {
    let room = Room::new();
    let whole = Tiff::plane().bytes();
    for (name, length) in [("header.tif", 6), ("directory.tif", 40), ("strip.tif", whole.len() - 300)] {
        room.write(name, &whole[..length]);
        refused(&room, name, &["expected"]);
    }
    room.write("none.tif", Tiff { columns: 0, lines: 0, heights: vec![], ..Tiff::plane() }.bytes());
    room.write("wide.tif", Tiff { lines: 0, heights: vec![], ..Tiff::plane() }.bytes());
    room.write("huge.tif", Tiff { columns: 1_000_000, lines: 1_000_000, ..Tiff::plane() }.bytes());
    refused(&room, "none.tif", &["0x0"]);
    refused(&room, "wide.tif", &["20x0"]);
    refused(&room, "huge.tif", &["1000000 x 1000000", "expected at least 4000000000000", "truncated"]);
    // The same bytes unharmed are ground.
    room.write("whole.tif", whole);
    room.done(&survey("whole.tif", &["--region-size-m", "40"]));
}

#[test]
fn geotiff_without_heights() {
    let room = Room::new();
    let plane = Tiff::plane();
    let with = |value: f32| {
        let mut heights = plane.heights.clone();
        heights[77] = value;
        Tiff { heights, ..Tiff::plane() }.bytes()
    };
    room.write("bands.tif", Tiff { columns: 10, bands: 2, ..Tiff::plane() }.bytes());
    room.write(
        "void.tif",
        Tiff { heights: vec![-9999.0; 400], no_data: Some("-9999"), ..Tiff::plane() }.bytes(),
    );
    room.write("nan.tif", Tiff { heights: vec![f32::NAN; 400], ..Tiff::plane() }.bytes());
    room.write("infinite.tif", with(f32::INFINITY));
    room.write("undeclared.tif", with(f32::MIN));
    refused(&room, "bands.tif", &["2 bands, none chosen", "give --band N"]);
    refused(&room, "void.tif", &["all 400 samples are void", "check the no-data value"]);
    refused(&room, "nan.tif", &["all 400 samples are void"]);
    refused(&room, "infinite.tif", &["line 3, column 17", "found inf"]);
    refused(&room, "undeclared.tif", &["line 3, column 17", "-3.4028", "give --no-data -3.4028"]);
}

#[test]
fn arrays_that_are_no_ground() {
    let room = Room::new();
    let cases = [
        ("zero.npy", npy("<f8", "(0, 20)", &[]), "0 lines of 20 samples"),
        ("flat.npy", npy("<f8", "(20,)", &doubles(&[0.0; 20])), "expected [lines, columns]"),
        ("infinite.npy", npy("<f8", "(2, 2)", &doubles(&[0.0, 1.0, f64::INFINITY, 2.0])), "line 1, column 0"),
        ("nan.npy", npy("<f8", "(2, 2)", &doubles(&[f64::NAN; 4])), "all 4 samples are void"),
        ("short.npy", npy("<f8", "(20, 20)", &doubles(&[0.0; 20])), "needs 3200 bytes"),
        ("complex.npy", npy("<c16", "(1, 1)", &doubles(&[0.0; 2])), "values of type '<c16'"),
        ("huge.npy", npy("<f8", "(4294967296, 4294967296)", &[]), "more values than this machine"),
    ];
    for (name, bytes, word) in cases {
        room.write(name, bytes);
        let options = ["--region-size-m", "10", "--spacing-m", "10"];
        room.refused(INPUT, &survey(name, &options), &[name, word]);
    }
    room.write("bare.npy", npy("<f8", "(5, 5)", &doubles(&[1.0; 25])));
    refused(&room, "bare.npy", &["does not say how far its samples are apart", "give --spacing-m METRES"]);
}

#[test]
fn damaged_pds3_labels() {
    let room = Room::new();
    room.write("GROUND.IMG", [2, 0, 252, 255, 6, 0, 8, 0, 5, 0, 12, 0]);
    for (old, new, words) in [
        ("\"GROUND.IMG\"", "\"GONE.IMG\"", &["label line 3, ^IMAGE", "GONE.IMG"][..]),
        ("\"GROUND.IMG\"", "\"../GROUND.IMG\"", &["^IMAGE", "expected a file in the folder of the label"]),
        ("\"GROUND.IMG\"", "\"/etc/passwd\"", &["^IMAGE", "expected a file in the folder of the label"]),
        ("\"GROUND.IMG\"", "\"folder\"", &["folder", "this is a folder"]),
        ("LINES = 2", "LINES = 900", &["GROUND.IMG", "has 12 bytes; expected at least 5400"]),
        ("LINES = 2", "LINES = -2", &["label line 6, LINES", "found -2"]),
        ("LINES = 2", "LINES = 0", &["0 lines of 3 samples"]),
        ("LSB_INTEGER", "VAX_REAL", &["label line 8, SAMPLE_TYPE", "VAX_REAL", "IEEE_REAL"]),
        ("SAMPLE_BITS = 16", "SAMPLE_BITS = 12", &["label line 9, SAMPLE_BITS", "8, 16 or 32"]),
        ("FACTOR = 0.5", "FACTOR = nan", &["label line 10, SCALING_FACTOR", "expected a finite number"]),
        ("SIMPLE CYLINDRICAL", "SINUSOIDAL", &["MAP_PROJECTION_TYPE", "SINUSOIDAL"]),
        ("^IMAGE = \"GROUND.IMG\"\n", "", &["label, ^IMAGE: found nothing"]),
    ] {
        assert_eq!(LABEL.matches(old).count(), 1, "{old}");
        room.write("ground.lbl", LABEL.replace(old, new));
        room.refused(INPUT, &survey("ground.lbl", &["--region-size-m", "40"]), words);
    }
    room.write("ground.lbl", &LABEL[..135]);
    refused(&room, "ground.lbl", &["label line 8", "followed by the end", "fetch it again"]);
    refused(&room, "gone.lbl", &["no such file"]);
}

#[test]
fn surveys_that_cannot_be() {
    let room = Room::new();
    room.write("plane.tif", Tiff::plane().bytes());
    for (options, word) in [
        (&["--region-size-m", "0"][..], "expected metres from 0.001 to 1e7"),
        (&["--region-size-m=-5"], "expected metres from 0.001 to 1e7"),
        (&["--region-size-m", "nan"], "expected metres from 0.001 to 1e7"),
        (&["--region-size-m", "0.001"], "give larger regions"),
        (&["--region-size-m", "1e-300"], "expected metres from 0.001 to 1e7"),
        (&["--region-size-m", "1e6"], "expected at most the size of the area, 190 m x 190 m"),
        (&["--levels", "0"], "expected ascending whole numbers that begin with 1"),
        (&["--levels", "1,x"], "--levels"),
        (&["--band", "2"], "band 2 chosen; expected 1 to 1"),
        (&["--area", "0,0,0,0"], "south below north and west below east"),
        (&["--area", "9000,0,9900,900"], "inside south 5.0000"),
        (&["--area", "0,0,1"], "expected four numbers"),
        (&["--spacing-m", "20"], "spacing: found 20,20; expected nothing: the file itself says where"),
        (&["--first-line-south"], "first line south: found true; expected nothing"),
        (&["--centre", "0,0"], "--size-m"),
        (&["--centre", "0,0", "--size-m", "9,9"], "give the area in metres"),
        (
            &["--centre", "-1,2", "--size-m", "-500,500"],
            "expected two lengths in metres, A,B, each from 0.001",
        ),
        (&["--levels", "-1,4"], "expected a whole number of 0 or more"),
        (&["--spacing-m", "-5,5"], "expected two lengths in metres"),
        (&["--spacing-m", "-5"], "expected metres from 0.001 to 1e7"),
        (&["--held-out", "0.9"], "expected 0 to 0.5"),
        (&["--regularisation", "1e300"], "at most 10 region sizes"),
        (&["--spacing-m", "0"], "--spacing-m"),
        (&["--scale", "inf"], "expected a number from -1e9 to 1e9"),
        (&["--scale", "1e300"], "expected a number from -1e9 to 1e9"),
        (&["--offset", "1e300"], "expected a number from -1e9 to 1e9"),
        (&["--area", "0,0,1e300,9"], "expected four numbers from -1e9 to 1e9"),
        (&["--jobs", "0"], "from 1 to 1024"),
    ] {
        room.refused(USAGE, &survey("plane.tif", options), &[word]);
    }
}

/// The word behind `option` in what a refusal says.
fn advised<'a>(said: &'a str, option: &str) -> &'a str {
    let (_, after) = said.split_once(&format!("{option} ")).unwrap_or_else(|| panic!("no {option}: {said}"));
    after.split([' ', '\n']).next().unwrap_or_default()
}

/// Gives the option that each refusal advises until the survey is made; how many refusals there were.
fn followed(room: &Room, file: &str, option: &str) -> usize {
    let mut values: Vec<String> = Vec::new();
    for refusals in 0..5 {
        let given: Vec<&str> = values.iter().flat_map(|value| [option, value.as_str()]).collect();
        let said = room.run(&survey(file, &[&["--region-size-m", "40"], given.as_slice()].concat()));
        if said.code == Some(0) {
            return refusals;
        }
        said.is_one_error(INPUT, &[file, option], file);
        // The values of voids come all at once, names one after the other.
        values.retain(|_| option == "--ignore");
        values.push(advised(&said.err, option).to_owned());
    }
    panic!("{file}: {option} leads in a circle: {values:?}")
}

#[test]
fn advice_leads_out() {
    let room = Room::new();
    let mut plane = Tiff::plane();
    [f32::MIN, 1e30, f32::MIN].iter().enumerate().for_each(|(k, void)| plane.heights[77 + k] = *void);
    room.write("voids.tif", plane.bytes());
    assert_eq!(followed(&room, "voids.tif", "--no-data"), 2);
    let image: Vec<u8> = (0..24 * 24_u16).flat_map(|index| (200 + index % 24).to_le_bytes()).collect();
    room.write("GROUND.IMG", image);
    let label = LABEL
        .replace("LINES = 2\n", "LINES = 24\n  PIXEL_BIAS = 3\n  PIXEL_SHEAR = 4\n")
        .replace("LINE_SAMPLES = 3", "LINE_SAMPLES = 24")
        .replace("SIMPLE CYLINDRICAL", "EQUIRECTANGULAR")
        .replace("  MAP_RESOLUTION = 4 <pix/deg>\n", "")
        .replace("MAP_SCALE = 7.580838 <km/pix>", "MAP_SCALE = 10 <m/pix>")
        .replace("NAME = HEIGHT", "NAME = HEIGHT\n  UNIT = ROD");
    room.write("ground.lbl", &label);
    refused(&room, "ground.lbl", &["PIXEL_BIAS", "--ignore PIXEL_BIAS"]);
    let with = |options: &[&'static str]| {
        let names = ["--ignore", "PIXEL_BIAS", "--ignore", "PIXEL_SHEAR", "--region-size-m", "40"];
        room.run(&survey("ground.lbl", &[&names[..], options].concat()))
    };
    with(&[]).is_one_error(INPUT, &["UNIT", "ROD", "--scale METRES and --offset METRES"], "a unit");
    let said = with(&["--scale", "2", "--offset", "0"]);
    assert_eq!(said.code, Some(0), "{said:?}");
    assert!(
        said.out.contains("PIXEL_BIAS of the file is ignored") && said.out.contains("PIXEL_SHEAR"),
        "{said:?}"
    );
    room.write("ground.lbl", label.replace("UNIT = ROD", "UNIT = METER"));
    assert_eq!(followed(&room, "ground.lbl", "--ignore"), 2);
}

/// A hole is no fault; how far the fit goes astray in it is said.
#[test]
fn ground_without_data_is_told() {
    let room = Room::new();
    let hole = |index: usize| (6..14).contains(&(index / 20)) && (6..14).contains(&(index % 20));
    let mut plane = Tiff::plane();
    (0..400).filter(|index| hole(*index)).for_each(|index| plane.heights[index] = f32::NAN);
    room.write("hole.tif", plane.bytes());
    let out = room.done(&survey("hole.tif", &["--region-size-m", "20", "--json"]));
    let report: serde_json::Value = serde_json::from_str(&out).unwrap();
    assert!(report["levels"][0]["samples"]["void"].as_u64() >= Some(64), "{report}");
    let voids = &report["levels"][0]["in_voids"];
    assert!(voids["regions"].as_u64() >= Some(9), "{voids}");
    let heights = [0, 1].map(|side| voids["heights_m"][side].as_f64().unwrap());
    assert!(heights[0] > 0.0 && heights[1] < 9.5 && voids["steepest"].as_f64() < Some(0.1), "{voids}");
}

/// The hole is drawn, but no wheel stands in it.
#[test]
fn no_data_under_the_wheels() {
    let room = Room::new();
    let hole = |index: usize| (6..14).contains(&(index / 20)) && (6..14).contains(&(index % 20));
    let mut plane = Tiff::plane();
    (0..400).filter(|index| hole(*index)).for_each(|index| plane.heights[index] = f32::NAN);
    room.write("hole.tif", plane.bytes());
    room.done(&survey("hole.tif", &["--region-size-m", "20"]));
    let path = |from: &str, to: &str| {
        format!(
            "keyframes = [\n  {{ t_s = 0, x_m = {from}, y_m = 100 }},\n  {{ t_s = 5, x_m = {to}, y_m = 100 }},\n]"
        )
    };
    room.vary("into.toml", KEYFRAMES, &path("90", "98"));
    room.vary("beside.toml", KEYFRAMES, &path("20", "28"));
    let replay = |scenario: &'static str| ["replay", scenario, "--bank", "x.bank", "--out", "run"];
    room.refused(
        INPUT,
        &replay("into.toml"),
        &["frame 0", "no data under a wheel", "lead the path around it"],
    );
    assert_eq!(room.run(&replay("beside.toml")).code, Some(0));
}
