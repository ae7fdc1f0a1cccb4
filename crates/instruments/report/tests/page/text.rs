//! What stands in the page, whoever reads it.

use std::fs;

use report::{BESIDE, Beside, ReportError, UnitLine, write_page};
use serde_json::{Value, json};

use crate::run_folder::RunFolder;

fn data(page: &str) -> Value {
    let (_, rest) = page.split_once("<script id=\"data\" type=\"application/json\">").expect("data");
    serde_json::from_str(rest.split_once("</script>").expect("an end").0).expect("JSON")
}

#[test]
fn the_same_folder_gives_the_same_bytes() {
    let (a, b) = (RunFolder::new(0, 3), RunFolder::new(0, 3));
    for run in [&a, &b] {
        run.beside(&[(1, 3)]);
    }
    let page = a.page();
    assert_eq!(page, b.page());
    assert_eq!(page, a.page());
    let before = fs::metadata(a.join("index.html")).unwrap().modified().unwrap();
    write_page(a.path()).unwrap();
    assert_eq!(
        fs::metadata(a.join("index.html")).unwrap().modified().unwrap(),
        before,
        "nothing is written twice"
    );
    assert!(!page.contains(a.path().to_str().unwrap()));
}

/// Small frames of the page are PNGs of the layout of the whole ones: bits and colour type stand in their header.
#[test]
fn frames_in_colour_stay_in_colour() {
    let headers = |page: &str| -> Vec<String> {
        let urls = page.split("data:image/png;base64,").filter(|url| url.starts_with("iVBOR"));
        urls.filter_map(|url| url.get(32..36)).map(str::to_owned).collect()
    };
    let (grey, colour) = (RunFolder::new(0, 3), RunFolder::new(0, 3));
    colour.paint();
    for (run, header) in [(grey, "CAAA"), (colour, "CAIA")] {
        run.beside(&[]);
        let found = headers(&run.page());
        assert!(found.len() >= 3 && found.iter().all(|found| found == header), "{header}: {found:?}");
    }
}

#[test]
fn texts_of_a_scenario_cannot_become_markup() {
    let run = RunFolder::new(0, 2);
    run.beside(&[]);
    let page = run.page();
    for strange in ["<bump>", "</script><b>", "& <never>", "<32>", "<b>but"] {
        assert!(!page.contains(strange), "{strange}");
    }
    assert!(
        page.contains("A &lt;bump&gt; &amp; more")
            && page.contains("the ground has none &amp; &lt;never&gt;")
    );
    // Colours, data, script, and the second frame.
    assert_eq!(page.matches("</script>").count(), 4);
    assert_eq!(data(&page)["stage"], "'scenarios/it'\\''s.toml' --sweeps 32");
}

#[test]
fn nothing_comes_from_elsewhere() {
    let run = RunFolder::new(0, 2);
    run.beside(&[(1, 3)]);
    let page = run.page();
    assert!(page.contains("default-src 'none'"));
    for address in ["http://", "https://", "url(", "@import", "src=\"//"] {
        let found: Vec<&str> =
            page.split(address).skip(1).map(|rest| rest.split('"').next().unwrap()).collect();
        let strange: Vec<_> =
            found.iter().filter(|rest| **rest != "www.w3.org/2000/svg" && **rest != "#tip)").collect();
        assert!(strange.is_empty(), "{address} {strange:?}");
    }
}

