//! Instructions of a kernel, counted by callgrind of valgrind.

use std::ffi::OsStr;
use std::hint::{self, black_box};
use std::io;
use std::path::{Path, PathBuf};
use std::process::{self, Command, Stdio};
use std::{env, fs};

/// The variable by which [`instructions_of`] says that callgrind waits to be switched on.
const WAITS: &str = "LUNOID_CALLGRIND_WAITS";

/// Exit status of a program that could not switch callgrind on.
const NOT_SWITCHED: i32 = 76;

/// Runs `work` once, and has its instructions counted where [`instructions_of`] started this program.
pub fn counted(work: &mut dyn FnMut()) {
    if env::var_os(WAITS).is_some() && !switched_on() {
        process::exit(NOT_SWITCHED);
    }
    counted_alone(work);
}

/// Instructions are counted within this function alone: callgrind knows it by its name, so it is never part of another.
#[inline(never)]
fn counted_alone(work: &mut dyn FnMut()) {
    work();
    // Without anything after it the call would be a jump, and callgrind would not see the return.
    black_box(());
}

/// Has callgrind follow this program from now on. Until then it runs more than twice as fast.
fn switched_on() -> bool {
    let pid = format!("--pid={}", process::id());
    let mut vgdb = Command::new("vgdb");
    vgdb.args([&pid, "--max-invoke-ms=0", "--cmd-time-out=10", "instrumentation", "on"]);
    let Ok(mut asked) = vgdb.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null()).spawn() else {
        return false;
    };
    // Valgrind hears it while the program runs, and not while it waits.
    loop {
        match asked.try_wait() {
            Ok(None) => hint::spin_loop(),
            Ok(Some(status)) => return status.success(),
            Err(_) => return false,
        }
    }
}

/// Why instructions could not be counted.
#[derive(Debug, thiserror::Error)]
pub enum CountError {
    /// No valgrind on this system.
    #[error("valgrind: no such program; install it (Debian: valgrind), it counts the instructions")]
    NoValgrind,
    /// The program has no function of the name [`counted`].
    #[error(
        "{kernel}: the program has no symbols, by which valgrind finds what is counted; build it with `--profile counted`"
    )]
    NoSymbols {
        /// Name of the kernel or of other work.
        kernel: String,
    },
    /// It could not be started or ended badly.
    #[error("valgrind: {kernel}: {reason}")]
    Failed {
        /// Name of the kernel or of other work.
        kernel: String,
        /// What went wrong, in words.
        reason: String,
    },
}

impl CountError {
    /// Whether nothing is wrong with the program, and it cannot be counted here or as it was built.
    pub fn is_of_place(&self) -> bool {
        matches!(self, Self::NoValgrind | Self::NoSymbols { .. })
    }
}

/// What was counted of a kernel.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Count {
    /// Number of instructions within [`counted`].
    pub instructions: u64,
    /// What the kernel wrote to its output.
    pub told: String,
}

/// Instructions that `program` takes within [`counted`], given `arguments` by which it does the work `name`. The same build gives the same
/// number again; only what goes by addresses or by random keys may vary.
///
/// # Errors
/// If there is no valgrind, the program has no symbols, or it does not end well under valgrind.
pub fn instructions_of(
    program: &Path,
    name: &str,
    arguments: &[impl AsRef<OsStr>],
) -> Result<Count, CountError> {
    let failed = |reason: String| CountError::Failed { kernel: name.to_owned(), reason };
    let out =
        Remains(env::temp_dir().join(format!("callgrind-{}-{}", process::id(), name.replace('/', "-"))));
    let run = |waits: bool| {
        let mut valgrind = Command::new("valgrind");
        valgrind.args(["--tool=callgrind", "--quiet", "--toggle-collect=*benchmarks*counted_alone*"]);
        valgrind.arg(format!("--callgrind-out-file={}", out.0.display()));
        if waits {
            valgrind.arg("--instr-atstart=no").env(WAITS, "1");
        }
        valgrind.arg(program).args(arguments).output().map_err(|error| match error.kind() {
            io::ErrorKind::NotFound => CountError::NoValgrind,
            _ => failed(error.to_string()),
        })
    };
    let mut ended = run(true)?;
    if ended.status.code() == Some(NOT_SWITCHED) {
        ended = run(false)?;
    }
    if !ended.status.success() {
        return Err(failed(format!("{}\n{}", ended.status, String::from_utf8_lossy(&ended.stderr))));
    }
    let written = fs::read_to_string(&out.0).map_err(|error| failed(error.to_string()))?;
    let total = written.lines().find_map(|line| line.strip_prefix("totals:")?.trim().parse().ok());
    let no_symbols = || CountError::NoSymbols { kernel: name.to_owned() };
    let instructions = total.filter(|&total| total > 0).ok_or_else(no_symbols)?;
    Ok(Count { instructions, told: String::from_utf8_lossy(&ended.stdout).trim().to_owned() })
}

/// A file that goes when it is no longer needed.
struct Remains(PathBuf);

impl Drop for Remains {
    fn drop(&mut self) {
        let _ = fs::remove_file(&self.0);
    }
}
