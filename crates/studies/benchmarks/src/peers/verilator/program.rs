//! The verilated control plane as a process: compiled, fed and asked.

use std::fs;

use tempfile::TempDir;

use super::{Stimuli, Work};
use crate::peers::process::{Process, run_tool, skipped};

/// Sources of the control plane: circuit and what runs it.
const SOURCES: [&str; 2] = [
    concat!(env!("CARGO_MANIFEST_DIR"), "/peers/control_plane.sv"),
    concat!(env!("CARGO_MANIFEST_DIR"), "/peers/control_plane.cpp"),
];
/// Name of the program in its folder.
const PROGRAM: &str = "control_plane";
/// Options of Verilator: the fastest ones, on one thread.
const OPTIONS: [&str; 17] = [
    "--cc",
    "--exe",
    "--build",
    "-O3",
    "--x-assign",
    "fast",
    "--x-initial",
    "fast",
    "--noassert",
    "-CFLAGS",
    "-O3 -march=native",
    "--top-module",
    "control_plane",
    "--Mdir",
    ".",
    "-o",
    PROGRAM,
];

/// The control plane of a frame, compiled for this processor into a folder that is removed with it.
#[derive(Debug)]
pub struct Program {
    folder: TempDir,
}

impl Program {
    /// Compiles it for the figures of `stimuli`. The inner error is a line that names the package that is missing here.
    ///
    /// # Errors
    /// If it cannot be compiled although all packages are here.
    pub fn compile(stimuli: &Stimuli) -> Result<Result<Self, String>, String> {
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        for (tool, package) in [("verilator", "verilator"), ("g++", "g++"), ("make", "make")] {
            if run_tool(tool, &["--version"], folder.path())?.is_none() {
                return Ok(Err(skipped(tool, package)));
            }
        }
        let [pointer, access, strobe] = stimuli.loader;
        let parameters = [
            format!("-GPHASES={}", stimuli.phases),
            format!("-GTICKS={}", stimuli.ticks),
            format!("-GPOINTER={pointer}"),
            format!("-GACCESS={access}"),
            format!("-GSTROBE={strobe}"),
        ];
        let arguments: Vec<&str> =
            OPTIONS.into_iter().chain(parameters.iter().map(String::as_str)).chain(SOURCES).collect();
        match run_tool("verilator", &arguments, folder.path())? {
            Some(ended) if ended.status.success() => Ok(Ok(Self { folder })),
            ended => {
                let said = ended.map(|ended| String::from_utf8_lossy(&ended.stderr).into_owned());
                Err(format!("verilator: {}", said.unwrap_or_default()))
            }
        }
    }

    /// Starts it over the sweeps of a frame.
    ///
    /// # Errors
    /// If it cannot be fed or ends early.
    pub fn start(&self, stimuli: &Stimuli) -> Result<Verilated, String> {
        let write = |name: &str, bytes: &[u8]| {
            fs::write(self.folder.path().join(name), bytes).map_err(|error| format!("{name}: {error}"))
        };
        write("ranges.hex", stimuli.ranges.as_bytes())?;
        write("stimuli", &stimuli.sweeps)?;
        let (process, said) = Process::start(PROGRAM, self.folder.path(), "stimuli")?;
        match said == "ready" {
            true => Ok(Verilated { process }),
            false => Err(process.unexpected("ready", &said)),
        }
    }
}

/// The control plane, waiting for frames.
#[derive(Debug)]
pub struct Verilated {
    process: Process,
}

impl Verilated {
    /// Runs a frame: its time (s) and what it did.
    ///
    /// # Errors
    /// If it does not answer so.
    pub fn frame(&mut self) -> Result<(f64, Work), String> {
        let said = self.process.ask("frame")?;
        let words: Vec<&str> = said.split(' ').collect();
        let found = || Some((words[0].parse().ok()?, Work::read(&words[1..])?));
        found().ok_or_else(|| self.process.unexpected("seconds and eight counts", &said))
    }
}
