//! Ctrl-C: exit code 130, and no file that is not whole.

use std::fs;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use crate::room::Room;

/// Long enough to be met in the middle.
const SLOW: [&str; 4] = ["--sweeps", "4000", "--samples", "1500"];

const SLOWER: [&str; 4] = ["--sweeps", "8192", "--samples", "65536"];

/// Names that begin with a dot: what is not whole yet.
fn temporaries(room: &Room) -> Vec<String> {
    let names = fs::read_dir(room.path()).unwrap().map(|entry| entry.unwrap().file_name());
    names.map(|name| name.to_string_lossy().into_owned()).filter(|name| name.starts_with('.')).collect()
}

fn wait_for(what: &str, mut is_there: impl FnMut() -> bool) {
    let began = Instant::now();
    while !is_there() {
        assert!(began.elapsed() < Duration::from_secs(120), "no {what} after two minutes");
        sleep(Duration::from_millis(1));
    }
}

fn interrupt(mut child: Child) -> Option<i32> {
    let status = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(status.success());
    child.wait().unwrap().code()
}

fn start(room: &Room, arguments: &[&str]) -> Child {
    room.command(arguments).stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap()
}

#[test]
fn a_probe_that_is_interrupted_leaves_nothing() {
    let room = Room::new();
    for out in ["w.fst", "w.npz", "w.csv"] {
        let signals = "tg.height,mu.height,dpp.elevation,dpp.y";
        let base =
            ["probe", "tiny.toml", "--frame", "1", "--sweep", "all", "--signals", signals, "--out", out];
        let child = start(&room, &[&base[..], &SLOW].concat());
        let is_written = || {
            let len = |name: &String| fs::metadata(room.join(name)).map_or(0, |file| file.len());
            temporaries(&room).iter().any(|name| !name.ends_with("-trial.tmp") && len(name) > 0)
        };
        wait_for("temporary file", is_written);
        assert_eq!(interrupt(child), Some(130), "{out}");
        assert_eq!((temporaries(&room), room.join(out).exists()), (vec![], false), "{out}");
    }
}

#[test]
fn what_writes_no_file_ends_as_well() {
    let room = Room::new();
    let commands = [
        // A pixel needs few sweeps: these are long ones.
        (vec!["explain", "tiny.toml", "--frame", "1", "--pixel", "9,9"], SLOWER),
        (vec!["trace", "tiny.toml", "--frame", "1"], SLOW),
    ];
    for (command, slow) in commands {
        let child = start(&room, &[&command[..], &slow].concat());
        // It is at work, and takes Ctrl-C from its first line on.
        sleep(Duration::from_millis(100));
        assert_eq!(interrupt(child), Some(130), "{command:?}");
        assert_eq!(temporaries(&room), Vec::<String>::new());
    }
}
