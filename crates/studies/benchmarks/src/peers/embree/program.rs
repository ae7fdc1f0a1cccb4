//! The ray tracer as a process: compiled, fed and asked.

use std::fs;
use std::io::{self, BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

use tempfile::TempDir;

use super::{EyeMesh, Sight, scene_file};

/// Source of the ray tracer.
const SOURCE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/peers/embree.cpp");

/// The ray tracer, compiled for this processor into a folder that is removed with it.
#[derive(Debug)]
pub struct Program {
    folder: TempDir,
}

impl Program {
    /// Compiles it. The inner error is a package that is missing here, and how to install it.
    ///
    /// # Errors
    /// If it cannot be compiled although all packages are here.
    pub fn compile() -> Result<Result<Self, String>, String> {
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        let missing = |what: &str, package: &str| {
            Ok(Err(format!("skipped: {what} is not here; install the package {package}")))
        };
        let compiler = |arguments: &[&str]| Command::new("g++").args(arguments).current_dir(&folder).output();
        let header = "#include <embree3/rtcore.h>\n";
        fs::write(folder.path().join("probe.cpp"), header).map_err(|error| error.to_string())?;
        match compiler(&["-fsyntax-only", "probe.cpp"]) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => return missing("g++", "g++"),
            Err(error) => return Err(format!("g++: {error}")),
            Ok(ended) if !ended.status.success() => {
                return missing("Embree 3", "libembree-dev (3.13 is tried)");
            }
            Ok(_) => {}
        }
        let options =
            ["-std=c++17", "-O3", "-march=native", SOURCE, "-o", "embree", "-lembree3", "-pthread"];
        let ended = compiler(&options).map_err(|error| format!("g++: {error}"))?;
        match ended.status.success() {
            true => Ok(Ok(Self { folder })),
            false => Err(format!("{SOURCE}: {}", String::from_utf8_lossy(&ended.stderr))),
        }
    }

    /// Starts it over a mesh. It divides space before this returns.
    ///
    /// # Errors
    /// If it cannot be fed or ends early.
    pub fn start(&self, mesh: &EyeMesh, sight: &Sight) -> Result<Embree, String> {
        let told = |error: io::Error| format!("embree: {error}");
        let scene = self.folder.path().join("scene");
        fs::write(&scene, scene_file(mesh, sight)).map_err(told)?;
        let mut command = Command::new(self.folder.path().join("embree"));
        let mut child =
            command.arg(&scene).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().map_err(told)?;
        let (Some(input), Some(output)) = (child.stdin.take(), child.stdout.take()) else {
            return Err("embree: no pipes".to_owned());
        };
        let mut embree =
            Embree { child, input: Some(input), output: BufReader::new(output), built: 0.0, size: sight.size };
        let said = embree.answer()?;
        embree.built = said
            .strip_prefix("built ")
            .and_then(|seconds| seconds.parse().ok())
            .ok_or_else(|| unexpected("built SECONDS", &said))?;
        Ok(embree)
    }
}

/// The ray tracer over one mesh, waiting for questions.
#[derive(Debug)]
pub struct Embree {
    child: Child,
    input: Option<ChildStdin>,
    output: BufReader<ChildStdout>,
    built: f64,
    size: [u32; 2],
}

impl Embree {
    /// How long it took to divide space (s).
    pub fn built(&self) -> f64 {
        self.built
    }

    /// Traces a frame by packets of 16, 8 or 1 rays under a sun of this direction (north, east, up): its time (s).
    ///
    /// # Errors
    /// If it does not answer so.
    pub fn trace(&mut self, packet: u32, [north, east, up]: [f64; 3]) -> Result<f64, String> {
        let said = self.ask(&format!("trace {packet} {north} {east} {up}"))?;
        said.parse().map_err(|_| unexpected("seconds", &said))
    }

    /// Reflectivity of the last frame, line by line from the top left.
    ///
    /// # Errors
    /// If it does not write as many numbers as the picture has pixels.
    pub fn picture(&mut self) -> Result<Vec<f32>, String> {
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        let path = folder.path().join("picture");
        let said = self.ask(&format!("picture {}", path.display()))?;
        if said != "written" {
            return Err(unexpected("written", &said));
        }
        read_picture(&path, self.size)
    }

    fn ask(&mut self, question: &str) -> Result<String, String> {
        let input = self.input.as_mut().ok_or("embree has ended")?;
        writeln!(input, "{question}").map_err(|error| format!("embree: {error}"))?;
        self.answer()
    }

    fn answer(&mut self) -> Result<String, String> {
        let mut line = String::new();
        match self.output.read_line(&mut line) {
            Err(error) => Err(format!("embree: {error}")),
            Ok(0) => Err("embree ended without an answer".to_owned()),
            Ok(_) => Ok(line.trim_end().to_owned()),
        }
    }
}

impl Drop for Embree {
    /// Ends its input and waits until it has ended.
    fn drop(&mut self) {
        drop(self.input.take());
        let _ = self.child.wait();
    }
}

fn unexpected(expected: &str, found: &str) -> String {
    format!("embree said '{found}': expected {expected}")
}

/// The floats of a file, little-endian, as many as a picture of this size has pixels.
fn read_picture(path: &Path, [columns, lines]: [u32; 2]) -> Result<Vec<f32>, String> {
    let bytes = fs::read(path).map_err(|error| format!("{}: {error}", path.display()))?;
    let expected = 4 * columns as usize * lines as usize;
    if bytes.len() != expected {
        return Err(format!("{}: {} bytes, expected {expected}", path.display(), bytes.len()));
    }
    let floats = bytes.chunks_exact(4).map(|float| f32::from_le_bytes([float[0], float[1], float[2], float[3]]));
    Ok(floats.collect())
}
