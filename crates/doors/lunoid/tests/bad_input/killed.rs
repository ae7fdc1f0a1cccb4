//! Runs that are killed at any moment, and runs that meet in one folder.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use crate::room::{OUTPUT, Room, content};

/// Long enough to be killed in the middle.
const FRAMES: usize = 120;

fn replay<'a>(out: &'a str, options: &[&'a str]) -> Vec<&'a str> {
    let base = ["replay", "long.toml", "--no-progress", "--samples", "1500", "--out", out];
    [&base[..], options].concat()
}

fn words(command: &str) -> Vec<&str> {
    command.split(' ').collect()
}

fn room() -> Room {
    let room = Room::new();
    room.vary("long.toml", "frames = 4", &format!("frames = {FRAMES}"));
    room
}

fn start(room: &Room, arguments: &[&str]) -> Child {
    room.command(arguments).stdout(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap()
}

fn signal(child: &Child, name: &str) {
    // A run that has ended already is a moment as well.
    let _ =
        Command::new("kill").args([name, &child.id().to_string()]).stderr(Stdio::null()).status().unwrap();
}

/// Stops a process and waits until all its threads rest: one that is about to write still does after the signal.
fn stop(child: &Child) {
    signal(child, "-STOP");
    let tasks = format!("/proc/{}/task", child.id());
    let rests = |task: &Path| {
        fs::read_to_string(task.join("status")).is_ok_and(|status| status.contains("State:\tT"))
    };
    let began = Instant::now();
    while fs::read_dir(&tasks).is_ok_and(|mut tasks| tasks.any(|task| !rests(&task.unwrap().path()))) {
        assert!(began.elapsed() < Duration::from_secs(60), "{tasks}: does not stop");
        sleep(Duration::from_millis(1));
    }
}

/// A finished run, without the times that it took.
fn run(folder: &Path) -> BTreeMap<PathBuf, Option<Vec<u8>>> {
    let all = content(folder).into_iter();
    let all = all.map(|(path, bytes)| (path.strip_prefix(folder).unwrap().to_owned(), bytes));
    all.filter(|(path, _)| path != Path::new("performance.json")).collect()
}

/// Every picture that is there is whole.
fn pictures_are_whole(folder: &Path, whole: &BTreeMap<PathBuf, Option<Vec<u8>>>) -> usize {
    let frames = folder.join("frames");
    let entries = fs::read_dir(&frames).into_iter().flatten().map(|entry| entry.unwrap().path());
    let pictures: Vec<PathBuf> =
        entries.filter(|path| path.extension().is_some_and(|kind| kind == "png")).collect();
    for picture in &pictures {
        let name = picture.strip_prefix(folder).unwrap();
        assert_eq!(Some(fs::read(picture).unwrap()), whole[name], "{}", name.display());
    }
    pictures.len()
}

/// Until there are so many pictures, or the run has ended: a clock would measure what else the computer does.
fn wait_for_pictures(child: &mut Child, folder: &Path, count: usize) {
    let pictures = || fs::read_dir(folder.join("frames")).into_iter().flatten().count();
    while pictures() < count && child.try_wait().unwrap().is_none() {
        sleep(Duration::from_millis(1));
    }
}

/// `runs` runs, each killed twice at random moments, the second time while it is resumed, and then resumed to its end.
pub fn killed_and_resumed(runs: u32, seed: u64) {
    println!("seed {seed}");
    let mut dice = seed;
    // Steele and Vigna's splitmix64.
    let mut up_to = |end: u64| {
        dice = dice.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (dice ^ (dice >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (mixed ^ (mixed >> 31)) % end
    };
    let room = room();
    room.done(&replay("whole", &["--apng"]));
    let whole = run(&room.join("whole"));
    let mut interrupted = 0;
    for moment in 0..runs {
        let out = format!("killed-{moment}");
        let folder = room.join(&out);
        let arguments = replay(&out, &["--apng", "--jobs", ["1", "2", "3"][moment as usize % 3]]);
        let name = if moment % 2 == 0 { "-KILL" } else { "-INT" };
        for _ in 0..2 {
            let mut child = start(&room, &arguments);
            wait_for_pictures(&mut child, &folder, up_to(FRAMES as u64) as usize);
            sleep(Duration::from_micros(up_to(20_000)));
            signal(&child, name);
            let status = child.wait().unwrap();
            assert!(status.code().is_none_or(|code| code == 0 || code == 130), "{moment}: {status}");
            let pictures = pictures_are_whole(&folder, &whole);
            interrupted += usize::from((1..FRAMES).contains(&pictures));
        }
        room.done(&arguments);
        assert!(run(&folder) == whole, "{name} {moment}: another folder than that of a run in one go");
        fs::remove_dir_all(folder).unwrap();
    }
    println!("{} kills, {interrupted} of them inside a run; all {runs} runs resumed byte for byte", 2 * runs);
    assert!(interrupted > runs as usize / 3, "only {interrupted} moments were inside the run");
}

#[test]
fn a_run_that_is_killed_at_any_moment_goes_on() {
    killed_and_resumed(6, 1970);
}

/// While its sweeps are checked a run has all its frames and no record yet.
#[test]
fn a_check_that_is_killed_is_made_again() {
    const FRAMES: usize = 4;
    let room = Room::new();
    let command =
        |out: &str| format!("replay tiny.toml --no-progress --samples 1500 --check 120 --out {out}");
    room.done(&words(&command("whole")));
    let whole = run(&room.join("whole"));
    let mut checking = 0;
    for moment in 0..8_u64 {
        let out = format!("killed-{moment}");
        let folder = room.join(&out);
        let command = command(&out);
        let mut child = start(&room, &words(&command));
        wait_for_pictures(&mut child, &folder, if moment == 0 { 1 } else { FRAMES });
        sleep(Duration::from_millis(5 * moment));
        signal(&child, if moment % 2 == 0 { "-KILL" } else { "-INT" });
        child.wait().unwrap();
        let pictures = pictures_are_whole(&folder, &whole);
        checking += usize::from(pictures == FRAMES && !folder.join("run.json").exists());
        room.done(&words(&command));
        assert!(run(&folder) == whole, "moment {moment}: another folder than that of a run in one go");
    }
    assert!(checking > 2, "only {checking} moments were inside the check");
}

#[test]
fn threads_change_no_byte() {
    let room = room();
    let names = ["1", "2", "3"];
    for jobs in names {
        room.done(&replay(jobs, &["--frames", "0..12", "--apng", "--refresh", "--jobs", jobs]));
    }
    let [one, two, three] = names.map(|name| run(&room.join(name)));
    assert!(one.len() > 12 * 3 && one == two && one == three);
}

#[test]
fn a_second_run_in_the_folder_is_refused_and_the_first_goes_on() {
    let room = room();
    room.done(&replay("whole", &[]));
    let mut first = start(&room, &replay("r", &[]));
    let began = Instant::now();
    while !room.join("r/frames/frame-000001.png").exists() && began.elapsed() < Duration::from_secs(60) {
        sleep(Duration::from_millis(1));
    }
    stop(&first);
    let holder = format!("process {}", first.id());
    for options in [&[][..], &["--fresh"], &["--sweeps", "20"]] {
        room.refused(OUTPUT, &replay("r", options), &[&holder, "wait for it or choose another --out"]);
    }
    signal(&first, "-CONT");
    assert!(first.wait().unwrap().success());
    assert!(run(&room.join("r")) == run(&room.join("whole")));
}
