//! What stands on the ground and how it is lit: each fault is one clear error.

use crate::room::{INPUT, KEYFRAMES, Room, TINY, USAGE};

const CUBE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n\
                    f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

/// `tiny.toml` with more tables as `s.toml`, refused by a replay and by a check.
fn refused(room: &Room, tables: &str, words: &[&str]) {
    room.write("s.toml", format!("{TINY}\n{tables}"));
    room.refused(INPUT, &["replay", "s.toml"], words);
    assert_eq!(room.run(&["check", "s.toml"]).code, Some(INPUT), "{tables}");
}

fn object(shape: &str) -> String {
    format!("[[object]]\nid = \"lm\"\n{shape}\nx_m = 100\ny_m = 100\n")
}

#[test]
fn shapes_that_are_no_convex_solids() {
    let room = Room::new();
    room.write("dent.obj", CUBE.replace("v 1 1 1", "v 0.4 0.4 0.4"));
    room.write("flat.obj", CUBE.replace(" 1\n", " 0\n"));
    room.write("open.obj", CUBE.replace("f 4 1 5 8\n", ""));
    room.write("empty.obj", "");
    for (file, words) in [
        ("dent.obj", &["dent.obj"][..]),
        ("flat.obj", &["flat.obj"]),
        ("open.obj", &["open.obj", "closed"]),
        ("empty.obj", &["empty.obj"]),
        ("gone.obj", &["gone.obj", "no such file"]),
    ] {
        room.write("s.toml", format!("{TINY}\n{}", object(&format!("file = \"{file}\""))));
        let said = room.run(&["replay", "s.toml"]);
        assert_eq!((said.code, &*said.out), (Some(INPUT), ""), "{file}: {said:?}");
        assert!(words.iter().all(|word| said.err.contains(word)), "{file}: {}", said.err);
        assert!(!said.err.contains("panicked") && !room.join("runs").exists());
    }
}

#[test]
fn craters_that_cannot_be() {
    let room = Room::new();
    let list = "[features]\nlist = \"c.csv\"\n";
    for (row, words) in [
        ("200,200,10,2,1,2,8,", &["c.csv:2:"][..]),
        ("200,200,0,2,0,1,,", &["c.csv:2:", "above 0"]),
        ("200,200,-5,2,0,1,,", &["c.csv:2:", "above 0"]),
        ("200,200,10,-2,0,1,,", &["c.csv:2:"]),
        ("200,200,10,2,0,4,,", &["c.csv:2:"]),
        ("200,nan,10,2,0,1,,", &["c.csv:2:", "nan"]),
        ("395,200,10,2,0,1,,", &["c.csv: row 1", "not wholly inside the problem area", "x 0..400 m"]),
    ] {
        room.write("c.csv", format!("x_m,y_m,radius_m,depth_m,rim_m,type,outer_m,floor_m\n{row}\n"));
        refused(&room, list, words);
    }
    let swarm = "[[features.population]]\nseed = 1\nkind = \"fresh\"\ndensity_per_m2 = 1e5\n\
                 smallest_radius_m = 1\nlargest_radius_m = 5\n";
    refused(&room, swarm, &["s.toml", "population]] 1", "craters: expected at most"]);
}

#[test]
fn events_of_what_is_not_there() {
    let room = Room::new();
    let lander = object("model = \"lander\"");
    let event = |rest: &str| format!("{lander}[[event]]\nt_s = 1\n{rest}\n");
    for (tables, words) in [
        (event("action = \"delete\"\nobject = \"lm2\""), &["event[0].object", "did you mean \"lm\"?"][..]),
        (event("action = \"add\"\nobject = \"lm\""), &["\"lm\" is added at t = 1 s and stands already"]),
        (lander.replace("x_m = 100", "x_m = 900"), &["object \"lm\"", "outside the problem area"]),
        (lander.replace("lander", "landr"), &["did you mean \"lander\"?"]),
    ] {
        refused(&room, &tables, words);
    }
}

#[test]
fn suns_below_the_horizon() {
    let room = Room::new();
    for (new, words) in [
        ("elevation_deg = 0", &["sun.elevation_deg", "above 0"][..]),
        ("elevation_deg = -3", &["sun.elevation_deg", "above 0"]),
        (
            "elevation_deg = 3\nstep_s = 1\ndrift = [{ t_s = 9, azimuth_deg = 0, elevation_deg = -1 }]",
            &["sun.drift[0].elevation_deg", "above 0"],
        ),
    ] {
        room.vary("s.toml", "elevation_deg = 15", new);
        room.refused(INPUT, &["replay", "s.toml"], words);
    }
}

#[test]
fn rocks_and_tracks_without_end() {
    let room = Room::new();
    let rocks = "[rocks]\nseed = 1\ndensity_per_m2 = 900\nsmallest_m = 0.99\nlargest_m = 2\narea_m = [0, 0, 400, 400]";
    refused(&room, rocks, &["s.toml", "[rocks]", "rocks: expected at most 100000"]);
    let far = TINY.replace(
        KEYFRAMES,
        "keyframes = [{ t_s = 0, x_m = 100, y_m = 200 }, { t_s = 5, x_m = 9e6, y_m = 205 }]",
    );
    room.write("s.toml", format!("{far}\n[shadows]\n[tracks]\n"));
    room.refused(INPUT, &["replay", "s.toml"], &["s.toml", "[path]: too long"]);
}

#[test]
fn economies_that_contradict() {
    let room = Room::new();
    room.refused(
        USAGE,
        &["replay", "tiny.toml", "--lossless", "--everything"],
        &["--lossless", "--everything"],
    );
}
