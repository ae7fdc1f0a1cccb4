//! Times, speeds and bandwidths so extreme that a frame would not end or a record not be read again; files of many faults.

use crate::room::{INPUT, KEYFRAMES, Room, TINY, USAGE};

fn keyframes(room: &Room, keyframes: &str) {
    room.vary("s.toml", KEYFRAMES, &format!("keyframes = [{keyframes}]"));
}

#[test]
fn times_that_are_too_near_are_refused_with_the_least_distance() {
    let room = Room::new();
    for step in ["1e-300", "5e-324", "1e-12", "5e-7"] {
        keyframes(
            &room,
            &format!(
                "{{ t_s = 0, x_m = 100, y_m = 200 }}, {{ t_s = {step}, x_m = 120, y_m = 200 }}, {{ t_s = 1, x_m = 130, y_m = 200 }}"
            ),
        );
        let words = ["s.toml", "expected at least 0.000001 s between two times"];
        room.refused(INPUT, &["check", "s.toml"], &words);
        room.refused(INPUT, &["replay", "s.toml", "-q", "--out", "r"], &words);
    }
    // Times since 1970 in microseconds are not all apart by exactly a microsecond.
    keyframes(&room, "{ t_s = 0, x_m = 100, y_m = 200 }, { t_s = 1e-6, x_m = 100, y_m = 200 }");
    room.done(&["check", "s.toml"]);
}

/// A speed that is a number and no speed: the record would say it, and nobody could drive it.
#[test]
fn speeds_beyond_light_are_refused_with_the_bound() {
    let room = Room::new();
    keyframes(
        &room,
        "{ t_s = 0, x_m = 100, y_m = 200 }, { t_s = 2e-6, x_m = 300, y_m = 200 }, { t_s = 0.2, x_m = 100, y_m = 200 }",
    );
    let said = room.run(&["replay", "s.toml", "-q", "--out", "r"]);
    assert!(said.code == Some(0) || said.err.contains("299792458"), "{said:?}");
    if said.code == Some(0) {
        room.done(&["info", "r"]);
    }
    keyframes(&room, "{ t_s = 0.099999, x_m = 10, y_m = 200 }, { t_s = 0.1000015, x_m = 390, y_m = 200 }");
    let said = room.run(&["replay", "s.toml", "-q", "--out", "t"]);
    assert!(said.code == Some(0) || said.err.contains("299792458"), "{said:?}");
}

#[test]
fn bandwidths_that_never_end_are_refused_with_the_least() {
    let room = Room::new();
    let keys = [
        "amplifier.gain_bandwidth_mhz",
        "function_generator.bandwidth_mhz",
        "multiplier.bandwidth_mhz",
        "multiplying_dac.bandwidth_mhz",
        "video.bandwidth_mhz",
        "texture_generator.filter_mhz",
    ];
    for key in keys {
        for value in ["1e-9", "1e-300", "0.00009"] {
            let set = format!("{key}={value}");
            let replay = ["replay", "tiny.toml", "-q", "-m", "pra-nominal", "--out", "r", "--set", &set];
            room.refused(INPUT, &replay, &[key, "at least 0.0001 MHz"]);
        }
    }
    room.write(
        "slow.toml",
        "format = 1\nname = \"slow\"\nbase = \"pra-nominal\"\n[amplifier]\ngain_bandwidth_mhz = 1e-9\n",
    );
    room.refused(INPUT, &["check", "slow.toml"], &["slow.toml:5", "at least 0.0001 MHz"]);
    let least = [
        "replay",
        "tiny.toml",
        "-q",
        "-m",
        "pra-nominal",
        "--frames",
        "0",
        "--out",
        "r",
        "--set",
        "amplifier.gain_bandwidth_mhz=0.0001",
    ];
    room.done(&least);
}

/// `count` times the same fault of a kind.
fn faulty(kind: &str, count: usize) -> String {
    let events = "[[event]]\nt_s = 1\naction = \"delete\"\nobject = \"gone\"\n";
    match kind {
        "tables" => TINY.to_owned() + &(0..count).map(|at| format!("[t{at}]\n")).collect::<String>(),
        "objects" => TINY.to_owned() + &"[[object]]\n".repeat(count),
        "events" => TINY.to_owned() + &events.repeat(count),
        "one line" => TINY.replace(KEYFRAMES, &format!("keyframes = [{}]", "{}, ".repeat(count))),
        _ => unreachable!("{kind}"),
    }
}

/// Every fault is listed with its place, in files that were too long to be checked while the time grew with their square.
#[test]
fn every_fault_of_many_is_listed() {
    let room = Room::new();
    for kind in ["tables", "objects", "events", "one line"] {
        room.write("s.toml", faulty(kind, 3900));
        let said = room.run(&["check", "s.toml"]);
        assert_eq!(said.code, Some(INPUT), "{kind}");
        assert!(said.errors() >= 3900, "{kind}: {} are listed", said.errors());
    }
}

#[test]
fn faults_beyond_their_limit_are_counted() {
    let room = Room::new();
    room.write("s.toml", faulty("tables", 50));
    let said = room.run(&["check", "s.toml", "--raise", "faults=7"]);
    assert_eq!((said.code, said.errors()), (Some(INPUT), 8));
    for word in ["43 more faults are not listed", "--raise faults=N allows more"] {
        assert!(said.err.contains(word), "{}", said.err);
    }
}

#[test]
fn signals_beyond_their_limit_are_refused() {
    let room = Room::new();
    let probe = [
        "probe",
        "tiny.toml",
        "--frame",
        "0",
        "--sweep",
        "5",
        "--signals",
        "tg.height,mu.height",
        "-o",
        "w.csv",
        "--raise",
    ];
    room.refused(
        USAGE,
        &[&probe[..], &["signals=1"]].concat(),
        &["2 signals, expected at most 1", "--raise signals=N allows more"],
    );
    room.run(&[&probe[..], &["signals=2"]].concat());
    assert!(room.join("w.csv").exists());
}
