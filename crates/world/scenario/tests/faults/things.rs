//! Objects, groups, channels, shapes and events that cannot be.

use std::fs;

use crate::{GOOD, fault_of, faults};
use scenario::Scenario;

const LANDER: &str = "[[object]]\nid = 'lm'\nmodel = 'lander'\nx_m = 60\ny_m = 90\n";
const FLAG: &str = "[[object]]\nid = 'flag'\nmodel = 'flag'\nx_m = 60\ny_m = 90\npresent = false\n";

#[test]
fn objects_that_cannot_be() {
    for (tables, expected) in [
        (LANDER.replace("'lander'", "'landr'"), "must be one of \"lander\""),
        (LANDER.replace("model = 'lander'\n", ""), "missing key `object[0].model` or `object[0].file`"),
        (LANDER.replace("model", "file = 'a.obj'\nmodel"), "both say what it is"),
        (LANDER.replace("model = 'lander'", "file = '../a.obj'"), "stays in the scenario's folder"),
        (LANDER.replace("'lm'", "'l m'"), "letters, digits and dashes"),
        (LANDER.replace("x_m = 60", "x_m = nan"), "not nan"),
        (format!("{LANDER}scale = 0\n"), "above 0"),
        (format!("{LANDER}{}", LANDER.replace("lander", "rover")), "two objects are called \"lm\""),
    ] {
        let found = fault_of(&tables);
        assert!(found.contains(expected), "{tables}: {found}");
    }
    let text = GOOD.replace("[sun]", &format!("{}\n[sun]", LANDER.replace("'lander'", "'landr'")));
    let list = Scenario::parse("t.toml", &text).unwrap_err().to_string();
    assert!(list.contains("did you mean \"lander\"?"), "{list}");
}

#[test]
fn groups_that_cannot_be() {
    let group = "[[group]]\nname = 'stage'\n";
    let member = format!("{LANDER}group = 'stage'\n");
    assert_eq!(faults(&GOOD.replace("[sun]", &format!("{group}{member}[sun]"))), []);
    for (tables, expected) in [
        (member.clone(), "an object of a group, and no group"),
        (format!("{group}{}", member.replace("stage", "stag")), "must be one of \"stage\""),
        (format!("{group}{group}{member}"), "two groups are called \"stage\""),
        // A group with a fault says nothing about who names it.
        (format!("{group}sun = {{ azimuth_deg = 1 }}\n{member}"), "missing key `group[0].sun.elevation_deg`"),
        (format!("{}{member}", group.replace("name", "nam")), "missing key `group[0].name`"),
    ] {
        let found = faults(&GOOD.replace("[sun]", &format!("{tables}\n[sun]")));
        assert!(found[0].1.contains(expected), "{tables}: {found:?}");
        let of_objects = found.iter().filter(|(_, title)| title.contains("object"));
        assert_eq!(
            of_objects.count(),
            usize::from(expected.contains("object") || expected.contains("one of"))
        );
    }
}

#[test]
fn channels_that_cannot_be() {
    let left = "[[channel]]\nname = 'left'\nheading_deg = -50\n";
    assert_eq!(faults(&GOOD.replace("[sun]", &format!("{left}[sun]"))), []);
    for (tables, expected) in [
        (left.replace("'left'", "'../left'"), "letters, digits and dashes"),
        (left.replace("name = 'left'\n", ""), "missing key `channel[0].name`"),
        (format!("{left}{}", left.replace("left", "Left")), "two channels are called \"left\""),
        (format!("{left}pitch_deg = 91\n"), "must be a number from -90 to 90 degrees"),
        (format!("{left}roll_deg = nan\n"), "not nan"),
        (format!("{left}field_of_view_deg = [0, 30]\n"), "0.1 to 170"),
        (format!("{left}field_of_view_deg = 50\n"), "is one angle, without `raster.lines`"),
        ((0..17).map(|k| left.replace("left", &format!("c{k}"))).collect(), "17 channels"),
    ] {
        let found = fault_of(&tables);
        assert!(found.contains(expected), "{tables}: {found}");
    }
}

#[test]
fn shapes_that_are_no_solids() {
    let folder = tempfile::tempdir().unwrap();
    let dented =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0.1 0.1 0.1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 5\nf 3 4 5\n";
    fs::write(folder.path().join("dent.obj"), dented).unwrap();
    let name = folder.path().join("s.toml");
    for (file, expected) in [("dent.obj", "dent.obj"), ("gone.obj", "no such file")] {
        let object = LANDER.replace("model = 'lander'", &format!("file = '{file}'"));
        let text = GOOD.replace("[sun]", &format!("{object}\n[sun]"));
        let list = Scenario::parse(name.to_str().unwrap(), &text).unwrap_err();
        assert!(list.len() == 1 && list.to_string().contains(expected), "{list}");
    }
}

#[test]
fn events_that_cannot_happen() {
    let event = |time: f64, rest: &str| format!("[[event]]\nt_s = {time:?}\n{rest}\n");
    let add = "action = 'add'\nobject = 'flag'";
    let delete = "action = 'delete'\nobject = 'lm'";
    let to = "action = 'move'\nobject = 'lm'\nx_m = 5\ny_m = 5";
    for (events, expected) in [
        (event(1.0, "action = 'add'\nobject = 'flg'"), "must be one of \"lm\", \"flag\""),
        (event(1.0, "action = 'ad'\nobject = 'flag'"), "must be one of \"move\""),
        (event(-1.0, add), "of at least 0"),
        (event(1.0, "action = 'move'\nobject = 'lm'\nx_m = 5"), "missing key `event[0].y_m`"),
        (event(1.0, &format!("{delete}\nx_m = 5")), "unknown key `event[0].x_m`"),
        (event(1.0, &add.replace("flag", "lm")), "\"lm\" is added at t = 1 s and stands already"),
        (event(1.0, &delete.replace("lm", "flag")), "\"flag\" is deleted at t = 1 s and does not stand"),
        (event(1.0, &to.replace("lm", "flag")), "\"flag\" is moved at t = 1 s and does not stand"),
        (event(2.0, to) + &event(2.0, delete), "two events of \"lm\" at t = 2 s"),
        (event(3.0, to) + &event(2.0, delete), "\"lm\" is moved at t = 3 s and does not stand"),
    ] {
        let found = fault_of(&format!("{LANDER}{FLAG}{events}"));
        assert!(found.contains(expected), "{events}: {found}");
    }
    assert!(fault_of(&event(1.0, add)).contains("an event without an object"));
    let good = format!("{LANDER}{FLAG}{}{}{}", event(3.0, delete), event(1.0, to), event(3.0, add));
    assert_eq!(faults(&GOOD.replace("[sun]", &format!("{good}[sun]"))), []);
    let text = GOOD.replace("[sun]", &format!("{FLAG}{}[sun]", event(1.0, &add.replace("flag", "flg"))));
    let list = Scenario::parse("t.toml", &text).unwrap_err().to_string();
    assert!(list.contains("did you mean \"flag\"?"), "{list}");
}
