//! What is too much is refused with the name by which it is allowed; allowed, it is taken.

use std::collections::BTreeSet;

use limits::ROWS;

use crate::build::{doubles, npy};
use crate::room::{INPUT, KEYFRAMES, Room, TINY, USAGE};

/// Something limited, small: the same law holds for a limit that is set lower.
struct Case {
    limit: &'static str,
    /// The file that is refused.
    file: &'static str,
    /// Makes that file, and says how much it has of what is limited.
    make: fn(&Room) -> u64,
    /// The command that reads it.
    command: &'static [&'static str],
}

const CHECK: &[&str] = &["check", "s.toml"];
const SURVEY: &[&str] = &["survey", "a.npy", "--spacing-m", "5", "--region-size-m", "40", "-o", "new.bank"];
const AUGMENT: &[&str] =
    &["augment", "run/frames", "run/poses.csv", "--vehicle", "rover", "--sun", "212,6", "--out", "new"];

/// `tiny.toml` with more tables as `s.toml`.
fn add(room: &Room, tables: &str) {
    room.write("s.toml", format!("{TINY}\n{tables}"));
}

/// How many bytes a file has.
fn bytes(room: &Room, name: &str) -> u64 {
    room.read(name).len() as u64
}

/// The same law as [`craters`], over the ground and as far around it as a crater reaches.
fn ground_craters(room: &Room) -> u64 {
    let craters = "smallest_radius_m = 80\nlargest_radius_m = 160\ndensity = 0.5\n";
    add(room, &format!("[landscape.generated.craters]\n{craters}"));
    16
}

/// `N(> D) = density D^-2`, between the two diameters and over the area of the ground.
fn craters(room: &Room) -> u64 {
    let law = "density_per_m2 = 0.01\nsmallest_radius_m = 1\nlargest_radius_m = 2\n";
    add(room, &format!("[[features.population]]\nseed = 1\nkind = \"fresh\"\n{law}"));
    (0.01 * (0.25 - 0.0625) * 400.0 * 400.0) as u64
}

/// As many as lie in the box by its seed.
fn rocks(room: &Room) -> u64 {
    add(
        room,
        "[rocks]\nseed = 1\ndensity_per_m2 = 0.01\nsmallest_m = 1\nlargest_m = 4\narea_m = [250, 250, 350, 350]\n",
    );
    102
}

/// A string, and a lamp alone.
fn lights(room: &Room) -> u64 {
    let lamp = |id: &str| format!("[[light]]\nid = \"{id}\"\nx_m = 200\ny_m = 200\ndiameter_m = 0.3\n");
    let string = format!("{}count = 5\nto = {{ x_m = 250, y_m = 200 }}\n", lamp("string"));
    add(room, &format!("{string}{}", lamp("alone")));
    6
}

fn sheets(room: &Room) -> u64 {
    let corners = "corners_m = [[200, 200, 0], [210, 200, 0], [210, 200, 9]]\ntau = 0.5\n";
    let sheet = |number: u64| format!("[[sheet]]\nid = \"veil-{number}\"\n{corners}");
    add(room, &(0..4).map(sheet).collect::<String>());
    4
}

fn stars(room: &Room) -> u64 {
    add(room, "[stars]\nseed = 1\ncount = 40\n");
    40
}

/// Two rear wheels, from end to end of the path.
fn patches(room: &Room) -> u64 {
    add(room, "[shadows]\n[tracks]\nspacing_m = 1\n");
    20
}

fn sun_steps(room: &Room) -> u64 {
    let drift = "step_s = 0.5\ndrift = [{ t_s = 4, azimuth_deg = 100, elevation_deg = 14 }]";
    room.vary("s.toml", "elevation_deg = 15", &format!("elevation_deg = 15\n{drift}"));
    8
}

fn list(room: &Room, name: &str, content: impl AsRef<[u8]>) -> u64 {
    room.write(name, content);
    add(room, &format!("[features]\nlist = \"{name}\"\n"));
    bytes(room, name)
}

fn path(room: &Room) -> u64 {
    room.write("path.csv", "t_s,x_m,y_m\n0,100,200\n5,108,205\n");
    room.vary("s.toml", KEYFRAMES, "file = \"path.csv\"");
    bytes(room, "path.csv")
}

fn poses(room: &Room) -> u64 {
    room.done(&["replay", "tiny.toml", "-q", "--frames", "0", "--out", "run"]);
    bytes(room, "run/poses.csv")
}

fn bank(room: &Room) -> u64 {
    room.done(&["bank", "generate", "tiny.toml", "-o", "a.bank"]);
    bytes(room, "a.bank")
}

fn array(room: &Room, shape: &str, values: usize) -> u64 {
    room.write("a.npy", npy("<f8", shape, &doubles(&vec![1.0; values])));
    bytes(room, "a.npy")
}

/// Heights of 40 x 50 samples, eight bytes each.
fn heights(room: &Room) -> u64 {
    array(room, "(40, 50)", 2000);
    8 * 2000
}

