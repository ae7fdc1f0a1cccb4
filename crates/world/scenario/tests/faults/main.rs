//! Every kind of fault of a scenario and of a path file is found, at its place.

mod paths;
mod things;

use std::fs;

use crate::paths::path_faults;
use proptest::prelude::*;
use quantities::Rate;
use scenario::{Length, Overrides, Scenario};

const GOOD: &str = r#"format = 1
title = "t"
shows = "s"
frames = 90
[landscape.generated]
seed = 1
extent_m = [600, 600]
region_size_m = 40
[sun]
azimuth_deg = 10
elevation_deg = 12
[path]
keyframes = [{ t_s = 0, x_m = 50, y_m = 80 }, { t_s = 3, x_m = 51, y_m = 80 }]
[raster]
update_hz = 30
refresh_hz = 60
"#;

/// Line and title of each problem.
fn faults(text: &str) -> Vec<(Option<usize>, String)> {
    match Scenario::parse("t.toml", text) {
        Ok(_) => Vec::new(),
        Err(list) => list.iter().map(|problem| (problem.record().line, problem.title.clone())).collect(),
    }
}

/// The one fault that a change of the good scenario makes.
fn fault(from: &str, to: &str) -> (Option<usize>, String) {
    assert!(GOOD.contains(from), "{from}");
    let mut found = faults(&GOOD.replacen(from, to, 1));
    assert_eq!(found.len(), 1, "{from} -> {to}: {found:?}");
    found.remove(0)
}

#[test]
fn the_good_one_is_good() {
    assert_eq!(faults(GOOD), []);
}

#[test]
fn one_reading_lists_every_fault() {
    let bad = r#"format = 1
titel = "t"
shows = "s"
[landscape.generated]
seed = 1
extent_m = [6000, nan]
region_size_m = 0
[sun]
azimuth_deg = inf
elevation_deg = -3
[path]
keyframes = [{ t_s = 0, x_m = "a", y_m = 80 }]
[raster]
update_hz = 29.97
sweeps = 0
"#;
    let found = faults(bad);
    let lines: Vec<usize> = found.iter().filter_map(|fault| fault.0).collect();
    for line in [2, 6, 7, 9, 10, 12, 14, 15] {
        assert!(lines.contains(&line), "line {line}: {found:#?}");
    }
    assert!(found.iter().any(|fault| fault.1.contains("missing key `title`")), "{found:#?}");
    assert!(found.iter().any(|fault| fault.1.contains("missing key `frames` or `duration_s`")));
    assert_eq!(found.len(), 10, "{found:#?}");
}

#[test]
fn messages_name_line_found_expected_and_nearest() {
    let list = Scenario::parse("s.toml", &GOOD.replace("refresh_hz", "refresch_hz")).unwrap_err();
    let text = list.to_string();
    assert!(text.contains("s.toml:16:1") && text.contains("did you mean `refresh_hz`?"), "{text}");
    let list = Scenario::parse("s.toml", &GOOD.replace("azimuth_deg = 10", "azimuth_deg = 400")).unwrap_err();
    let expected = "`sun.azimuth_deg` must be a number from -360 to 360 degrees, not 400";
    assert_eq!(list.iter().next().unwrap().title, expected);
}

