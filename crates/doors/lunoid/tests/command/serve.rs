//! `lunoid serve`: clients in other languages, what was driven replayed, and clients that send rubbish.

use std::fs;
use std::io::{Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};

use tempfile::tempdir;

const SMALL: [&str; 8] = [
    "--set",
    "scenario.raster.columns=60",
    "--set",
    "scenario.raster.lines=40",
    "--sweeps",
    "60",
    "--samples",
    "120",
];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../..")
}

fn lunoid() -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_lunoid"));
    command.current_dir(root());
    command
}

/// Whether a program is there; says what is skipped where it is not.
fn has(program: &str) -> bool {
    let found = Command::new(program).arg("--version").output().is_ok_and(|output| output.status.success());
    if !found {
        eprintln!("SKIPPED: {program} is missing; a client that needs it is not run");
    }
    found
}

/// The hashes of the frames of a run.
fn hashes(run: &Path) -> Vec<String> {
    let record: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(run.join("run.json")).unwrap()).unwrap();
    let frames = record["frames"].as_array().expect("frames of a run");
    frames.iter().map(|frame| frame["pixels_blake3"].as_str().expect("a hash").to_owned()).collect()
}

/// The hashes that a client has printed, one a line before other words.
fn printed(client: &mut Command) -> Vec<String> {
    let output = client.output().unwrap();
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(output.status.success(), "{said}{}", String::from_utf8_lossy(&output.stderr));
    let words = said.lines().filter_map(|line| line.split(' ').next());
    let is_hash = |word: &&str| word.len() == 64 && word.bytes().all(|byte| byte.is_ascii_hexdigit());
    words.filter(is_hash).map(str::to_owned).collect()
}

/// What `lunoid replay` draws of what was driven.
fn replayed(driven: &Path, machine: &str) -> Vec<String> {
    let out = driven.with_extension("replayed");
    let mut replay = lunoid();
    replay.arg("replay").arg(driven.join("drive/scenario.toml")).args(["--machine", machine]).args(SMALL);
    let output = replay.arg("--out").arg(&out).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    hashes(&out)
}

/// The client `words`, whose `lunoid serve` of its own records into `record`.
fn on_a_pipe(words: &[&str], machine: &str, record: &Path) -> Vec<String> {
    let mut client = Command::new(words[0]);
    client.current_dir(root()).args(&words[1..]).args(["6", env!("CARGO_BIN_EXE_lunoid"), "serve"]);
    client.args(["scenarios/first-light.toml", "--machine", machine]).args(SMALL).arg("--record").arg(record);
    printed(&mut client)
}

#[test]
fn clients_on_a_pipe_drive_and_the_replay_is_equal() {
    let folder = tempdir().unwrap();
    for words in
        [["python3", "-B", "docs/clients/drive.py"], ["octave-cli", "--norc", "docs/clients/drive.m"]]
    {
        if !has(words[0]) {
            continue;
        }
        for machine in ["ideal", "pra-nominal"] {
            let record = folder.path().join(format!("{}-{machine}", words[0]));
            let seen = on_a_pipe(&words, machine, &record);
            assert_eq!(seen.len(), 6, "{words:?}");
            assert_eq!(replayed(&record, machine), seen, "{words:?}, {machine}");
            // Another drive into the same folder has a name of its own.
            assert_eq!(on_a_pipe(&words, machine, &record), seen);
            assert!(record.join("drive-2/scenario.toml").is_file() && !record.join("drive-3").exists());
        }
    }
}

#[test]
fn a_client_in_c_drives_over_tcp_and_the_replay_is_equal() {
    if !has("cc") {
        return;
    }
    let folder = tempdir().unwrap();
    let client = folder.path().join("drive");
    let compiled = Command::new("cc")
        .current_dir(root())
        .args(["-Wall", "-Wextra", "-Werror", "-o"])
        .arg(&client)
        .arg("docs/clients/drive.c")
        .output()
        .unwrap();
    assert!(compiled.status.success(), "{}", String::from_utf8_lossy(&compiled.stderr));
    let record = folder.path().join("driven");
    let (mut child, address) = on_tcp(&["--record", record.to_str().unwrap()]);
    let port = address.rsplit(':').next().unwrap();
    let seen = printed(Command::new(&client).args(["6", port]).env("LUNOID_TOKEN", WORD));
    child.kill().unwrap();
    child.wait().unwrap();
    assert_eq!(seen.len(), 6);
    assert_eq!(replayed(&record, "ideal"), seen);
}