#[test]
fn every_section_says_what_it_has() {
    let run = RunFolder::new(0, 30);
    run.beside(&[(1, 3)]);
    let page = run.page();
    for part in [
        "24 of 30 frames, evenly spread",
        "none: the same bits",
        "at most 2.5 grey levels of 255",
        "left out: shadow controller",
        "12\u{202f}345",
        "1 deadlines were missed",
        "\u{2212}300 ns",
        "125.0 %",
        "misses are",
        "id=\"scope-1-3\"",
        "Not checked.",
        "--machine exact --frames 0..2 --out runs/exact",
        "Beyond the vehicle: speed of 7.25 m/s, allowed 5 m/s, frames 1 to 3.",
        "<noscript>",
        "aria-label=\"Frame\"",
    ] {
        let part = if part == "misses are" { "the most are 1" } else { part };
        assert!(page.contains(part), "{part}");
    }
    assert!(!page.contains("late words"), "counters that are zero are not named");
    // The contact sheet, and the first frame.
    assert_eq!(page.matches("src=\"data:image/png;base64,").count(), 25);
    assert_eq!(page.matches("type=\"text/plain\"").count(), 29);
    assert!(page.contains("All frames are part of this file, byte for byte."));
    assert_eq!(data(&page)["poses"].as_array().unwrap().len(), 30);
    assert_eq!(data(&page)["scopes"], json!([[1, 3]]));
}

/// Units that do nothing need no row, and of a plot of many signals it is told how they were asked for.
#[test]
fn what_is_long_is_told_shortly() {
    let run = RunFolder::new(0, 3);
    let mut beside = run.beside(&[(1, 3)]);
    let timing = beside.timing.as_mut().unwrap();
    let idle = UnitLine { unit: "drum.0".into(), least: 0.0, mean: 0.0, most: 0.0, longest_queue: 0 };
    timing.units.extend([idle.clone(), UnitLine { unit: "drum.1".into(), ..idle }]);
    beside.scopes[0].signals = (0..13).map(|number| format!("tg.wire{number}")).collect();
    beside.write(run.path()).unwrap();
    let page = run.page();
    assert!(page.contains("At rest throughout: drum.0, drum.1."));
    assert!(page.contains("loader.red</th>") && !page.contains("drum.0</th>"));
    assert!(page.contains("tg.* (13 signals)") && !page.contains("tg.wire3"));
    beside.scopes[0].signals.pop();
    beside.write(run.path()).unwrap();
    assert!(run.page().contains("tg.wire3"));
}

#[test]
fn without_page_json_there_is_still_a_page() {
    let run = RunFolder::new(0, 2);
    let page = run.page();
    assert!(page.contains("Not summed up") && page.contains("No sweep was recorded"));
    assert!(data(&page)["sight"].is_null());
    // That of another run is not believed.
    let mut other = Beside::new("another");
    other.stage = vec!["other.toml".into()];
    other.write(run.path()).unwrap();
    assert_eq!(run.page(), page);
}

#[test]
fn an_exact_run_has_no_machine() {
    let mut run = RunFolder::new(0, 2);
    run.record["generator"] = json!("exact");
    run.record["line"] = json!(null);
    run.record["omissions"] = json!([]);
    run.write_record();
    let page = run.page();
    for part in [
        "exact, without a machine",
        "Nothing was left out",
        "takes no time",
        "no signals",
        "its own reference",
    ] {
        assert!(page.contains(part), "{part}");
    }
    assert!(!page.contains("class=\"diagram\""));
}

#[test]
fn a_check_in_the_record_is_shown() {
    let mut run = RunFolder::new(0, 2);
    let sweep = |sweep: u32, rms: f64| json!({ "frame": 1, "sweep": sweep, "column": sweep, "rms_and_max": [[rms, 0.2], null, null, null] });
    run.record["check"] = json!({
        "against": "exact", "sweeps": 2, "confidence": 0.95, "interval_by": "bootstrap",
        "errors": [
            { "error": "picture", "unit": "1", "rms": 0.0125, "interval": [0.011, 0.014], "max": 0.2 },
            { "error": "height", "unit": "m", "rms": 2.5e-7, "interval": null, "max": 1e-6 },
        ],
        "checked": [sweep(3, 0.011), sweep(5, 0.014)],
    });
    run.write_record();
    let page = run.page();
    for part in [
        "2 sweeps",
        "95 %",
        "0.0125",
        "0.0110 to 0.0140",
        "height (m)",
        "2.50e-7",
        "of one sweep none",
        "#frame=1&amp;sweep=5",
    ] {
        assert!(page.contains(part), "{part}");
    }
    assert!(!page.contains("Not checked."));
}

