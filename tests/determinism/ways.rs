//! The ways in which the command can draw the same frames.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

use lunoid_tests::breaks::root;
use serde_json::Value;

use crate::Case;
use crate::builds::Build;

/// Frames of every case.
pub const FRAMES: usize = 5;

/// Hash of the pixels of every frame.
pub type Frames = BTreeMap<u64, String>;

/// A way of drawing the frames.
#[derive(Debug, Clone, Copy)]
pub enum Way {
    /// Drawn by so many threads.
    Threads(u8),
    /// Sweeps of two frames are probed.
    Probed,
    /// Every frame by a process of its own, into a folder of its own.
    Alone,
    /// The last frame first: a run that is asked for one frame more before those that it has.
    Backward,
    /// Killed once there is a frame, and resumed.
    Killed,
}

/// All ways that must give the same pixels.
pub const WAYS: [Way; 8] = [
    Way::Threads(1),
    Way::Threads(2),
    Way::Threads(3),
    Way::Threads(8),
    Way::Probed,
    Way::Alone,
    Way::Backward,
    Way::Killed,
];

/// A case drawn by a build, into runs in `folder`, with boundaries of shadow kept in `shadows`.
pub struct Drawing<'a> {
    pub build: &'a Build,
    pub case: &'a Case,
    pub folder: &'a Path,
    pub shadows: &'a Path,
}

impl Drawing<'_> {
    /// The frames, drawn that way; `killed` is told whether a kill came between the first frame and the last.
    pub fn draw(&self, way: Way, mut killed: impl FnMut(bool)) -> Result<Frames, String> {
        let whole = format!("0..{FRAMES}");
        match way {
            Way::Threads(count) => self.replay("run", &["--frames", &whole, "--jobs", &count.to_string()]),
            Way::Probed => {
                self.replay("run", &["--frames", &whole, "--probe", "0:3..12", "--probe", "4:20:tg.*"])
            }
            Way::Alone => {
                let alone = |frame: usize| {
                    let number = frame.to_string();
                    self.replay(&number, &["--frames", &number])
                };
                Ok((0..FRAMES).map(alone).collect::<Result<Vec<_>, _>>()?.into_iter().flatten().collect())
            }
            Way::Backward => {
                for first in (1..FRAMES).rev() {
                    self.replay("run", &["--frames", &format!("{first}..{FRAMES}")])?;
                }
                self.replay("run", &["--frames", &whole])
            }
            Way::Killed => {
                let options = ["--frames", &whole, "--jobs", "1"];
                killed(self.kill("run", &options)?);
                self.replay("run", &options)
            }
        }
    }

    /// The frames that the run `out` then has.
    fn replay(&self, out: &str, options: &[&str]) -> Result<Frames, String> {
        let mut command = self.command(out, options);
        let ended = command.output().map_err(|error| error.to_string())?;
        if !ended.status.success() {
            return Err(format!("{command:?}: {}", String::from_utf8_lossy(&ended.stderr)));
        }
        let path = self.folder.join(out).join("run.json");
        let text = fs::read_to_string(&path).map_err(|error| error.to_string())?;
        let record: Value = serde_json::from_str(&text).map_err(|error| error.to_string())?;
        let hashes =
            |frame: &Value| Some((frame["frame"].as_u64()?, frame["pixels_blake3"].as_str()?.into()));
        let frames = record["frames"].as_array().and_then(|frames| frames.iter().map(hashes).collect());
        frames.ok_or_else(|| format!("{}: expected frames with their hashes", path.display()))
    }

    /// Kills the run `out` once it has a frame; whether it had not all of them then.
    fn kill(&self, out: &str, options: &[&str]) -> Result<bool, String> {
        let mut child = self.command(out, options).stdout(Stdio::null()).stderr(Stdio::null()).spawn();
        let child = child.as_mut().map_err(|error| error.to_string())?;
        let frames = self.folder.join(out).join("frames");
        let pictures = || fs::read_dir(&frames).into_iter().flatten().count();
        let mut runs = || child.try_wait().map(|ended| ended.is_none()).map_err(|error| error.to_string());
        while runs()? && pictures() == 0 {
            sleep(Duration::from_micros(200));
        }
        child.kill().and_then(|()| child.wait()).map_err(|error| error.to_string())?;
        Ok((1..FRAMES).contains(&pictures()))
    }

    fn command(&self, out: &str, options: &[&str]) -> Command {
        let mut command = Command::new(&self.build.program);
        let scenario = format!("scenarios/{}.toml", self.case.scenario);
        // No multiple of eight, so that the last group of sweeps is not full.
        command.args(["replay", &scenario, "-m", self.case.machine, "--sweeps", "61", "--samples", "200"]);
        command.args(self.case.options).args(options).arg("--out").arg(self.folder.join(out));
        // Sixteen bits: what differs in signals is seen that eight would round away.
        command.args(["--depth", "16"]);
        command
            .arg("--shadow-cache")
            .arg(self.shadows)
            .arg("--no-progress")
            .current_dir(root())
            .env_remove("LUNOID_THREADS");
        command
    }
}