#[test]
fn each_cross_check() {
    let cases = [
        ("format = 1", "format = 2", "newer than"),
        ("format = 1", "", "missing key `format`"),
        ("frames = 90", "frames = 90\nduration_s = 3", "both say how long"),
        ("frames = 90", "", "missing key `frames` or `duration_s`"),
        ("frames = 90", "frames = 0", "from 1 to"),
        ("frames = 90", "machine = '../ideal'\nframes = 90", "a name of letters"),
        ("seed = 1", "seed = 1\nbank = 'a'", "unknown key"),
        (
            "[landscape.generated]",
            "[landscape]\nbank = 'a'\n[landscape.generated]",
            "both say what the ground",
        ),
        ("extent_m = [600, 600]", "extent_m = [600, 610]", "a whole number of regions"),
        ("extent_m = [600, 600]", "extent_m = [600]", "an array of 2 numbers"),
        ("refresh_hz = 60", "refresh_hz = 45", "no whole multiple"),
        ("refresh_hz = 60", "refresh_hz = \"60000/1001\"", "no whole multiple"),
        ("update_hz = 30", "update_hz = 29.97", "a fraction in quotes"),
        ("update_hz = 30", "update_hz = \"30/0\"", "a fraction in quotes"),
        ("update_hz = 30", "update_hz = 0", "a fraction in quotes"),
        ("t_s = 3", "t_s = 0", "times must ascend"),
        ("t_s = 0", "t_s = -1", "from 0 to"),
        ("x_m = 51", "x_m = nan", "not nan"),
        ("y_m = 80 }]", "y_m = 80, h_m = 3 }]", "unknown key `path.keyframes[1].h_m`"),
        ("y_m = 80 }]", "y_m = 80, z_m = 3 }]", "z_m is given for some waypoints only"),
        ("y_m = 80 }]", "y_m = 80, pitch_deg = 361 }]", "from -360 to 360"),
        ("[sun]", "[range]\nprogramme = 'geometric'\nstart_m = 5\nend_m = 5\n[sun]", "must be more than"),
        (
            "[sun]",
            "[range]\nprogramme = 'two-rate'\nstart_m = 5\nend_m = 6\nfine_share = 0.5\n[sun]",
            "`range.switch_m`",
        ),
        (
            "[sun]",
            "[range]\nprogramme = 'two-rate'\nstart_m = 5\nend_m = 6\nswitch_m = 7\nfine_share = 0.5\n[sun]",
            "must be more than `range.switch_m`",
        ),
        ("[sun]", "[laws]\nprojection = 'exakt'\n[sun]", "one of \"as-reported\""),
        (
            "[sun]",
            "[[landscape.generated.massif]]\nat_m = [1, 2]\nheight_m = 5\nradius_m = 50\ndetail_m = 120\n[sun]",
            "massifs[0].radius",
        ),
    ];
    for (from, to, expected) in cases {
        let (line, title) = fault(from, to);
        assert!(line.is_some() && title.contains(expected), "{from} -> {to}: {title}");
    }
}

#[test]
fn fractions_are_exact() {
    let text = GOOD.replace("update_hz = 30", "update_hz = \"30000/1001\"");
    let text = text.replace("refresh_hz = 60", "refresh_hz = \"60000/1001\"");
    let scenario = Scenario::parse("t.toml", &text).unwrap_or_else(|list| panic!("{list}"));
    assert_eq!(scenario.raster.update, Rate::new(30_000, 1001));
    assert_eq!(scenario.raster.refresh, Rate::new(60_000, 1001));
}

#[test]
fn a_duration_is_the_frames_that_begin_in_it() {
    let good = Scenario::parse("t.toml", GOOD).unwrap_or_else(|list| panic!("{list}"));
    let frames = |seconds: f64, numerator, denominator| {
        let scenario = Scenario { length: Length::Seconds(seconds), ..good.clone() };
        scenario.frames(Rate::new(numerator, denominator).unwrap())
    };
    assert_eq!(frames(3.0, 30, 1), 90);
    // In floating point 8.3 x 30 is a little more than 249.
    assert_eq!(frames(8.3, 30, 1), 249);
    assert_eq!(frames(3.0, 30_000, 1001), 90);
    assert_eq!(frames(0.001, 30, 1), 1);
    assert_eq!(good.frames(Rate::new(5, 1).unwrap()), 90);
}

#[test]
fn references_stay_in_the_folder() {
    for reference in ["../x.bank", "/etc/x.bank", "a/../../x.bank"] {
        let text =
            GOOD.replace("[landscape.generated]", &format!("[landscape]\nbank = '{reference}'\n[unused]"));
        let found = faults(&text);
        assert!(found.iter().any(|fault| fault.1.contains("stays in the scenario's folder")), "{found:?}");
    }
}

