//! The scenery's bad input one by one: solids, craters, suns and events that cannot be, each with its place; and what
//! is only much of something, which is drawn.

use crate::room::{INPUT, KEYFRAMES, Room, TINY};

const CUBE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n\
                    f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

/// A pyramid whose base is pushed out through a side: every face is plane, all close.
const CROSSED: &str = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 3 1 1\nv 1 1 2\n\
                       f 1 2 6\nf 2 3 6\nf 3 4 6\nf 4 1 6\nf 2 1 5\nf 3 2 5\nf 4 3 5\nf 1 4 5\n";

/// A pyramid whose base is pushed in: every face is plane, all close.
const NOTCH: &str = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 1 1 0.5\nv 1 1 2\n\
                     f 1 2 6\nf 2 3 6\nf 3 4 6\nf 4 1 6\nf 2 1 5\nf 3 2 5\nf 4 3 5\nf 1 4 5\n";

/// What is not convex is drawn in parts, and said; so is a file without a unit.
#[test]
fn shapes_that_are_split_are_told() {
    let room = Room::new();
    room.write("notch.obj", format!("mtllib a.mtl\n{NOTCH}"));
    room.write("s.toml", format!("{TINY}\n{}", object("file = \"notch.obj\"")));
    let said = room.run(&["check", "s.toml"]);
    for words in ["notch.obj: materials are not read", "notch.obj: not convex: 1 shape split into "] {
        assert!(said.code == Some(0) && said.err.contains(words), "{said:?}");
    }
}

const HEADING: &str = "x_m,y_m,radius_m,depth_m,rim_m,type,outer_m,floor_m";

/// `tiny.toml` with more tables as `s.toml`: refused by a replay and a check, with the same words.
fn refused(room: &Room, tables: &str, words: &[&str]) {
    room.write("s.toml", format!("{TINY}\n{tables}"));
    for command in ["replay", "check"] {
        room.refused(INPUT, &[command, "s.toml"], words);
    }
}

fn object(shape: &str) -> String {
    format!("[[object]]\nid = \"mast\"\n{shape}\nx_m = 100\ny_m = 100\n")
}

#[test]
fn solids_say_which_face_is_wrong_and_how() {
    let room = Room::new();
    room.write("cube.obj", CUBE);
    room.write("s.toml", format!("{TINY}\n{}", object("file = \"cube.obj\"")));
    room.done(&["check", "s.toml"]);
    for (text, words) in [
        (CROSSED.to_owned(), &["crosses itself", "a.obj:7:1", "open = true"][..]),
        (CUBE.replace("f 4 1 5 8", "f 4 1 8 5"), &["degenerate face", "a.obj:14:1", "no area"]),
        (format!("{CUBE}f 1 2 1 3\n"), &["degenerate face", "a.obj:15:1", "stands twice"]),
        (CUBE.replace("v 1 1 1", "v 1 1 0.4"), &["degenerate face", "a.obj:10:1", "not in one plane"]),
        (format!("{CUBE}v 0.5 0.5 0\nf 1 9 2\n"), &["branching", "has 3 faces", "a.obj"]),
        (format!("{CUBE}f 1 2 99\n"), &["a.obj:15:7", "corner 99", "8 stand above"]),
        (CUBE.replace("v 1 1 1", "v 1 1 nan"), &["a.obj:7:7", "finite", "nan"]),
        ("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".into(), &["a.obj", "no solid"]),
    ] {
        room.write("a.obj", &text);
        refused(&room, &object("file = \"a.obj\""), words);
    }
}

#[test]
fn objects_of_no_size_or_place() {
    let room = Room::new();
    let lander = object("model = \"lander\"");
    for (old, new, words) in [
        ("x_m = 100", "x_m = 100\nscale = 0", &["object[0].scale", "above 0"][..]),
        ("x_m = 100", "x_m = 100\nscale = -2", &["object[0].scale", "above 0"]),
        ("x_m = 100", "x_m = 100\nheading_deg = nan", &["object[0].heading_deg", "nan"]),
        ("x_m = 100", "x_m = -0.5", &["object \"mast\"", "outside the problem area"]),
    ] {
        refused(&room, &lander.replace(old, new), words);
    }
}

#[test]
fn craters_say_which_radius_is_wrong() {
    let room = Room::new();
    for (row, words) in [
        ("200,200,10,2,1,2,8,", &["c.csv:2:18", "`outer_m`", "above radius_m = 10", "not 8"][..]),
        ("200,200,10,2,1,2,10,", &["c.csv:2:18", "`outer_m`", "not 10"]),
        ("200,200,10,2,1,3,9,4", &["c.csv:2:18", "`outer_m`", "not 9"]),
        ("200,200,10,2,1,3,14,12", &["c.csv:2:21", "`floor_m`", "below radius_m = 10", "not 12"]),
        ("200,200,10,2,1,3,14,0", &["`floor_m`", "above 0"]),
        ("200,200,0,2,1,2,,", &["c.csv:2:9", "`radius_m`", "above 0", "not 0"]),
        ("200,200,-4,2,1,2,,", &["c.csv:2:9", "`radius_m`", "above 0", "not -4"]),
        ("200,200,10,inf,1,2,,", &["c.csv:2:12", "`depth_m`", "inf"]),
        ("200,200,10,2,1,1,,", &["c.csv:2:14", "`rim_m`", "type 1 has no rim"]),
        ("-5,200,10,2,1,2,,", &["c.csv: row 1", "x = -5 m", "not wholly inside", "y 0..400 m"]),
        ("200,390,10,2,1,2,14,", &["c.csv: row 1", "y = 390 m", "not wholly inside"]),
    ] {
        room.write("c.csv", format!("{HEADING}\n{row}\n"));
        refused(&room, "[features]\nlist = \"c.csv\"\n", words);
    }
}