fn cube(room: &Room) -> u64 {
    let text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n\
                f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    room.write("cube.obj", text);
    add(room, "[[object]]\nid = \"box\"\nfile = \"cube.obj\"\nx_m = 100\ny_m = 100\n");
    text.len() as u64
}

/// A prism on an L: two boxes.
fn l_shape(room: &Room) -> u64 {
    let outline = ["0 0", "3 0", "3 1", "1 1", "1 2", "0 2"];
    let level = |height: u8| outline.map(|at| format!("v {at} {height}\n")).concat();
    let sides = "f 1 2 8 7\nf 2 3 9 8\nf 3 4 10 9\nf 4 5 11 10\nf 5 6 12 11\nf 6 1 7 12\n";
    room.write("l.obj", format!("{}{}f 6 5 4 3 2 1\nf 7 8 9 10 11 12\n{sides}", level(0), level(1)));
    add(room, "[[object]]\nid = \"l\"\nfile = \"l.obj\"\nx_m = 100\ny_m = 100\n");
    2
}

/// A picture of 40 x 23 pixels.
fn picture(room: &Room) {
    room.done(&["replay", "tiny.toml", "-q", "--frames", "0", "--out", "run"]);
    std::fs::copy(room.join("run/frames/frame-000000.png"), room.join("a.png")).unwrap();
}

fn picture_bytes(room: &Room) -> u64 {
    picture(room);
    bytes(room, "a.png")
}

fn pixels(room: &Room) -> u64 {
    picture(room);
    40 * 23
}

/// Three flags, of one body each or more.
fn flags(room: &Room) -> u64 {
    let flag = |at: u32| format!("[[object]]\nid = \"o{at}\"\nmodel = \"flag\"\nx_m = 200\ny_m = 200\n");
    add(room, &(0..3).map(flag).collect::<String>());
    3
}

/// As many parts as the shape in the program has.
fn bodies(room: &Room) -> u64 {
    3 * solids::culture::model("flag").expect("a shape").len() as u64 * flags(room) / 3
}

fn events(room: &Room) -> u64 {
    let object = "[[object]]\nid = \"a\"\nmodel = \"flag\"\nx_m = 200\ny_m = 200\n";
    let event =
        |t: u32| format!("[[event]]\nt_s = {t}\naction = \"move\"\nobject = \"a\"\nx_m = 210\ny_m = 200\n");
    add(room, &(object.to_owned() + &(1..6).map(event).collect::<String>()));
    5
}

fn landforms(room: &Room) -> u64 {
    let massif = "[[landscape.generated.massif]]\nat_m = [200, 200]\nheight_m = 10\nradius_m = 320\ndetail_m = 155\nruggedness = 0.5\n";
    add(room, &massif.repeat(2));
    2
}

fn rows(room: &Room) -> u64 {
    room.done(&["replay", "tiny.toml", "-q", "--out", "run"]);
    4
}

fn record(room: &Room) -> u64 {
    room.done(&["replay", "tiny.toml", "-q", "--frames", "0", "--out", "run"]);
    bytes(room, "run/run.json")
}

const HEADING: &str = "x_m,y_m,radius_m,depth_m,rim_m,type,outer_m,floor_m";