#[test]
fn files_that_are_no_scenario() {
    let folder = tempfile::tempdir().unwrap();
    let missing = Scenario::read(folder.path().join("no.toml")).unwrap_err().to_string();
    assert!(missing.contains("no such file"), "{missing}");
    let a_folder = Scenario::read(folder.path()).unwrap_err().to_string();
    assert!(a_folder.contains("folder"), "{a_folder}");
    let binary = folder.path().join("binary.toml");
    fs::write(&binary, [0x66, 0xff, 0x00]).unwrap();
    assert!(Scenario::read(&binary).unwrap_err().to_string().contains("not UTF-8"));
    assert!(faults("format = = 1")[0].1.contains("not valid TOML"));
    let good = folder.path().join("good.toml");
    fs::write(&good, GOOD).unwrap();
    assert!(Scenario::read(&good).is_ok());
}

/// The one fault of the good scenario with more tables.
fn fault_of(tables: &str) -> String {
    let (line, title) = fault("[sun]", &format!("{tables}\n[sun]"));
    assert!(line.is_some(), "{tables}: {title}");
    title
}

/// Rules of generated ground are the landscape's, its names are not the keys.
#[test]
fn ground_that_does_not_fit_is_shown_at_its_key() {
    let undulation =
        "\n[landscape.generated.undulation]\nrms_height_m = 1\nhurst = 0.7\nshortest_m = 5\nlongest_m = 200";
    let massif = |radius: &str| {
        let at = "at_m = [300, 300]\nheight_m = 50\ndetail_m = 200";
        format!("\n[[landscape.generated.massif]]\n{at}\nruggedness = 0.2\nradius_m = {radius}")
    };
    let crater = "\n[landscape.generated.craters]\nsmallest_radius_m = 200\nlargest_radius_m = 400";
    let coarse = "\n[landscape.coarse]\nseed = 2\nregion_size_m = 200\nextent_m = [1401, 1400]";
    for (parts, line) in [
        (undulation.into(), 12),
        (massif("500") + &massif("90"), 20),
        (format!("{crater}\nsubdued_depth_ratio = 0.2\nfresh_depth_ratio = 0.1"), 13),
        (coarse.into(), 12),
        (format!("{}\n[levels]\nswitch_m = 50", coarse.replace("1401", "1600")), 12),
    ] {
        let (found, title) = fault("region_size_m = 40", &format!("region_size_m = 40{parts}"));
        assert!(title.contains("does not fit"), "{title}");
        assert_eq!(found, Some(line), "{title}");
    }
    assert_eq!(fault("[600, 600]", "[601, 600]").0, Some(7), "its extent");
}