#[test]
fn suns_that_set_at_the_start_or_on_their_way() {
    let room = Room::new();
    let drift = |second: &str| {
        format!(
            "elevation_deg = 3\nstep_s = 1\ndrift = [{{ t_s = 2, azimuth_deg = 0, elevation_deg = 1 }}, {second}]"
        )
    };
    for (new, words) in [
        ("elevation_deg = -0.001".to_owned(), &["sun.elevation_deg", "above 0", "-0.001"][..]),
        ("elevation_deg = nan".to_owned(), &["sun.elevation_deg", "nan"]),
        (
            drift("{ t_s = 4, azimuth_deg = 0, elevation_deg = 0 }"),
            &["sun.drift[1].elevation_deg", "above 0"],
        ),
        (drift("{ t_s = 1, azimuth_deg = 0, elevation_deg = 2 }"), &["s.toml:21:67", "times must ascend"]),
    ] {
        room.vary("s.toml", "elevation_deg = 15", &new);
        for command in ["replay", "check"] {
            room.refused(INPUT, &[command, "s.toml"], words);
        }
    }
}

#[test]
fn events_that_cannot_happen() {
    let room = Room::new();
    let event = |time: &str, rest: &str| format!("[[event]]\nt_s = {time}\n{rest}\n");
    let gone = "action = \"delete\"\nobject = \"mast\"";
    let moved = "action = \"move\"\nobject = \"mast\"\nx_m = 120\ny_m = 90";
    for (events, words) in [
        (
            event("1", "action = \"move\"\nobject = \"flag\"\nx_m = 1\ny_m = 1"),
            &["event[0].object", "flag"][..],
        ),
        (event("1", "action = \"add\"\nobject = \"mats\""), &["event[0].object", "did you mean \"mast\"?"]),
        (event("1", gone) + &event("2", gone), &["mast", "t = 2 s"]),
        (event("1", gone) + &event("2", moved), &["mast", "t = 2 s"]),
        (event("1", gone) + &event("1", moved), &["mast", "t = 1 s"]),
        (event("-1", gone), &["event[0].t_s"]),
        (event("1", "action = \"explode\"\nobject = \"mast\""), &["event[0].action", "explode"]),
        (event("1", &moved.replace("x_m = 120", "x_m = 1200")), &["mast", "outside the problem area"]),
    ] {
        refused(&room, &format!("{}{events}", object("model = \"lander\"")), words);
    }
}

/// A hundred craters, each inside the one before, are drawn, by the machine as by `exact`.
#[test]
fn a_hundred_nested_craters_are_no_fault() {
    let room = Room::new();
    let row = |index| {
        let r = 60.0 - 0.55 * f64::from(index);
        format!("180,210,{r:.4},{:.5},{:.5},2,{:.4},\n", 0.004 * r, 0.001 * r, 1.2 * r)
    };
    room.write("c.csv", format!("{HEADING}\n{}", (0..100).map(row).collect::<String>()));
    room.write("s.toml", format!("{TINY}\n[features]\nlist = \"c.csv\"\n"));
    room.done(&["replay", "s.toml", "-q", "--out", "h"]);
    room.done(&["replay", "s.toml", "-q", "--machine", "exact", "--out", "e"]);
    room.done(&["compare", "h", "e", "--tolerance", "2", "--share", "2"]);
    let record: serde_json::Value = serde_json::from_slice(&room.read("h/run.json")).unwrap();
    let counts = &record["frames"][0]["counts"];
    assert!(counts["features"].as_u64().is_some_and(|count| count > 1000), "{counts}");
    assert_eq!(counts["dropped_features"], 0, "{counts}");
}

/// Thousands of track patches, seen from the vehicle that backs away from them.
#[test]
fn thousands_of_shadow_segments_are_no_fault() {
    let room = Room::new();
    let back = TINY.replace(
        KEYFRAMES,
        "keyframes = [{ t_s = 0, x_m = 100, y_m = 200, heading_deg = 180 }, { t_s = 0.3, x_m = 300, y_m = 200, heading_deg = 180 }]",
    );
    let tracks = "[shadows]\nfinest_m = 1\n[tracks]\npatch_length_m = 0.05\nspacing_m = 0.1\n";
    room.write("s.toml", format!("{back}\n{tracks}"));
    let said = room.run(&["replay", "s.toml", "-q", "--out", "h"]);
    assert_eq!((said.code, said.errors()), (Some(0), 0), "{said:?}");
    let record: serde_json::Value = serde_json::from_slice(&room.read("h/run.json")).unwrap();
    let last = &record["frames"][3]["counts"];
    assert!(last["shadow_toggles"].as_u64().is_some_and(|toggles| toggles > 1500), "{last}");
    assert_eq!(last["dropped_segments"], 0, "{last}");
}
