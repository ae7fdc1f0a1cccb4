//! The page: admitted by a token once, then by a cookie, from its own origin alone.

use std::io::{Read, Write};
use std::net::{Shutdown, TcpStream};
use std::sync::mpsc;
use std::thread;
use std::time::Duration;

use loop_protocol::Message;
use loop_server::{PageFiles, PageServer};
use serde_json::Value;
use tungstenite::protocol::{Role, WebSocket};

use crate::home::{fault, hello, session};

struct Served {
    port: u16,
    token: String,
}

fn served() -> Served {
    let mut files = PageFiles::default();
    files.put("instrument.html", &b"<p>the page</p>"[..]);
    files.put("here.js", &b"export {};"[..]);
    let server = PageServer::bind(0, "/instrument.html", files).unwrap();
    let address = server.address();
    let (place, token) = address.split_once("/?token=").unwrap();
    let served = Served { port: place.rsplit(':').next().unwrap().parse().unwrap(), token: token.to_owned() };
    thread::spawn(move || server.serve(session, |_| ()));
    served
}

impl Served {
    fn host(&self) -> String {
        format!("127.0.0.1:{}", self.port)
    }

    fn sent(&self, bytes: &[u8]) -> String {
        let mut stream = TcpStream::connect(("127.0.0.1", self.port)).unwrap();
        let _ = stream.write_all(bytes);
        stream.shutdown(Shutdown::Write).unwrap();
        let mut reply = String::new();
        stream.read_to_string(&mut reply).unwrap();
        reply
    }

    /// The reply to GET with these lines of a head.
    fn asked(&self, path: &str, lines: &[(&str, &str)]) -> String {
        let lines: String = lines.iter().map(|(name, value)| format!("{name}: {value}\r\n")).collect();
        self.sent(format!("GET {path} HTTP/1.1\r\n{lines}\r\n").as_bytes())
    }

    /// The cookie of a browser that brings the token.
    fn admitted(&self) -> String {
        let reply = self.asked(&format!("/?token={}", self.token), &[("Host", &self.host())]);
        assert!(
            reply.starts_with("HTTP/1.1 303 ") && reply.contains("\r\nLocation: /instrument.html\r\n"),
            "{reply}"
        );
        let cookie = reply.lines().find_map(|line| line.strip_prefix("Set-Cookie: ")).unwrap();
        assert!(cookie.ends_with("; Path=/; HttpOnly; SameSite=Strict"), "{cookie}");
        cookie.split(';').next().unwrap().to_owned()
    }
}

fn status(reply: &str) -> &str {
    reply.get(9..12).unwrap_or(reply)
}

#[test]
fn the_token_admits_one_browser_and_the_cookie_keeps_it() {
    let served = served();
    let host = ("Host", &*served.host());
    assert_eq!(status(&served.asked("/instrument.html", &[host])), "403");
    assert_eq!(status(&served.asked("/", &[host])), "403");
    assert_eq!(status(&served.asked("/?token=00000000000000000000000000000000", &[host])), "403");
    let cookie = served.admitted();
    let spent = served.asked(&format!("/?token={}", served.token), &[host]);
    assert!(status(&spent) == "403" && spent.contains("another browser"), "{spent}");
    let own = [host, ("Cookie", &*cookie)];
    let page = served.asked("/instrument.html", &own);
    assert!(page.starts_with("HTTP/1.1 200 ") && page.ends_with("\r\n\r\n<p>the page</p>"), "{page}");
    assert!(
        page.contains("\r\nContent-Type: text/html; charset=utf-8\r\n")
            && page.contains("\r\nX-Content-Type-Options: nosniff\r\n")
    );
    assert!(served.asked("/here.js", &own).contains("\r\nContent-Type: text/javascript; charset=utf-8\r\n"));
    assert_eq!(status(&served.asked("/", &own)), "303", "the browser comes again without the token");
    let with_others = format!("a=b; {cookie}; c=d");
    assert_eq!(status(&served.asked("/here.js", &[host, ("Cookie", &with_others)])), "200");
    for path in ["/none.js", "/../instrument.html", "/%2e%2e/instrument.html", "//instrument.html", "/loop/"]
    {
        assert_eq!(status(&served.asked(path, &own)), "404", "{path}");
    }
}

