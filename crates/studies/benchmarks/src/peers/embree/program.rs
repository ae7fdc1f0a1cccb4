//! The ray tracer as a process: compiled, fed and asked.

use std::fs;
use std::path::Path;

use tempfile::TempDir;

use super::{EyeMesh, Sight, scene_file};
use crate::peers::process::{Process, run_tool, skipped};

/// Source of the ray tracer.
const SOURCE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/peers/embree.cpp");
/// Name of the program in its folder.
const PROGRAM: &str = "embree";
/// Name of its scene there.
const SCENE: &str = "scene";

/// The ray tracer, compiled for this processor into a folder that is removed with it.
#[derive(Debug)]
pub struct Program {
    folder: TempDir,
}

impl Program {
    /// Compiles it. The inner error is a line that names the package that is missing here.
    ///
    /// # Errors
    /// If it cannot be compiled although all packages are here.
    pub fn compile() -> Result<Result<Self, String>, String> {
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        let header = "#include <embree3/rtcore.h>\n";
        fs::write(folder.path().join("probe.cpp"), header).map_err(|error| error.to_string())?;
        match run_tool("g++", &["-fsyntax-only", "probe.cpp"], folder.path())? {
            None => return Ok(Err(skipped("g++", "g++"))),
            Some(ended) if !ended.status.success() => {
                return Ok(Err(skipped("Embree 3", "libembree-dev (version 3; 3.13 is tried)")));
            }
            Some(_) => {}
        }
        let options = ["-std=c++17", "-O3", "-march=native", SOURCE, "-o", PROGRAM, "-lembree3", "-pthread"];
        match run_tool("g++", &options, folder.path())? {
            Some(ended) if ended.status.success() => Ok(Ok(Self { folder })),
            ended => {
                let said = ended.map(|ended| String::from_utf8_lossy(&ended.stderr).into_owned());
                Err(format!("{SOURCE}: {}", said.unwrap_or_default()))
            }
        }
    }

    /// Starts it over a mesh. It divides space before this returns.
    ///
    /// # Errors
    /// If it cannot be fed or ends early.
    pub fn start(&self, mesh: &EyeMesh, sight: &Sight) -> Result<Embree, String> {
        let scene = self.folder.path().join(SCENE);
        fs::write(&scene, scene_file(mesh, sight))
            .map_err(|error| format!("{}: {error}", scene.display()))?;
        let (process, said) = Process::start(PROGRAM, self.folder.path(), SCENE)?;
        let built = said.strip_prefix("built ").and_then(|seconds| seconds.parse().ok());
        let built = built.ok_or_else(|| process.unexpected("built SECONDS", &said))?;
        Ok(Embree { process, built, size: sight.size })
    }
}

/// The ray tracer over one mesh, waiting for questions.
#[derive(Debug)]
pub struct Embree {
    process: Process,
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
        self.seconds(&format!("trace {packet} {north} {east} {up}"))
    }

    /// Traces a frame of a mesh whose vertices have light of their own, by packets of 16, 8 or 1 rays: its time (s).
    ///
    /// # Errors
    /// If it does not answer so.
    pub fn show(&mut self, packet: u32) -> Result<f64, String> {
        self.seconds(&format!("show {packet}"))
    }

    /// Gives it a texture of `size` (columns, lines): light line by line from the top. [`Self::drape`] looks it up.
    ///
    /// # Errors
    /// If it cannot be handed over.
    pub fn texture(&mut self, [columns, lines]: [usize; 2], lights: &[f32]) -> Result<(), String> {
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        let path = folder.path().join("texture");
        let bytes: Vec<u8> = lights.iter().flat_map(|light| light.to_le_bytes()).collect();
        fs::write(&path, bytes).map_err(|error| format!("{}: {error}", path.display()))?;
        let said = self.process.ask(&format!("texture {columns} {lines} {}", path.display()))?;
        if said == "read" { Ok(()) } else { Err(self.process.unexpected("read", &said)) }
    }

    /// Traces a frame of a mesh whose vertices have a pixel I, J of the texture in place of a normal, by packets of 16, 8 or 1 rays: its
    /// time (s).
    ///
    /// # Errors
    /// If it does not answer so.
    pub fn drape(&mut self, packet: u32) -> Result<f64, String> {
        self.seconds(&format!("drape {packet}"))
    }

    /// Traces one ray from each vertex to the sun of this direction (north, east, up), from `lift` (m) on, by packets of 16, 8 or 1 rays: the
    /// time (s). The picture must have a pixel for each vertex; it is 1 where nothing is in the way, else 0.
    ///
    /// # Errors
    /// If it does not answer so.
    pub fn light(&mut self, packet: u32, [north, east, up]: [f64; 3], lift: f64) -> Result<f64, String> {
        self.seconds(&format!("light {packet} {north} {east} {up} {lift}"))
    }

    /// Divides space anew, of quality `low`, `medium` or `high`: the time (s).
    ///
    /// # Errors
    /// If it does not answer so.
    pub fn divide(&mut self, quality: &str) -> Result<f64, String> {
        self.seconds(&format!("divide {quality}"))
    }

    fn seconds(&mut self, question: &str) -> Result<f64, String> {
        let said = self.process.ask(question)?;
        said.parse().map_err(|_| self.process.unexpected("seconds", &said))
    }

    /// Reflectivity of the last frame, line by line from the top left.
    ///
    /// # Errors
    /// If it does not write as many numbers as the picture has pixels.
    pub fn picture(&mut self) -> Result<Vec<f32>, String> {
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        let path = folder.path().join("picture");
        let said = self.process.ask(&format!("picture {}", path.display()))?;
        if said != "written" {
            return Err(self.process.unexpected("written", &said));
        }
        read_picture(&path, self.size)
    }
}

/// The floats of a file, little-endian, as many as a picture of this size has pixels.
fn read_picture(path: &Path, [columns, lines]: [u32; 2]) -> Result<Vec<f32>, String> {
    let bytes = fs::read(path).map_err(|error| format!("{}: {error}", path.display()))?;
    let (floats, rest) = bytes.as_chunks::<4>();
    let expected = columns as usize * lines as usize;
    if floats.len() != expected || !rest.is_empty() {
        return Err(format!("{}: {} bytes, expected {}", path.display(), bytes.len(), 4 * expected));
    }
    Ok(floats.iter().map(|&float| f32::from_le_bytes(float)).collect())
}

#[cfg(test)]
mod tests {
    use super::read_picture;

    #[test]
    fn a_picture_has_a_float_for_each_pixel() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("picture");
        let bytes: Vec<u8> = [0.25f32, 1.0].iter().flat_map(|part| part.to_le_bytes()).collect();
        std::fs::write(&path, &bytes).unwrap();
        assert_eq!(read_picture(&path, [2, 1]), Ok(vec![0.25, 1.0]));
        let error = read_picture(&path, [3, 1]).unwrap_err();
        assert!(error.ends_with("8 bytes, expected 12"), "{error}");
    }
}