const CASES: &[Case] = &[
    Case { limit: "corners", file: "tiny.toml", make: |_| 9 * 9, command: &["check", "tiny.toml"] },
    Case { limit: "ground-craters", file: "s.toml", make: ground_craters, command: CHECK },
    Case { limit: "craters", file: "s.toml", make: craters, command: CHECK },
    Case { limit: "rocks", file: "s.toml", make: rocks, command: CHECK },
    Case { limit: "patches", file: "s.toml", make: patches, command: CHECK },
    Case { limit: "sun-steps", file: "s.toml", make: sun_steps, command: CHECK },
    Case { limit: "frames", file: "tiny.toml", make: |_| 4, command: &["check", "tiny.toml"] },
    Case {
        limit: "text-bytes",
        file: "tiny.toml",
        make: |_| TINY.len() as u64,
        command: &["check", "tiny.toml"],
    },
    Case {
        limit: "text-bytes",
        file: "model.toml",
        make: |room| {
            let shown = room.done(&["model", "show", "pra-nominal"]);
            room.write("model.toml", shown.replace("name = \"pra-nominal\"", "name = \"model\""));
            bytes(room, "model.toml")
        },
        command: &["replay", "tiny.toml", "-m", "model.toml", "-q", "--out", "new", "--frames", "0"],
    },
    Case {
        limit: "list-bytes",
        file: "c.csv",
        make: |room| list(room, "c.csv", format!("{HEADING}\n200,200,10,2,0,1,,\n")),
        command: CHECK,
    },
    Case {
        limit: "list-bytes",
        file: "c.npy",
        make: |room| {
            list(room, "c.npy", npy("<f8", "(1, 6)", &doubles(&[200.0, 200.0, 10.0, 2.0, 0.0, 1.0])))
        },
        command: CHECK,
    },
    Case { limit: "list-bytes", file: "path.csv", make: path, command: CHECK },
    Case { limit: "list-bytes", file: "run/poses.csv", make: poses, command: AUGMENT },
    Case { limit: "bank-bytes", file: "a.bank", make: bank, command: &["bank", "show", "a.bank"] },
    Case {
        limit: "bank-bytes",
        file: "a.npy",
        make: |room| array(room, "(2, 2, 9)", 36),
        command: &["bank", "import", "a.npy", "--region-size-m", "40", "-o", "new.bank"],
    },
    Case { limit: "elevation-bytes", file: "a.npy", make: heights, command: SURVEY },
    Case { limit: "shape-bytes", file: "cube.obj", make: cube, command: CHECK },
    Case { limit: "shape-parts", file: "l.obj", make: l_shape, command: CHECK },
    Case { limit: "picture-bytes", file: "a.png", make: picture_bytes, command: &["info", "a.png"] },
    Case { limit: "pixels", file: "a.png", make: pixels, command: &["info", "a.png"] },
    Case { limit: "pixels", file: "tiny.toml", make: |_| 40 * 23, command: &["check", "tiny.toml"] },
    Case { limit: "lights", file: "s.toml", make: lights, command: CHECK },
    Case { limit: "sheets", file: "s.toml", make: sheets, command: CHECK },
    Case { limit: "stars", file: "s.toml", make: stars, command: CHECK },
    Case { limit: "objects", file: "s.toml", make: flags, command: CHECK },
    Case { limit: "bodies", file: "s.toml", make: bodies, command: CHECK },
    Case { limit: "events", file: "s.toml", make: events, command: CHECK },
    Case { limit: "landforms", file: "s.toml", make: landforms, command: CHECK },
    Case { limit: "rows", file: "run/poses.csv", make: rows, command: AUGMENT },
    Case { limit: "record-bytes", file: "run/run.json", make: record, command: &["info", "run"] },
];

#[test]
fn one_more_than_each_limit_needs_its_name() {
    let listed: BTreeSet<_> = ROWS.iter().map(|row| row.name).collect();
    // What these limit is no file that is refused. extremes.rs has the cases of the first two, the crate `loop-protocol` those of messages.
    let elsewhere = ["faults", "signals", "header-bytes", "plane-bytes"];
    let held: BTreeSet<_> = CASES.iter().map(|case| case.limit).chain(elsewhere).collect();
    assert_eq!(listed, held, "limits of the list, and those with a case here");
    for &Case { limit, file, make, command } in CASES {
        let room = Room::new();
        let most = make(&room);
        let [less, enough] = [most - 1, most].map(|most| format!("{limit}={most}"));
        let words = [file, &format!("--raise {limit}=N allows more")];
        room.refused(INPUT, &[command, &["--raise", &less][..]].concat(), &words);
        // Some of the files are drawn otherwise than they are written, which is told.
        let said = room.run(&[command, &["--raise", &enough][..]].concat());
        let is_told = said.err.lines().all(|line| line.starts_with("warning: "));
        assert!(said.code == Some(0) && is_told, "{limit}: {said:?}");
    }
}

#[test]
fn what_is_usual_is_what_the_list_says() {
    let room = Room::new();
    room.vary("long.toml", "frames = 4", "frames = 10000001");
    let padding = "#".repeat((16 << 20) + 1 - TINY.len() - 1);
    room.write("wordy.toml", format!("{TINY}{padding}\n"));
    room.vary("wide.toml", "extent_m = [400, 400]", "extent_m = [100000, 100050]");
    for (file, limit, words) in [
        ("long.toml", "frames", "10000000"),
        ("wordy.toml", "text-bytes", "16777216"),
        ("wide.toml", "corners", "2001 x 2002 corners: expected at most 4000000"),
    ] {
        room.refused(INPUT, &["check", file], &[file, words, &format!("--raise {limit}=N allows more")]);
    }
}

#[test]
fn what_is_no_limit_is_wrong_usage() {
    let room = Room::new();
    let refused = |assignment: &str, words: &[&str]| {
        room.refused(USAGE, &["check", "tiny.toml", "--raise", assignment], words);
    };
    refused("holes=3", &["--raise", "holes: there is no such limit", "corners"]);
    refused("frames=0", &["--raise frames: expected a whole number from 1 to", "found `0`"]);
    refused("frames", &["expected NAME=VALUE"]);
    let listed = room.done(&["list", "limits", "--raise", "rocks=200000"]);
    assert!(listed.contains("rocks") && listed.contains("200000, can be raised to"), "{listed}");
    let listed = room.done(&["list", "limits", "--json", "--raise", "rocks=200000"]);
    let listed: serde_json::Value = serde_json::from_str(&listed).unwrap();
    let rocks = listed["limits"].as_array().unwrap().iter().find(|row| row["name"] == "rocks").unwrap();
    assert!(rocks["at_most"] == 200_000 && rocks["raised_to_at_most"].as_u64().unwrap() > 200_000, "{rocks}");
}
