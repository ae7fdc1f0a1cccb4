//! The cost of a loop through TCP: the time of a client's `look` over that of the same picture drawn in the program, in pairs.
//! It prints a line of JSON for the picture alone, and one for the picture with four planes. `.ci/loop` puts both into its record.
//!
//! ```sh
//! cargo run --release -p loop-server --example ratio -- scenarios/full-drive.toml 30
//! ```

use std::io::{BufReader, BufWriter};
use std::net::{IpAddr, Ipv4Addr, TcpStream};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::thread;
use std::time::Instant;

use drive::{Drive, DriveError, EyePose, Wishes};
use loop_protocol::{Home, Message, Opening, Session};
use loop_server::{TcpServer, Token};
use serde_json::{Value, json};

/// Planes of the second comparison, beside the picture.
const PLANES: [&str; 4] = ["range", "label", "height", "distance"];

type Said<T> = Result<T, Box<dyn std::error::Error>>;

/// A scenario as it is on the disk.
#[derive(Clone)]
struct OnDisk(PathBuf);

impl Home for OnDisk {
    fn open(&mut self, asked: &Opening) -> Result<Drive, DriveError> {
        Drive::open(&self.0, &asked.over(&Wishes::default()), 0)
    }
}

/// A client on TCP.
struct Client<'a> {
    from: BufReader<&'a TcpStream>,
    to: BufWriter<&'a TcpStream>,
}

impl<'a> Client<'a> {
    fn of(stream: &'a TcpStream) -> Self {
        Self { from: BufReader::new(stream), to: BufWriter::new(stream) }
    }

    fn ask(&mut self, header: Value) -> Said<Message> {
        Message::new(header).write(&mut self.to)?;
        Ok(Message::read(&mut self.from)?.ok_or("the server has ended")?)
    }
}

fn main() -> Said<()> {
    let mut words = std::env::args().skip(1);
    let scenario = PathBuf::from(words.next().ok_or("expected: ratio SCENARIO FRAMES")?);
    let frames: u64 = words.next().ok_or("expected: ratio SCENARIO FRAMES")?.parse()?;
    let drive = Arc::new(Drive::open(&scenario, &Wishes::default(), 0)?);
    let stream = served(&scenario, &drive)?;
    let mut client = Client::of(&stream);
    for planes in [&[][..], &PLANES] {
        let mut ratios = Vec::new();
        for frame in 0..frames.min(drive.frames()) {
            let pose = drive.pose(frame)?;
            let [own, through] = match frame % 2 {
                0 => [native(&drive, frame, &pose, planes)?, looked(&mut client, frame, &pose, planes)?],
                _ => {
                    let through = looked(&mut client, frame, &pose, planes)?;
                    [native(&drive, frame, &pose, planes)?, through]
                }
            };
            ratios.push(through / own);
        }
        ratios.sort_by(f64::total_cmp);
        let quantile = |share: f64| ratios[(share * (ratios.len() - 1) as f64) as usize];
        let middle_half = [quantile(0.25), quantile(0.75)];
        let row = json!({
            "scenario": scenario, "planes": planes, "pairs": ratios.len(), "ratio": quantile(0.5), "middle_half": middle_half,
        });
        println!("{row}");
    }
    Ok(())
}

/// A server of `drive` on a thread, and a client that it has admitted.
fn served(scenario: &Path, drive: &Arc<Drive>) -> Said<TcpStream> {
    let token = Token::random()?;
    let server = TcpServer::bind(IpAddr::V4(Ipv4Addr::LOCALHOST), 0, token.clone())?;
    let stream = TcpStream::connect(server.address())?;
    stream.set_nodelay(true)?;
    let (home, drive) = (OnDisk(scenario.to_owned()), Arc::clone(drive));
    thread::spawn(move || {
        server.serve(|| Session::with(home.clone(), Arc::clone(&drive)), |said| eprintln!("{said}"));
    });
    Client::of(&stream).ask(json!({ "id": 0, "do": "hello", "token": token.word() }))?;
    Ok(stream)
}

/// Seconds of a picture drawn in the program.
fn native(drive: &Drive, frame: u64, pose: &EyePose, planes: &[&str]) -> Said<f64> {
    let begun = Instant::now();
    let seen = drive.look(frame, pose)?;
    if !planes.is_empty() {
        drive.from_pose(frame, pose)?.truth(&planes.join(","))?;
    }
    let seconds = begun.elapsed().as_secs_f64();
    if seen.has_bytes() { Ok(seconds) } else { Err("a picture without bytes".into()) }
}

/// Seconds of the same picture through the socket.
fn looked(client: &mut Client<'_>, frame: u64, pose: &EyePose, planes: &[&str]) -> Said<f64> {
    let [x, y, z] = pose.eye_m;
    let pose = json!({
        "x_m": x, "y_m": y, "z_m": z, "heading_deg": pose.heading_deg, "pitch_deg": pose.pitch_deg,
        "roll_deg": pose.roll_deg, "yoke_deg": pose.yoke_deg, "time_s": pose.time_s,
    });
    let planes: Vec<&str> = ["picture"].into_iter().chain(planes.iter().copied()).collect();
    let begun = Instant::now();
    let reply =
        client.ask(json!({ "id": 1, "do": "look", "frame": frame, "pose": pose, "planes": planes }))?;
    let seconds = begun.elapsed().as_secs_f64();
    if reply.planes.len() == planes.len() {
        Ok(seconds)
    } else {
        Err(Value::from(reply.header).to_string().into())
    }
}