#[test]
fn another_host_another_method_and_rubbish_are_refused() {
    let served = served();
    let cookie = served.admitted();
    let port = served.port;
    for host in [
        "evil.example",
        "127.0.0.1",
        "127.0.0.1:1",
        &format!("evil.example:{port}"),
        &format!("127.0.0.1.evil.example:{port}"),
    ] {
        assert_eq!(
            status(&served.asked("/here.js", &[("Host", host), ("Cookie", &cookie)])),
            "421",
            "{host}"
        );
    }
    assert_eq!(status(&served.asked("/here.js", &[("Cookie", &cookie)])), "421", "no host");
    let twice = [("Host", &*served.host()), ("Host", "evil.example"), ("Cookie", &cookie)];
    assert_eq!(status(&served.asked("/here.js", &twice)), "421", "two hosts");
    let post = format!("POST /here.js HTTP/1.1\r\nHost: {}\r\nCookie: {cookie}\r\n\r\n", served.host());
    assert_eq!(status(&served.sent(post.as_bytes())), "405");
    assert_eq!(status(&served.sent(b"rubbish\r\n\r\n")), "400");
    assert_eq!(status(&served.sent(&hello())), "400");
    assert_eq!(served.sent(b""), "", "a connection ahead of need");
    let local = format!("localhost:{port}");
    assert_eq!(status(&served.asked("/here.js", &[("Host", &local), ("Cookie", &cookie)])), "200");
}

const UPGRADE: [(&str, &str); 4] = [
    ("Connection", "keep-alive, Upgrade"),
    ("Upgrade", "websocket"),
    ("Sec-WebSocket-Version", "13"),
    ("Sec-WebSocket-Key", "dGhlIHNhbXBsZSBub25jZQ=="),
];

/// A socket of the page.
fn opened(served: &Served, cookie: &str) -> WebSocket<TcpStream> {
    let origin = format!("http://{}", served.host());
    let lines = [("Host", &*served.host()), ("Origin", &*origin), ("Cookie", cookie)];
    let lines: String =
        lines.iter().chain(&UPGRADE).map(|(name, value)| format!("{name}: {value}\r\n")).collect();
    let mut stream = TcpStream::connect(("127.0.0.1", served.port)).unwrap();
    stream.write_all(format!("GET /loop HTTP/1.1\r\n{lines}\r\n").as_bytes()).unwrap();
    let mut head = Vec::new();
    while !head.ends_with(b"\r\n\r\n") {
        let mut byte = [0];
        stream.read_exact(&mut byte).unwrap();
        head.push(byte[0]);
    }
    let head = String::from_utf8_lossy(&head).to_lowercase();
    // The answer to this key in RFC 6455.
    assert!(head.starts_with("http/1.1 101 ") && head.contains("s3pplmbitxaq9kygzzhzrbk+xoo="), "{head}");
    WebSocket::from_raw_socket(stream, Role::Client, None)
}

fn answer(socket: &mut WebSocket<TcpStream>, message: tungstenite::Message) -> Value {
    socket.send(message).unwrap();
    let reply = socket.read().unwrap().into_data();
    Value::Object(Message::decode(&reply).unwrap().header)
}

#[test]
fn a_socket_answers_and_goes_on_after_rubbish() {
    let served = served();
    let cookie = served.admitted();
    let [mut first, mut second] = [opened(&served, &cookie), opened(&served, &cookie)];
    let told = answer(&mut first, hello().into());
    assert_eq!(told["ok"]["protocol"], "lunoid.loop/1");
    let rubbish = "the bytes are no message of lunoid.loop/1";
    assert_eq!(fault(&answer(&mut first, b"rubbish".to_vec().into())), rubbish);
    assert_eq!(fault(&answer(&mut first, "text".into())), rubbish);
    assert_eq!(answer(&mut first, hello().into()), told);
    assert_eq!(answer(&mut second, hello().into()), told, "each page has a session of its own");
    first.close(None).unwrap();
    drop(second);
    assert_eq!(answer(&mut opened(&served, &cookie), hello().into()), told);
}

