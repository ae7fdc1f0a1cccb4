//! `lunoid replay --live`: the run in a browser, and nothing of it in the folder.

use std::collections::BTreeMap;
use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::{TcpListener, TcpStream};
use std::path::Path;
use std::process::{Child, ChildStderr, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use loop_protocol::Message;
use serde_json::{Value, json};

use crate::scene::Scene;

/// Long enough for any wait of these tests on a busy computer.
const PATIENCE: Duration = Duration::from_secs(300);

/// Frames of a run that is looked at while it is drawn.
const LONG: &str = "frames = 400";

/// A command with `--live`, and the cookie of the browser that it admitted.
struct Live {
    child: Child,
    says: BufReader<ChildStderr>,
    /// Host and port of its page.
    place: String,
    token: String,
}

impl Drop for Live {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

fn command(scene: &Scene, arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_lunoid"));
    command.current_dir(scene.path()).args(arguments).args(["--live", "--no-open", "--no-progress"]);
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    command
}

impl Live {
    fn started(scene: &Scene, arguments: &[&str]) -> Self {
        let mut child = command(scene, arguments).spawn().unwrap();
        let mut says = BufReader::new(child.stderr.take().unwrap());
        let mut line = String::new();
        says.read_line(&mut line).unwrap();
        let address = line.trim().strip_prefix("live: http://").unwrap_or_else(|| panic!("{line}"));
        let (place, token) = address.split_once("/?token=").unwrap();
        Self { place: place.to_owned(), token: token.to_owned(), child, says }
    }

    /// Sends the lines of a head; the stream with the reply.
    fn sent(&self, path: &str, lines: &[(&str, &str)]) -> TcpStream {
        let mut stream = TcpStream::connect(&self.place).unwrap();
        stream.set_read_timeout(Some(PATIENCE)).unwrap();
        let lines: String = lines.iter().map(|(name, value)| format!("{name}: {value}\r\n")).collect();
        write!(stream, "GET {path} HTTP/1.1\r\n{lines}\r\n").unwrap();
        stream
    }

    /// Head and body of a reply.
    fn asked(&self, path: &str, cookie: &str) -> (String, Vec<u8>) {
        let mut reply = Vec::new();
        let mut stream = self.sent(path, &[("Host", &self.place), ("Cookie", cookie)]);
        stream.read_to_end(&mut reply).unwrap();
        let end = reply.windows(4).position(|four| four == b"\r\n\r\n").expect("a head") + 4;
        let body = reply.split_off(end);
        (String::from_utf8(reply).unwrap(), body)
    }

    /// The cookie of the browser that brings the token.
    fn admitted(&self) -> String {
        let (head, _) = self.asked(&format!("/?token={}", self.token), "");
        assert!(head.contains("\r\nLocation: /live.html\r\n"), "{head}");
        let cookie = head.lines().find_map(|line| line.strip_prefix("Set-Cookie: ")).expect("a cookie");
        cookie.split(';').next().unwrap().to_owned()
    }

    /// How far the run is.
    fn state(&self, cookie: &str) -> Value {
        serde_json::from_slice(&self.asked("/live.json", cookie).1).unwrap()
    }

    /// The first state that is such.
    fn wait(&self, cookie: &str, is_met: impl Fn(&Value) -> bool) -> Value {
        let began = Instant::now();
        loop {
            let state = self.state(cookie);
            if is_met(&state) {
                return state;
            }
            assert!(began.elapsed() < PATIENCE, "{state}");
            sleep(Duration::from_millis(5));
        }
    }

    /// Sends requests on a socket of the page; headers of the replies.
    fn requests(&self, cookie: &str, requests: &[Value]) -> Vec<Value> {
        let origin = format!("http://{}", self.place);
        let mut stream = self.sent(
            "/loop",
            &[
                ("Host", &self.place),
                ("Origin", &origin),
                ("Cookie", cookie),
                ("Connection", "Upgrade"),
                ("Upgrade", "websocket"),
                ("Sec-WebSocket-Version", "13"),
                ("Sec-WebSocket-Key", "dGhlIHNhbXBsZSBub25jZQ=="),
            ],
        );
        let mut head = Vec::new();
        while !head.ends_with(b"\r\n\r\n") {
            let mut byte = [0];
            stream.read_exact(&mut byte).unwrap();
            head.push(byte[0]);
        }
        assert!(head.starts_with(b"HTTP/1.1 101 "), "{}", String::from_utf8_lossy(&head));
        let answer = |request: &Value| {
            write_frame(&mut stream, &Message::new(request.clone()).encode());
            Value::Object(Message::decode(&read_frame(&mut stream)).unwrap().header)
        };
        requests.iter().map(answer).collect()
    }

    /// Sends Ctrl-C; the code with which the command ends, and what it says from here on.
    fn told_to_end(&mut self) -> (Option<i32>, String) {
        let id = self.child.id().to_string();
        assert!(Command::new("kill").args(["-INT", &id]).status().unwrap().success());
        let mut said = String::new();
        self.says.read_to_string(&mut said).unwrap();
        (self.child.wait().unwrap().code(), said)
    }

    /// Waits until the page of the run is served, and ends the command.
    fn ended(&mut self, cookie: &str) {
        self.wait(cookie, |state| state["is_finished"] == true);
        let (code, said) = self.told_to_end();
        assert!(code == Some(0) && said.contains("its page stays until Ctrl-C"), "{code:?} {said}");
    }
}

/// A masked binary message of a WebSocket; the mask is zero.
fn write_frame(to: &mut impl Write, bytes: &[u8]) {
    let length = u16::try_from(bytes.len()).unwrap().to_be_bytes();
    to.write_all(&[&[0x82, 0x80 | 126], &length[..], &[0; 4], bytes].concat()).unwrap();
}

fn read_frame(from: &mut impl Read) -> Vec<u8> {
    let mut head = [0; 2];
    from.read_exact(&mut head).unwrap();
    assert_eq!(head[0], 0x82, "a whole binary message");
    let mut length = vec![
        0;
        match head[1] {
            126 => 2,
            127 => 8,
            _ => 0,
        }
    ];
    from.read_exact(&mut length).unwrap();
    let long = length.iter().fold(0, |sum, byte| 256 * sum + usize::from(*byte));
    let mut bytes = vec![0; if length.is_empty() { usize::from(head[1]) } else { long }];
    from.read_exact(&mut bytes).unwrap();
    bytes
}

/// The files of a run, without the times that it took.
fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut found = BTreeMap::new();
    for entry in fs::read_dir(folder).unwrap().map(Result::unwrap) {
        let name = entry.file_name().into_string().unwrap();
        if entry.path().is_dir() {
            let below = files(&entry.path()).into_iter();
            found.extend(below.map(|(file, bytes)| (format!("{name}/{file}"), bytes)));
        } else if name != "performance.json" {
            found.insert(name, fs::read(entry.path()).unwrap());
        }
    }
    found
}

fn code(head: &str) -> &str {
    head.get(9..12).unwrap_or(head)
}

#[test]
fn the_folder_is_the_same_with_a_page_that_looks_on() {
    let scene = Scene::new();
    scene.expect(0, &["replay", "tiny.toml", "--probe", "1:7", "--out", "alone"]);
    let mut live = Live::started(&scene, &["replay", "tiny.toml", "--probe", "1:7", "--out", "seen"]);
    let cookie = live.admitted();
    live.wait(&cookie, |state| state["is_finished"] == true);
    let opened = json!({ "id": 1, "do": "open" });
    let frame = json!({ "id": 2, "do": "frame", "frame": 2, "planes": [] });
    let probe = json!({ "id": 3, "do": "probe", "signals": ["mu.height"], "sweeps": [20, 21], "frame": 2 });
    let replies = live.requests(&cookie, &[opened, frame, probe]);
    let record: Value = serde_json::from_slice(&live.asked("/run.json", &cookie).1).unwrap();
    assert_eq!(replies[1]["ok"]["hash"], record["frames"][2]["pixels_blake3"], "{replies:?}");
    assert_eq!(replies[2]["ok"]["signals"][0]["name"], "mu.height", "{replies:?}");
    live.ended(&cookie);
    let [alone, seen] = ["alone", "seen"].map(|folder| files(&scene.join(folder)));
    assert!(alone.len() > 8 && alone.contains_key("frames/frame-000003.png"));
    assert_eq!(seen, alone, "a page changes no byte of the run");
}

#[test]
fn the_page_of_the_run_is_served_with_what_it_needs_and_the_folder_keeps_its_own() {
    let scene = Scene::new();
    let mut live = Live::started(&scene, &["replay", "tiny.toml"]);
    let cookie = live.admitted();
    live.wait(&cookie, |state| state["is_finished"] == true);
    let (head, served) = live.asked("/index.html", &cookie);
    assert_eq!(code(&head), "200");
    let served = String::from_utf8(served).unwrap();
    let own = fs::read_to_string(scene.join("runs/tiny/index.html")).unwrap();
    assert!(served.contains("src=\"live-sweep.js\"") && served.contains("connect-src 'self'"));
    assert!(!own.contains("live-sweep.js") && !own.contains("connect-src"));
    // Every script that the pages name is there.
    let mut waiting = vec!["live.html".to_owned(), "live-sweep.js".to_owned()];
    let mut seen = Vec::new();
    while let Some(name) = waiting.pop() {
        let (head, body) = live.asked(&format!("/{name}"), &cookie);
        assert_eq!(code(&head), "200", "{name}");
        let text = String::from_utf8(body).unwrap();
        let names = text.split(['"', '\'']).map(|word| word.trim_start_matches("./"));
        let imported = text.lines().filter(|line| line.contains(" from \"") || line.contains("src="));
        let imported: String = imported.collect();
        for other in names.filter(|name| name.ends_with(".js") && imported.contains(name)) {
            if !seen.contains(&other.to_owned()) {
                seen.push(other.to_owned());
                waiting.push(other.to_owned());
            }
        }
    }
    for needed in ["live.js", "lunoid.js", "socket-home.js", "message.js"] {
        assert!(seen.contains(&needed.to_owned()), "{needed}: {seen:?}");
    }
    let (_, picture) = live.asked("/frames/frame-000003.png", &cookie);
    assert_eq!(picture, fs::read(scene.join("runs/tiny/frames/frame-000003.png")).unwrap());
    live.ended(&cookie);
}

#[test]
fn nothing_but_files_of_the_run_is_given_and_only_to_the_browser_that_was_admitted() {
    let scene = Scene::new();
    scene.write("secret.txt", "mine");
    let mut live = Live::started(&scene, &["replay", "tiny.toml"]);
    assert!(live.place.starts_with("127.0.0.1:"), "{}", live.place);
    let (head, _) = live.asked("/live.json", "");
    assert_eq!(code(&head), "403", "without a cookie");
    let cookie = live.admitted();
    let (head, body) = live.asked(&format!("/?token={}", live.token), "");
    let said = String::from_utf8(body).unwrap();
    assert!(code(&head) == "403" && said.contains("another browser"), "a second browser: {said}");
    live.wait(&cookie, |state| state["is_finished"] == true);
    scene.write("runs/tiny/notes.txt", "mine");
    for path in [
        "/../../secret.txt",
        "/frames/../../../secret.txt",
        "/%2e%2e/%2e%2e/secret.txt",
        "/notes.txt",
        "/tiny.toml",
        "//etc/passwd",
        "/frames/frame-000009.png",
        "/frames/frame-000000.png/",
    ] {
        assert_eq!(code(&live.asked(path, &cookie).0), "404", "{path}");
    }
    let mut reply = String::new();
    let stranger = [("Host", "evil.example"), ("Cookie", &*cookie)];
    live.sent("/live.json", &stranger).read_to_string(&mut reply).unwrap();
    assert!(
        code(&reply) == "421" && reply.ends_with("open the one that the command has printed\n"),
        "{reply}"
    );
    // A second page of the admitted browser is a client like the first.
    assert_eq!(live.state(&cookie)["is_finished"], true);
    live.ended(&cookie);
}

#[test]
fn while_the_run_is_drawn_pages_look_on_and_compute_nothing_and_clients_that_hang_do_not_hold_it() {
    let scene = Scene::new();
    scene.vary("long.toml", "frames = 4", LONG);
    let long = ["replay", "long.toml", "--samples", "1500"];
    let mut live = Live::started(&scene, &long);
    let cookie = live.admitted();
    // Clients that say nothing, half a head, or take no byte of their reply.
    let silent: Vec<TcpStream> = (0..20).map(|_| TcpStream::connect(&live.place).unwrap()).collect();
    let mut half = TcpStream::connect(&live.place).unwrap();
    half.write_all(b"GET /live.json HTTP/1.1\r\nHo").unwrap();
    let deaf: Vec<TcpStream> =
        (0..10).map(|_| live.sent("/live.json", &[("Host", &live.place), ("Cookie", &cookie)])).collect();
    let drawn = live.wait(&cookie, |state| state["picture"].is_object());
    assert_eq!(drawn["is_finished"], false, "the run is drawn: {drawn}");
    assert_eq!(drawn["frames"], 400);
    let file = drawn["picture"]["file"].as_str().unwrap();
    let (head, picture) = live.asked(&format!("/{file}"), &cookie);
    assert!(head.contains("\r\nContent-Type: image/png\r\n") && picture.starts_with(b"\x89PNG"), "{head}");
    assert_eq!(code(&live.asked("/index.html", &cookie).0), "404", "the page of the run is not there yet");
    let replies = live.requests(&cookie, &[json!({ "id": 1, "do": "open" })]);
    let problem = &replies[0]["error"]["problems"][0];
    assert_eq!(problem["title"], "the run is being drawn", "{replies:?}");
    // Ctrl-C ends run and page.
    let (code, said) = live.told_to_end();
    assert!(code == Some(130) && said.contains("the same command again draws the rest"), "{code:?} {said}");
    assert!(TcpStream::connect(&live.place).is_err(), "the page has ended too");
    drop((silent, half, deaf));
    // What was interrupted goes on with a page, to the same bytes.
    let mut again = Live::started(&scene, &long);
    let cookie = again.admitted();
    again.ended(&cookie);
    scene.expect(0, &[&long[..], &["--out", "alone"]].concat());
    assert_eq!(files(&scene.join("runs/long")), files(&scene.join("alone")));
}

#[test]
fn what_cannot_be_shown_is_said_before_anything_is_drawn() {
    let scene = Scene::new();
    let said = |arguments: &[&str]| {
        let output = command(&scene, arguments).output().unwrap();
        assert!(!scene.join("runs/tiny/frames").exists(), "nothing is drawn");
        (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
    };
    let (code, text) = said(&["replay", "tiny.toml", "--depth", "16"]);
    assert!(code == Some(2) && text.contains("--depth 16 asks for 16; leave one of the two out"), "{text}");
    let (code, text) = said(&["replay", "tiny.toml", "--no-page"]);
    assert!(code == Some(2) && text.contains("cannot be used with"), "{text}");
    let (code, text) = said(&["replay", "tiny.toml", "--machine", "ideal", "--machine", "exact"]);
    assert!(code == Some(2) && text.contains("--live: this belongs to one run"), "{text}");
    let taken = TcpListener::bind("127.0.0.1:0").unwrap();
    let port = taken.local_addr().unwrap().port().to_string();
    let (code, text) = said(&["replay", "tiny.toml", "--port", &port]);
    assert!(code == Some(4) && text.contains("name another port"), "{text}");
    scene.expect(2, &["replay", "tiny.toml", "--port", "8080"]);
    scene.expect(2, &["replay", "tiny.toml", "--no-open"]);
}
