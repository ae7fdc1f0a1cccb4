//! `lunoid drive`: the page, its one browser, and what cannot be served.

use std::io::{BufRead, BufReader, Read, Write};
use std::net::{TcpListener, TcpStream};
use std::path::Path;
use std::process::{Child, Command, Stdio};

struct Program {
    child: Child,
    /// Host and port of its page.
    place: String,
    token: String,
}

impl Drop for Program {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

fn lunoid(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_lunoid"));
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../..");
    command.current_dir(root).args(["drive", "--no-open"]).args(arguments);
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    command
}

fn started() -> Program {
    let mut child = lunoid(&["scenarios/profile.toml"]).spawn().unwrap();
    let mut address = String::new();
    BufReader::new(child.stdout.as_mut().unwrap()).read_line(&mut address).unwrap();
    let (place, token) = address.trim().strip_prefix("http://").unwrap().split_once("/?token=").unwrap();
    Program { place: place.to_owned(), token: token.to_owned(), child }
}

impl Program {
    fn asked(&self, path: &str, cookie: &str) -> String {
        let mut stream = TcpStream::connect(&self.place).unwrap();
        let place = &self.place;
        write!(stream, "GET {path} HTTP/1.1\r\nHost: {place}\r\nCookie: {cookie}\r\n\r\n").unwrap();
        let mut reply = String::new();
        stream.read_to_string(&mut reply).unwrap();
        reply
    }
}

#[test]
fn the_page_is_whole_and_knows_its_scenario() {
    let program = started();
    assert!(program.place.starts_with("127.0.0.1:"), "{}", program.place);
    let admitted = program.asked(&format!("/?token={}", program.token), "");
    let cookie = admitted.lines().find_map(|line| line.strip_prefix("Set-Cookie: ")).expect("a cookie");
    let cookie = cookie.split(';').next().unwrap();
    let list = program.asked("/scenarios.json", cookie);
    let list: serde_json::Value = serde_json::from_str(list.split_once("\r\n\r\n").unwrap().1).unwrap();
    let rows = list["scenarios"].as_array().unwrap();
    assert!(rows.len() == 1 && rows[0]["scenario"] == "scenarios/profile.toml", "{list}");
    assert!(program.asked("/here.js", cookie).contains("SocketHome"), "the page reaches the program");
    // Every file that a page of the program names is there.
    let mut waiting = vec!["instrument.html".to_owned(), "gallery.html".to_owned()];
    let mut seen = waiting.clone();
    while let Some(name) = waiting.pop() {
        let reply = program.asked(&format!("/{name}"), cookie);
        assert!(reply.starts_with("HTTP/1.1 200 "), "{name}: {reply}");
        for other in reply.split(['"', '\'']).map(|word| word.trim_start_matches("./")) {
            let is_file = [".js", ".css", ".svg"].iter().any(|ending| other.ends_with(ending));
            let is_new = is_file && !other.contains(['/', ' ']) && !seen.contains(&other.to_owned());
            if is_new {
                seen.push(other.to_owned());
                waiting.push(other.to_owned());
            }
        }
    }
    assert!(seen.len() > 15, "{seen:?}");
    assert!(program.asked("/index.html", cookie).starts_with("HTTP/1.1 404 "), "the first page needs a site");
}

#[test]
fn what_cannot_be_served_is_said_before_anything_is_opened() {
    let said = |arguments: &[&str]| {
        let output = lunoid(arguments).output().unwrap();
        assert!(output.stdout.is_empty(), "no address is printed");
        (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
    };
    let (code, text) = said(&["scenarios/no-such.toml"]);
    assert!(code == Some(3) && text.contains("no-such"), "{text}");
    let (code, text) = said(&["scenarios/profile.toml", "--set", "loader.no_such=1"]);
    assert!(code == Some(3) && text.contains("no_such"), "{text}");
    let taken = TcpListener::bind("127.0.0.1:0").unwrap();
    let port = taken.local_addr().unwrap().port().to_string();
    let (code, text) = said(&["scenarios/profile.toml", "--port", &port]);
    assert!(code == Some(4) && text.contains("name another port"), "{text}");
}