#[test]
fn a_socket_of_another_page_is_refused() {
    let served = served();
    let cookie = served.admitted();
    let own = format!("http://{}", served.host());
    let status_of = |origin: Option<&str>, cookie: Option<&str>| {
        let mut lines = vec![("Host", served.host())];
        lines.extend(origin.map(|origin| ("Origin", origin.to_owned())));
        lines.extend(cookie.map(|cookie| ("Cookie", cookie.to_owned())));
        let lines: Vec<(&str, &str)> =
            lines.iter().map(|(name, value)| (*name, &**value)).chain(UPGRADE).collect();
        let reply = served.asked("/loop", &lines);
        status(&reply).to_owned()
    };
    assert_eq!(status_of(Some(&own), Some(&cookie)), "101");
    for origin in [
        "http://evil.example",
        "null",
        "https://127.0.0.1",
        &format!("https://{}", served.host()),
        "http://localhost:1",
    ] {
        assert_eq!(status_of(Some(origin), Some(&cookie)), "403", "{origin}");
    }
    assert_eq!(status_of(None, Some(&cookie)), "403");
    assert_eq!(status_of(Some(&own), None), "403");
    let lines = [("Host", &*served.host()), ("Origin", &*own), ("Cookie", &*cookie)];
    let bare: Vec<(&str, &str)> = lines.into_iter().chain([("Upgrade", "websocket")]).collect();
    let bare = served.asked("/loop", &bare);
    assert!(status(&bare) == "400" && bare.contains("no socket is opened"), "{bare}");
    assert_eq!(status(&served.asked("/loop", &lines)), "426", "there is room for a page");
    assert_eq!(status(&served.asked("/loop", &lines[..2])), "403", "a stranger is told nothing");
}

#[test]
fn more_pages_than_there_are_places_are_told_so() {
    let served = served();
    let cookie = served.admitted();
    let open: Vec<_> = (0..8).map(|_| opened(&served, &cookie)).collect();
    let own = format!("http://{}", served.host());
    let lines = [("Host", &*served.host()), ("Origin", &*own), ("Cookie", &*cookie)];
    let room = served.asked("/loop", &lines);
    assert!(status(&room) == "503" && room.contains("8 pages are open"), "{room}");
    let lines: Vec<(&str, &str)> = lines.into_iter().chain(UPGRADE).collect();
    assert_eq!(status(&served.asked("/loop", &lines)), "503");
    drop(open);
    let again = || {
        (0..200).any(|_| {
            thread::sleep(Duration::from_millis(10));
            status(&served.asked("/loop", &lines)) == "101"
        })
    };
    assert!(again(), "a page that is closed gives its place back");
}

#[test]
fn a_browser_that_takes_nothing_is_let_go() {
    let mut files = PageFiles::default();
    files.put("large.png", vec![0; 64 << 20]);
    let server = PageServer::bind(0, "/large.png", files).unwrap().with_patience(Duration::from_millis(200));
    let address = server.address();
    let (place, query) = address.strip_prefix("http://").unwrap().split_once('/').unwrap();
    let (hear, heard) = mpsc::channel();
    thread::spawn(move || server.serve(session, |said| hear.send(said.to_owned()).unwrap()));
    let asked = |path: &str, cookie: &str| {
        let mut stream = TcpStream::connect(place).unwrap();
        write!(stream, "GET /{path} HTTP/1.1\r\nHost: {place}\r\nCookie: {cookie}\r\n\r\n").unwrap();
        stream
    };
    let mut reply = String::new();
    asked(query, "").read_to_string(&mut reply).unwrap();
    let cookie = reply.lines().find_map(|line| line.strip_prefix("Set-Cookie: ")).unwrap();
    let cookie = cookie.split(';').next().unwrap();
    let _deaf = asked("large.png", cookie);
    let said = heard.recv_timeout(Duration::from_secs(60)).expect("the server gives the connection up");
    assert!(said.starts_with("warning: a connection of the page ended: "), "{said}");
}