#[test]
fn parts_of_the_landscape_that_cannot_be() {
    let coarse = "[landscape.coarse]\nseed = 2\nextent_m = [1400, 1400]\nregion_size_m = 200\n";
    let population = "[[features.population]]\nseed = 1\nkind = 'fresh'\ndensity_per_m2 = 0.01\n\
                      smallest_radius_m = 2\nlargest_radius_m = 4\n";
    let rocks = "[rocks]\nseed = 1\ndensity_per_m2 = 0.1\nsmallest_m = 0.2\nlargest_m = 2\n";
    let drift = |step: &str| {
        format!("azimuth_deg = 10\n{step}drift = [{{ t_s = 5, azimuth_deg = 9, elevation_deg = 8 }}]")
    };
    for (tables, expected) in [
        (coarse.to_owned(), "`landscape.coarse` without `levels`"),
        ("[levels]\nswitch_m = 50".into(), "`levels` on ground of one level"),
        (coarse.replace("1400]", "1401]") + "[levels]\nswitch_m = 50", "generated landscape does not fit"),
        (coarse.replace("200", "140") + "[levels]\nswitch_m = 50", "does not fit around the fine one"),
        (format!("{coarse}[levels]\nswitch_m = 50\nblend_m = 51"), "longer than the way"),
        (population.replace("'fresh'", "'secondaries'"), "secondaries without primaries"),
        (population.replace("= 2", "= 5"), "is above the largest"),
        (format!("{population}area_m = [0, 0, 0, 5]\n"), "in ascending order"),
        ("[features]\nlist = 'gone.csv'".into(), ""),
        (rocks.to_owned(), "missing key `rocks.area_m` or `rocks.radius_m`"),
        (format!("{rocks}radius_m = 5\narea_m = [1, 2, 3, 4]"), "both say where the rocks are"),
        (rocks.replace("= 2\n", "= 0.1\n") + "radius_m = 5", "is not above the smallest"),
        ("[photometry]\nlaw = 'specular'\nstrength = 1".into(), "missing key `photometry.exponent`"),
        ("[texture]\nsource = 'random'".into(), "a texture of 0 layers"),
        ("[[silhouette]]\nreflectivity = 1\noutline_deg = [[0, 1], [0, 2]]".into(), "this outline is none"),
        ("[[silhouette]]\nreflectivity = 1\noutline_deg = [[0, 1], [0]]".into(), "an array of pairs"),
        ("[shadows]\n[tracks]\nspacing_m = 0".into(), "from 0.01 to 100"),
        ("[tracks]".into(), "`[tracks]` without `[shadows]`"),
        ("[vehicle]\nmodel = 'rover'".into(), "`vehicle.model` without `[shadows]`"),
        ("[shadows]\n[vehicle]\nmodel = 'rover'\nfile = 'a.obj'".into(), "both say what it is"),
        ("[shadows]\nfinest_m = 0".into(), "from 0.01 to 1000"),
        ("[roll]\ndisplay = 'yolk'".into(), "must be one of \"none\", \"yoke\""),
        ("rocks = 5".into(), "`landscape.generated.rocks`"),
    ] {
        let text = GOOD.replacen("[sun]", &format!("{tables}\n[sun]"), 1);
        let found = faults(&text);
        assert!(found.len() == 1 && found[0].1.contains(expected), "{tables}: {found:?}");
    }
    for (from, to, expected) in [
        ("azimuth_deg = 10", drift(""), "missing key `sun.step_s`"),
        ("azimuth_deg = 10", drift("step_s = 0\n"), "above 0"),
        ("azimuth_deg = 10", drift("step_s = 1e-6\n"), "5000000 steps"),
        ("azimuth_deg = 10", drift("step_s = 1\n").replace("= 8", "= -1"), "above 0"),
        ("azimuth_deg = 10", drift("step_s = 1\n").replace("t_s = 5", "t_s = 0"), "above 0"),
        ("azimuth_deg = 10", "azimuth_deg = 10\nstep_s = 1".into(), "`sun.step_s` without `sun.drift`"),
        ("elevation_deg = 12", "elevation_deg = -1".into(), "above 0"),
    ] {
        let (_, title) = fault(from, &to);
        assert!(title.contains(expected), "{to}: {title}");
    }
}

/// A `[sun]` with `keys` for the good scenario.
fn sun(keys: &str) -> String {
    GOOD.replace("azimuth_deg = 10\nelevation_deg = 12", keys)
}

const PLACE: &str = "place = { longitude_deg = 30.77, latitude_deg = 20.19 }";
const AT: &str = "at = '1972-12-11T22:00:00Z'";
const UNDER: &str = "sub_solar_deg = [1.5, 80]";