#[test]
fn one_file_for_each_refresh() {
    let mut run = RunFolder::new(0, 6);
    let files: Vec<Value> =
        run.record["frames"].as_array().unwrap().iter().map(|frame| frame["files"][0].clone()).collect();
    let frame = |index: usize| json!({ "frame": index, "time_s": 0.1, "pixels_blake3": "p", "counts": {}, "files": files[3 * index..3 * index + 3] });
    run.record["frames"] = json!([frame(0), frame(1)]);
    run.record["range"] = json!([0, 2]);
    run.record["pictures"]["one_file_for_each"] = json!("refresh");
    run.write_record();
    let poses = fs::read_to_string(run.join("poses.csv")).unwrap();
    fs::write(run.join("poses.csv"), poses.lines().take(3).collect::<Vec<_>>().join("\n")).unwrap();
    let data = data(&run.page());
    assert_eq!(
        (&data["first"], &data["end"], &data["showings"], &data["rate"]),
        (&json!(0), &json!(6), &json!(3), &json!(30.0))
    );
}

/// Columns that `poses.csv` must have.
const HEADER: &str = "frame,t_s,x_m,y_m,z_m,heading_deg,pitch_deg,roll_deg";

#[test]
fn damaged_folders_are_said_to_be_so() {
    let refused = |run: &RunFolder, word: &str| {
        let error = write_page(run.path()).unwrap_err();
        assert!(error.to_string().contains(word), "{error}");
        assert!(!run.join("index.html").exists());
        error
    };
    let empty = tempfile::tempdir().unwrap();
    assert!(matches!(write_page(empty.path()), Err(ReportError::Run(_))));
    let change = |place: &str, value: Value| {
        let mut run = RunFolder::new(0, 2);
        *run.record.pointer_mut(place).unwrap() = value;
        run.write_record();
        run
    };
    refused(&change("/settings/raster", json!({})), "missing field");
    refused(&change("/frames", json!([])), "it lists 0 frames");
    refused(
        &change("/frames/1/files/0/file", json!("frames/other.png")),
        "expected `frames/frame-000001.png`",
    );
    let run = RunFolder::new(0, 2);
    fs::write(run.join("poses.csv"), format!("{HEADER}\n0,0,0,0,0,0,0,0\n")).unwrap();
    refused(&run, "1 rows, expected one for each of 2 frames");
    fs::write(run.join("poses.csv"), format!("{HEADER}\n0,0,0,0,0,0,0,0\n1,1,x,0,0,0,0,0\n")).unwrap();
    refused(&run, "line 3");
    let run = RunFolder::new(0, 2);
    fs::write(run.join("frames/frame-000001.png"), "no picture").unwrap();
    refused(&run, "frame-000001.png");
    let run = RunFolder::new(0, 2);
    for damaged in ["{", "{}", "{\"schema\":\"lunoid.page/9\"}"] {
        fs::write(run.join(BESIDE), damaged).unwrap();
        assert!(matches!(refused(&run, BESIDE), ReportError::Content { .. }));
    }
}

/// A plot that was changed or lost is not shown as if it were that of the run.
#[test]
fn only_whole_plots_are_shown() {
    let run = RunFolder::new(0, 3);
    let beside = run.beside(&[(1, 3), (2, 4)]);
    assert_eq!(Beside::read(run.path(), &beside.fingerprint).unwrap(), beside);
    fs::write(run.join(&beside.scopes[0].file()), "<svg/>").unwrap();
    let page = run.page();
    assert!(!page.contains("scope-1-3\"") && page.contains("scope-2-4\""));
    fs::remove_dir_all(run.join("scopes")).unwrap();
    assert!(run.page().contains("No sweep was recorded"));
}
