//! OBJ files as programs write them, and damaged ones.

use diagnostics::ProblemList;
use glam::DVec3;
use solids::Solid;
use solids::shape_files::{self, ALBEDO, Openness};

const BOX: &str = "# a box\nmtllib none.mtl\no box\nv 0 -1 0\nv 2 -1 0\nv 2 1 0\nv 0 1 0\nv 0 -1 1\nv 2 -1 1\nv 2 1 1\nv 0 1 1\n\
    vn 0 0 1\nvt 0.5 0.5\nusemtl grey\ns off\nf 1 2 3 4\nf 5/1/1 6/1/1 7/1/1 8/1/1\nf 1//1 2//1 6//1 5//1\nf 3/1 4/1 8/1 7/1\n\
    f -5 -1 -4 -8 # back\nf 2 3 7 6\n";

fn parse(name: &str, text: &str) -> Result<Vec<Solid>, ProblemList> {
    shape_files::parse(name, text.as_bytes(), Openness::Closed).map(|shape| shape.solids)
}

fn read(path: std::path::PathBuf) -> Result<Vec<Solid>, ProblemList> {
    shape_files::read(path, Openness::Closed).map(|shape| shape.solids)
}

fn faults(text: &str) -> Vec<String> {
    let error = parse("shapes/part.obj", text).expect_err("should be refused");
    let said = |problem: &diagnostics::Problem| {
        let record = problem.record();
        format!("{}: {}", record.line.unwrap_or(0), record.title)
    };
    error.iter().map(said).collect()
}

#[test]
fn a_box_in_every_form_of_corner() {
    let solids = parse("box.obj", BOX).unwrap();
    assert_eq!(solids.len(), 1);
    assert_eq!((solids[0].vertices().len(), solids[0].faces().len()), (8, 6));
    assert!(solids[0].faces().iter().all(|face| face.albedo == ALBEDO));
}

#[test]
fn port_becomes_starboard_and_counter_clockwise_stays_so() {
    let wedge = "v 0 0 0\nv 1 0 0\nv 0 3 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    let solid = &parse("wedge.obj", wedge).unwrap()[0];
    assert!(solid.vertices().contains(&DVec3::new(0.0, -3.0, 0.0)));
    // The file is right-handed and its faces counter-clockwise from outside: the order of corners is kept.
    let first = &solid.faces()[0];
    let corner = |index: usize| solid.vertices()[first.corners[index] as usize];
    let turns = (0..3)
        .any(|turn| (corner(turn), corner((turn + 1) % 3)) == (DVec3::ZERO, DVec3::new(0.0, -3.0, 0.0)));
    assert!(turns, "{:?}", first.corners);
    assert_eq!(first.normal, DVec3::NEG_Z);
}

#[test]
fn groups_are_parts_and_split_vertices_are_joined() {
    let split = BOX.replace("f 2 3 7 6", "v 2 -1 0\nv 2 1 0\nf 9 10 7 6");
    let second = BOX.replace("o box", "g\no second").replace("mtllib none.mtl\n", "");
    let shift = |line: &str| match line.strip_prefix("f ") {
        Some(corners) if !corners.starts_with('-') => {
            let number = |corner: &str| corner.split('/').next().unwrap().parse::<i64>().unwrap() + 10;
            let shifted: Vec<String> =
                corners.split_whitespace().map(|corner| number(corner).to_string()).collect();
            format!("f {}\n", shifted.join(" "))
        }
        _ => format!("{line}\n"),
    };
    let both = format!("{split}{}", second.lines().map(shift).collect::<String>());
    assert_eq!(parse("two.obj", &both).unwrap().len(), 2);
}

#[test]
fn every_fault_has_its_line() {
    assert_eq!(faults("v 0 0 0\n"), ["0: no faces, so no solid"]);
    assert_eq!(faults(""), ["0: no faces, so no solid"]);
    assert_eq!(
        faults("v 0 nan 0\nv 1 inf x\nv 1\nl 1 2\nf 1 0 9\nv 1 2 3 4 5\nvn 1 0\nvn 0 x 1\n"),
        [
            "1: a coordinate must be a finite number, not nan",
            "2: a coordinate must be a finite number, not inf",
            "2: a coordinate must be a finite number, not x",
            "3: a vertex of 1 numbers",
            "4: statement `l` is not read",
            "5: corner 0 names no vertex: 3 stand above this line",
            "6: a vertex of 5 numbers",
            "7: a normal of 2 numbers",
            "8: a part of a normal must be a number, not x",
        ]
    );
    let far = BOX.replace("f 2 3 7 6", "f 2 3 7 -9");
    assert_eq!(faults(&far), ["21: corner -9 names no vertex: 8 stand above this line"]);
    let absurd = BOX.replace("f 2 3 7 6", "f 2 3 99999999999999999999 -9223372036854775808");
    assert!(faults(&absurd)[0].starts_with("21: corner 99999999999999999999"));
}

#[test]
fn parts_that_are_no_solids_say_why_and_where() {
    let dented = BOX.replace("v 2 1 1", "v 1.5 0.5 0.7").replace("f 2 3 7 6", "f 2 3 7\nf 2 7 6");
    let dented = dented
        .replace("f 3/1 4/1 8/1 7/1", "f 3 4 7\nf 4 8 7")
        .replace("f 5/1/1 6/1/1 7/1/1 8/1/1", "f 5 6 7\nf 5 7 8");
    assert_eq!(parse("dented.obj", &dented).unwrap().len(), 4);
    let open = BOX.replace("f 2 3 7 6\n", "");
    assert!(faults(&open)[0].contains("not closed: the edge between vertex "), "{:?}", faults(&open));
    let line = BOX.replace("f 2 3 7 6", "f 2 3");
    assert_eq!(faults(&line), ["21: degenerate face: fewer than 3 corners"]);
    let bow = BOX.replace("f 2 3 7 6", "f 2 7 3 6");
    assert!(faults(&bow)[0].starts_with("21: "), "{:?}", faults(&bow));
    let bent = BOX.replace("v 2 1 1", "v 2 1 1.5");
    assert!(faults(&bent)[0].contains("degenerate face: corners not in one plane"), "{:?}", faults(&bent));
    let far = BOX.replace("v 2 1 1", "v 2e9 1 1");
    assert!(faults(&far)[0].contains("vertex 7 (line 10): farther than 1e5 m"), "{:?}", faults(&far));
}

#[test]
fn many_faults_are_counted_and_files_are_checked() {
    let said = faults(&"q\n".repeat(50));
    assert_eq!(said.len(), 21);
    assert_eq!(said[20], "0: 30 more faults of this file are not listed");
    let folder = tempfile::tempdir().unwrap();
    assert!(read(folder.path().join("none.obj")).is_err());
    let path = folder.path().join("box.obj");
    std::fs::write(&path, BOX.replace('\n', "\r\n")).unwrap();
    assert_eq!(read(path.clone()).unwrap().len(), 1);
    std::fs::write(&path, [0x76, 0x0a, 0x00]).unwrap();
    assert!(read(path).unwrap_err().to_string().contains("not text: byte 2 is 0"));
    assert!(
        faults(&"v 0 0 0\no a\nf 1 1 1\n".repeat(5000))
            .iter()
            .any(|said| said.contains("more than 4096 parts"))
    );
}