#[test]
fn a_sun_has_angles_a_date_or_a_place_under_it() {
    for good in [format!("{AT}\n{PLACE}"), format!("{AT}\n{PLACE}\nstep_s = 5"), format!("{UNDER}\n{PLACE}")]
    {
        assert_eq!(faults(&sun(&good)), [], "{good}");
    }
    for (keys, line, expected) in [
        (
            String::new(),
            9,
            "missing keys `sun.azimuth_deg` and `sun.elevation_deg`, or `sun.at`, or `sun.sub_solar_deg`",
        ),
        (UNDER.into(), 10, "`sun.sub_solar_deg` without `sun.place`: generated ground lies nowhere"),
        (format!("{AT}\n{PLACE}\n{UNDER}"), 12, "`sun.sub_solar_deg` beside `sun.at`"),
        (format!("{UNDER}\n{PLACE}\nazimuth_deg = 10"), 12, "`sun.azimuth_deg` beside `sun.sub_solar_deg`"),
        (format!("{UNDER}\n{PLACE}\nstep_s = 10"), 12, "`sun.step_s` beside `sun.sub_solar_deg`"),
        (format!("{UNDER}\n{PLACE}\ndrift = [{{ t_s = 5 }}]"), 12, "`sun.drift` beside `sun.sub_solar_deg`"),
        (format!("{UNDER}\n{PLACE}").replace("1.5", "91"), 10, "latitude -90 to 90"),
        (format!("{UNDER}\n{PLACE}").replace("80", "361"), 10, "longitude -360 to 360"),
        (format!("{UNDER}\n{PLACE}").replace("[1.5, 80]", "[1.5]"), 10, "2 numbers"),
        (AT.into(), 10, "generated ground lies nowhere on the Moon"),
        (format!("{AT}\n{PLACE}\nazimuth_deg = 10"), 12, "`sun.azimuth_deg` beside `sun.at`"),
        (format!("{AT}\n{PLACE}\nelevation_deg = 10"), 12, "`sun.elevation_deg` beside `sun.at`"),
        (format!("{AT}\n{PLACE}\ndrift = [{{ t_s = 5 }}]"), 12, "`sun.drift` beside `sun.at`"),
        (format!("azimuth_deg = 1\nelevation_deg = 2\n{PLACE}"), 12, "`sun.place` without `sun.at`"),
        (format!("at = '1972-12-11'\n{PLACE}"), 10, "expected a date and time such as 1972-12-11T22:00:00Z"),
        (format!("at = '1972-12-11T22:00:00'\n{PLACE}"), 10, "the time zone is missing"),
        (format!("at = '1959-12-11T22:00:00Z'\n{PLACE}"), 10, "expected a year from 1960 to 2050"),
        (format!("at = '1972-12-32T22:00:00Z'\n{PLACE}"), 10, "no day 32"),
        (format!("at = 1972-12-11T22:00:00Z\n{PLACE}"), 10, "must be one line of text in quotes, not a date"),
        (format!("{AT}\n{PLACE}").replace("30.77", "361"), 11, "from -360 to 360"),
        (format!("{AT}\n{PLACE}").replace("20.19", "-91"), 11, "from -90 to 90"),
        (format!("{AT}\nplace = {{ longitude_deg = 1 }}"), 11, "missing key `sun.place.latitude_deg`"),
        (format!("{AT}\n{PLACE}").replace("latitude_deg", "lattitude_deg"), 11, ""),
        (format!("{AT}\nplace = [30, 20]"), 11, "must be a table"),
        (format!("{AT}\n{PLACE}\nstep_s = 0"), 12, "above 0"),
    ] {
        let found = faults(&sun(&keys));
        assert!(found.iter().all(|fault| fault.0 == Some(line)), "{keys}: {found:?}");
        assert!(!found.is_empty() && found[0].1.contains(expected), "{keys}: {found:?}");
        assert!(found.len() == 1 || expected.is_empty(), "{keys}: {found:?}");
    }
}

