//! Bytes of requests in, bytes of replies out, as a worker exchanges them.

use std::path::Path;
use std::sync::{Mutex, MutexGuard, PoisonError};

use browser::Host;
use drive::{Drive, Wishes};
use loop_protocol::{Message, Plane};
use serde_json::{Value, json};

const SCENARIO: &str = "scenarios/craters.toml";

/// Given files are the process's: one test has them at a time.
fn turn() -> MutexGuard<'static, ()> {
    static TURN: Mutex<()> = Mutex::new(());
    let turn = TURN.lock().unwrap_or_else(PoisonError::into_inner);
    files::take_back_all();
    turn
}

fn on_disk(name: &str) -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../..").join(name)
}

/// The files of the repository as planes.
fn planes(names: &[&str]) -> Vec<Plane> {
    names.iter().map(|name| Plane::of_file(*name, std::fs::read(on_disk(name)).unwrap())).collect()
}

fn ask(host: &mut Host, request: Value, planes: Vec<Plane>) -> Message {
    let bytes = Message::new(request).with(planes).encode();
    host.reserve(bytes.len()).unwrap().copy_from_slice(&bytes);
    host.answer();
    Message::decode(host.reply()).unwrap()
}

fn small() -> Value {
    json!({ "raster.sweeps": 40, "raster.samples_per_sweep": 60 })
}

fn open(host: &mut Host) -> Message {
    let request = json!({ "id": 1, "do": "open", "scenario": SCENARIO, "set": small() });
    ask(host, request, planes(&[SCENARIO, "scenarios/craters.csv"]))
}

/// What is wrong with the first thing that is wrong.
fn problem(reply: &Message) -> Value {
    reply.header["error"]["problems"][0].clone()
}

#[test]
fn given_files_have_the_picture_of_the_disk() {
    let _turn = turn();
    let mut host = Host::default();
    let opened = open(&mut host);
    assert!(opened.header.contains_key("ok"), "{:?}", opened.header);
    let seen = ask(&mut host, json!({ "id": 2, "do": "frame", "frame": 3 }), Vec::new());
    let set = ["raster.sweeps", "raster.samples_per_sweep"].map(str::to_owned);
    let wishes =
        Wishes { set: set.into_iter().zip(["40".into(), "60".into()]).collect(), ..Wishes::default() };
    let native = Drive::open(&on_disk(SCENARIO), &wishes, 1).unwrap();
    assert_eq!(seen.header["ok"]["hash"], native.frame(3).unwrap().hash());
    assert_ne!(seen.header["ok"]["hash"], native.frame(4).unwrap().hash());
    let picture = seen.plane("picture").unwrap();
    assert_eq!(picture.bytes().len(), picture.shape().iter().product::<usize>());
}

#[test]
fn a_file_that_was_not_given_is_missing_though_it_is_on_the_disk() {
    let _turn = turn();
    let mut host = Host::default();
    let request = json!({ "id": 1, "do": "open", "scenario": SCENARIO });
    let reply = ask(&mut host, request, planes(&[SCENARIO]));
    assert!(problem(&reply).to_string().contains("craters.csv: no such file"), "{reply:?}");
    for scenario in ["../scenarios/craters.toml", "/etc/hostname", "given:../Cargo.toml"] {
        let reply = ask(&mut host, json!({ "id": 2, "do": "open", "scenario": scenario }), Vec::new());
        assert!(problem(&reply)["title"].as_str().unwrap().contains("no such file"), "{reply:?}");
    }
    let reply = ask(&mut host, json!({ "id": 3, "do": "open" }), Vec::new());
    assert_eq!(problem(&reply)["key"], "scenario");
}

#[test]
fn machines_and_overlays_may_be_given() {
    let _turn = turn();
    let mut host = Host::default();
    let own =
        Plane::of_file("models/own.toml", std::fs::read(on_disk("hardware-models/ideal.toml")).unwrap());
    let late = Plane::of_file("models/late.toml", b"[loader]\naccess_ns = 90\n".to_vec());
    let mut given = planes(&[SCENARIO, "scenarios/craters.csv"]);
    given.extend([own, late]);
    let request = json!({ "id": 1, "do": "open", "scenario": SCENARIO, "machine": "models/own.toml",
                          "overlays": ["models/late.toml"], "set": small() });
    let opened = ask(&mut host, request, given);
    assert!(opened.header.contains_key("ok"), "{:?}", opened.header);
    let reply = ask(&mut host, json!({ "id": 2, "do": "parameters" }), Vec::new());
    let rows = reply.header["ok"]["parameters"].as_array().unwrap();
    let access = rows.iter().find(|row| row["key"] == "loader.access_ns").unwrap();
    assert!(access["source"].to_string().contains("given:models/late.toml"), "{access}");
}

#[test]
fn what_is_refused_changes_nothing() {
    let _turn = turn();
    let mut host = Host::default();
    open(&mut host);
    let before = ask(&mut host, json!({ "id": 2, "do": "state" }), Vec::new());
    let outside = Plane::of_file("../x.toml", b"format = 1".to_vec());
    let request = json!({ "id": 3, "do": "open", "scenario": SCENARIO });
    let reply = ask(&mut host, request, vec![outside]);
    assert_eq!(problem(&reply)["file"], "../x.toml");
    for bytes in [&b""[..], b"rubbish", b"lunoid.1\xff\xff\xff\xff\xff\xff\xff\xff\0\0\0\0\0\0\0\0"] {
        host.reserve(bytes.len()).unwrap().copy_from_slice(bytes);
        host.answer();
        assert_eq!(problem(&Message::decode(host.reply()).unwrap())["file"], "message");
    }
    assert!(host.reserve(usize::MAX).is_none());
    let after = ask(&mut host, json!({ "id": 2, "do": "state" }), Vec::new());
    assert_eq!(before, after);
    host.release();
    assert!(host.reply().is_empty());
}