fn serving(arguments: &[&str]) -> Child {
    let mut command = lunoid();
    command.args(["serve", "scenarios/first-light.toml"]).args(SMALL).args(arguments);
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap()
}

/// The bytes of a request without planes.
fn request(header: &str) -> Vec<u8> {
    let mut bytes = b"lunoid.1".to_vec();
    bytes.extend((header.len() as u64).to_le_bytes());
    bytes.extend(0_u64.to_le_bytes());
    bytes.extend(header.as_bytes());
    bytes
}

#[test]
fn the_same_requests_have_the_same_bytes_and_rubbish_is_one_error() {
    let asked = [
        r#"{"id":1,"do":"hello"}"#,
        r#"{"id":2,"do":"frame","frame":3}"#,
        r#"{"id":3,"do":"fly"}"#,
        r#"{"id":4,"do":"open","scenario":"scenarios/profile.toml"}"#,
    ];
    let asked: Vec<u8> = asked.iter().flat_map(|header| request(header)).collect();
    let answered = |more: &[u8]| {
        let mut child = serving(&[]);
        child.stdin.take().unwrap().write_all(&[&asked[..], more].concat()).unwrap();
        child.wait_with_output().unwrap()
    };
    let [first, second] = [answered(b""), answered(b"")];
    assert!(first.status.success(), "{}", String::from_utf8_lossy(&first.stderr));
    assert!(first.stdout == second.stdout && first.stdout.len() > 60 * 40);
    let said = String::from_utf8_lossy(&first.stdout).into_owned();
    assert!(
        said.contains("no request `fly`") && said.contains("another scenario is not opened here"),
        "{said}"
    );
    let rubbish = answered(b"GET / HTTP/1.1\r\nHost: here\r\n\r\n");
    assert_eq!(rubbish.status.code(), Some(3));
    let last = String::from_utf8_lossy(&rubbish.stdout[first.stdout.len()..]).into_owned();
    assert!(last.contains(r#""error""#), "{last}");
    assert!(rubbish.stdout.starts_with(&first.stdout), "what was asked before is answered");
}

/// A client names what ships and what the command line offers; of other files it does not even hear whether they are there.
#[test]
fn a_client_names_no_file_that_is_not_offered() {
    let folder = tempdir().unwrap();
    let file = |name: &str, text: &str| {
        let path = folder.path().join(name);
        fs::write(&path, text).unwrap();
        path.to_str().unwrap().to_owned()
    };
    let slow = file("slow.toml", "format = 1\n[loader]\naccess_ns = 900\n");
    let other = file("other.toml", "format = 1\n[loader]\naccess_ns = 800\n");
    let secret = file("secret.toml", "password = \"1234\"\n");
    let answers = |requests: &[String]| -> Vec<serde_json::Value> {
        let mut child = serving(&["--overlay", &slow, "--offer", &other]);
        let asked: Vec<u8> = requests.iter().flat_map(|header| request(header)).collect();
        child.stdin.take().unwrap().write_all(&asked).unwrap();
        let said = child.wait_with_output().unwrap().stdout;
        let mut rest = &said[..];
        let mut headers = Vec::new();
        while let Some((prefix, behind)) = rest.split_at_checked(24) {
            let length = u64::from_le_bytes(prefix[8..16].try_into().unwrap()) as usize;
            headers.push(serde_json::from_slice(&behind[..length]).unwrap());
            rest = &behind[length..];
        }
        headers
    };
    let set = |key: &str, value: &str| format!(r#"{{"id":1,"do":"set",{key}:{value}}}"#);
    let overlays = |name: &str| set(r#""overlays""#, &format!(r#"["{name}"]"#));
    let said = answers(&[
        overlays("tear"),
        overlays(&slow),
        overlays(&other),
        set(r#""machine""#, r#""pra-nominal""#),
        overlays(&secret),
        overlays("/no/such/file"),
        set(r#""machine""#, &format!("\"{secret}\"")),
        format!(r#"{{"id":1,"do":"open","machine":"{secret}","overlays":["{secret}"]}}"#),
    ]);
    assert_eq!(said.len(), 8);
    for allowed in &said[..4] {
        assert!(allowed["ok"].is_object(), "{allowed}");
    }
    for (refused, count) in said[4..].iter().zip([1, 1, 1, 2]) {
        let problems = refused["error"]["problems"].as_array().expect("it is refused");
        assert_eq!(problems.len(), count, "{refused}");
        for problem in problems {
            assert!(problem["title"].as_str().unwrap().contains("not offered here"), "{problem}");
            assert!(problem["expected"].as_str().unwrap().starts_with("one of "), "{problem}");
            assert!(problem["help"].as_str().unwrap().contains("--offer"), "{problem}");
        }
        assert!(!refused.to_string().contains("1234"));
    }
}

#[cfg(unix)]
#[test]
fn a_socket_serves_one_client_after_another() {
    use std::io::{BufRead, BufReader};
    use std::os::unix::net::UnixStream;

    let folder = tempdir().unwrap();
    let socket = folder.path().join("loop.sock");
    let mut child = serving(&["--socket", socket.to_str().unwrap()]);
    let mut told = String::new();
    BufReader::new(child.stderr.take().unwrap()).read_line(&mut told).unwrap();
    assert!(told.starts_with("listening on"), "{told}");
    let spoken = |bytes: &[u8]| {
        let mut stream = UnixStream::connect(&socket).unwrap();
        stream.write_all(bytes).unwrap();
        stream.shutdown(std::net::Shutdown::Write).unwrap();
        let mut reply = Vec::new();
        stream.read_to_end(&mut reply).unwrap();
        reply
    };
    let hello = request(r#"{"id":7,"do":"hello"}"#);
    let first = spoken(&hello);
    assert!(first.starts_with(b"lunoid.1"));
    assert!(String::from_utf8_lossy(&spoken(b"rubbish, and much more of it")).contains(r#""error""#));
    drop(UnixStream::connect(&socket).unwrap());
    assert!(spoken(&hello) == first, "the next client is served as the first one was");
    let taken = serving(&["--socket", socket.to_str().unwrap()]).wait_with_output().unwrap();
    let said = String::from_utf8_lossy(&taken.stderr).into_owned();
    assert!(taken.status.code() == Some(4) && said.contains("name another path"), "{said}");
    child.kill().unwrap();
    child.wait().unwrap();
}

/// The token of the tests.
const WORD: &str = "a-word-of-this-test";

/// A server on TCP, and where it listens.
fn on_tcp(arguments: &[&str]) -> (Child, String) {
    use std::io::{BufRead, BufReader};

    let mut child = serving(&[&["--tcp", "0", "--token", WORD], arguments].concat());
    let mut told = String::new();
    BufReader::new(child.stderr.take().unwrap()).read_line(&mut told).unwrap();
    let address = told.trim().strip_prefix("listening on ").expect(&told).to_owned();
    (child, address)
}

#[test]
fn tcp_serves_whoever_has_the_token() {
    use std::net::{Shutdown, TcpStream};

    let (mut child, address) = on_tcp(&[]);
    assert!(address.starts_with("127.0.0.1:"), "only this computer: {address}");
    let spoken = |header: &str| {
        let mut stream = TcpStream::connect(&address).unwrap();
        stream.write_all(&request(header)).unwrap();
        stream.shutdown(Shutdown::Write).unwrap();
        let mut reply = Vec::new();
        stream.read_to_end(&mut reply).unwrap();
        String::from_utf8_lossy(&reply).into_owned()
    };
    let hello = spoken(r#"{"id":7,"do":"hello","token":"a-word-of-this-test"}"#);
    assert!(hello.contains(r#""id":7"#) && hello.contains("lunoid.loop/1"), "{hello}");
    assert!(spoken(r#"{"id":7,"do":"hello"}"#).contains("a client without a token"));
    child.kill().unwrap();
    child.wait().unwrap();
    let short = serving(&["--tcp", "0", "--token", "short"]).wait_with_output().unwrap();
    let said = String::from_utf8_lossy(&short.stderr).into_owned();
    assert!(short.status.code() == Some(2) && said.contains("expected 16 to 1024"), "{said}");
    let both = serving(&["--tcp", "0", "--socket", "x"]).wait_with_output().unwrap();
    assert_eq!(both.status.code(), Some(2));
}
