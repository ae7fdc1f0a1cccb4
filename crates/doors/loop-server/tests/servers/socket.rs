//! A Unix socket: one client after another.

use std::net::Shutdown;
use std::os::unix::net::UnixStream;
use std::sync::mpsc;
use std::thread;

use loop_server::on_unix_socket;
use serde_json::json;

use crate::home::{fault, faulty, hello, said, session};

#[test]
fn rubbish_lets_one_client_go_and_the_next_is_served() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("loop.sock");
    let (hear, heard) = mpsc::channel();
    let own = path.clone();
    thread::spawn(move || on_unix_socket(&own, session, |said| hear.send(said.to_owned()).unwrap()));
    assert!(heard.recv().unwrap().starts_with("listening on "));
    let spoken = |bytes: &[u8]| {
        let stream = UnixStream::connect(&path).unwrap();
        let other = stream.try_clone().unwrap();
        said(stream, || other.shutdown(Shutdown::Write).unwrap(), bytes)
    };
    let first = spoken(&hello());
    let faulty = spoken(&[faulty(), hello()].concat());
    assert_eq!((faulty.len(), fault(&faulty[0])), (2, "no type of numbers"), "its client goes on");
    assert_eq!((&faulty[0]["id"], &faulty[1]["ok"]), (&json!(9), &first[0]["ok"]));
    let bad = spoken(b"rubbish, and much more of it");
    assert_eq!((bad.len(), fault(&bad[0])), (1, "the bytes are no message of lunoid.loop/1"));
    assert!(heard.recv().unwrap().starts_with("warning: a client was let go: "));
    drop(UnixStream::connect(&path).unwrap());
    assert!(first.len() == 1 && spoken(&hello()) == first);
    let taken = on_unix_socket(&path, session, |_| ()).unwrap_err().to_string();
    assert!(taken.ends_with("name another path"), "{taken}");
}

#[test]
fn the_file_of_a_server_that_has_ended_is_replaced_and_no_other_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("loop.sock");
    drop(std::os::unix::net::UnixListener::bind(&path).unwrap());
    assert!(path.exists(), "the file stays behind");
    let (hear, heard) = mpsc::channel();
    let own = path.clone();
    thread::spawn(move || on_unix_socket(&own, session, |said| hear.send(said.to_owned()).unwrap()));
    assert!(heard.recv().unwrap().starts_with("listening on "));
    let notes = folder.path().join("notes");
    std::fs::write(&notes, "mine").unwrap();
    assert!(on_unix_socket(&notes, session, |_| ()).is_err());
    assert_eq!(std::fs::read(&notes).unwrap(), b"mine");
}