#[test]
fn a_field_of_view_has_two_angles_or_square_pixels() {
    let of = |keys: &str| {
        let text = format!("{GOOD}{keys}");
        Scenario::parse("t.toml", &text)
            .unwrap_or_else(|list| panic!("{keys}: {list}"))
            .field
            .of_picture(640, 480)
    };
    let square = of("field_of_view_deg = 60\nlines = 480");
    assert!((square.tan_half_width - libm::tan(0.5 * quantities::radians(60.0))).abs() < 1e-15);
    assert!((square.tan_half_height / square.tan_half_width - 0.75).abs() < 1e-15);
    assert_eq!(of("field_of_view_deg = [50, 30]"), of(""));
    for (keys, expected) in [
        ("field_of_view_deg = 60", "is one angle, without `raster.lines`"),
        ("field_of_view_deg = 0\nlines = 480", "from 0.1 to 170"),
        (
            "field_of_view_deg = [60]\nlines = 480",
            "an array of 2 numbers, from 0.1 to 170 degrees, not 1 of them",
        ),
        ("field_of_view_deg = [60, 50, 40]", "not 3 of them"),
        ("field_of_view_deg = '60'\nlines = 480", "must be a number"),
        ("field_of_view_deg = [60, 171]", "from 0.1 to 170"),
    ] {
        let found = faults(&format!("{GOOD}{keys}\n"));
        assert!(found.len() == 1 && found[0].1.contains(expected), "{keys}: {found:?}");
    }
}

#[test]
fn single_keys_go_over_those_of_the_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("s.toml");
    fs::write(&path, GOOD).unwrap();
    let read = |sets: &[(&str, &str)]| Scenario::read_over(&path, &[], Overrides { sets, bank: None });
    let over = read(&[("frames", "7"), ("raster.columns", "33"), ("title", "\"over\"")]).unwrap();
    assert_eq!(
        (over.length, over.raster.columns, over.title.as_str()),
        (Length::Frames(7), Some(33), "over")
    );
    assert_eq!(over.path.waypoints().len(), 2);
    for (key, value, expected) in [
        ("raster.colums", "33", "unknown key `raster.colums`"),
        ("raster.columns", "0", "must be a whole number from 1 to 8192"),
        ("raster.columns", "", "not valid TOML"),
        ("", "3", "not valid TOML"),
        ("raster", "3", "must be a table"),
        ("sun.at", "'1972-12-11T22:00:00Z'", "generated ground lies nowhere"),
    ] {
        let list = read(&[(key, value)]).unwrap_err();
        let first = list.iter().next().unwrap();
        assert!(first.title.contains(expected), "{key} = {value}: {}", first.title);
    }
}

const FULL: &str = include_str!("../../../../../docs/scenario-format.md");

proptest! {
    #[test]
    fn damage_is_refused_or_read_and_never_panics(
        example in 0usize..3,
        cuts in prop::collection::vec((0usize..4000, 0usize..12, "[-a-z0-9_=.,\"'\\[\\]{}\n# ]{0,6}"), 1..6),
    ) {
        let start = FULL.match_indices("```toml\n").nth(example).unwrap().0 + 8;
        let mut text = FULL[start..start + FULL[start..].find("```").unwrap()].to_owned();
        for (at, length, put) in cuts {
            let at = at.min(text.len());
            text.replace_range(at..(at + length).min(text.len()), &put);
        }
        let _ = Scenario::parse("t.toml", &text).map_err(|list| list.render(true));
    }

    #[test]
    fn damaged_paths_never_panic(rows in "[0-9naif.,eE\"\u{e4} #\r\n-]{0,80}") {
        path_faults("p.csv", &format!("t_s,x_m,y_m,z_m\n{rows}"));
        path_faults("p.csv", &rows);
        path_faults("p.tum", &rows);
    }
}

/// A bank that takes the place of generated ground lies somewhere on the Moon, so a date needs no place beside it.
#[test]
fn a_date_goes_by_the_ground_that_is_taken() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("s.toml");
    let angles = "azimuth_deg = 10\nelevation_deg = 12";
    fs::write(&path, GOOD.replace(angles, "at = \"1972-12-11T22:00:00Z\"")).unwrap();
    let bank = folder.path().join("other.bank");
    let read = |bank| Scenario::read_over(&path, &[], Overrides { sets: &[], bank });
    assert!(read(Some(bank.as_path())).is_ok());
    assert!(read(None).unwrap_err().to_string().contains("generated ground lies nowhere"));
}
