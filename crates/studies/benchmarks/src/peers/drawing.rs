//! A program that draws a mesh by a library of other people: compiled, fed and asked.

use std::fs;
use std::path::Path;

use tempfile::TempDir;

use super::embree::{EyeMesh, Sight, scene_file};
use super::process::{Process, run_tool, skipped};

/// Name of the scene in the folder of a program.
const SCENE: &str = "scene";

/// What a program is made of.
#[derive(Debug)]
pub struct Source {
    /// Name of the program in its folder.
    pub program: &'static str,
    /// Path of its text.
    pub text: &'static str,
    /// Header of the library.
    pub header: &'static str,
    /// How it is linked.
    pub link: &'static str,
    /// Library in words, and the package that has it.
    pub package: [&'static str; 2],
}

/// A program, compiled for this processor into a folder that is removed with it.
#[derive(Debug)]
pub struct Compiled {
    source: &'static Source,
    folder: TempDir,
}

impl Compiled {
    /// Compiles it. The inner error is a line that names the package that is missing here.
    ///
    /// # Errors
    /// If it cannot be compiled although all packages are here.
    pub fn new(source: &'static Source) -> Result<Result<Self, String>, String> {
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        let header = format!("#include <{}>\n", source.header);
        fs::write(folder.path().join("probe.cpp"), header).map_err(|error| error.to_string())?;
        match run_tool("g++", &["-fsyntax-only", "probe.cpp"], folder.path())? {
            None => return Ok(Err(skipped("g++", "g++"))),
            Some(ended) if !ended.status.success() => {
                let [library, package] = source.package;
                return Ok(Err(skipped(library, package)));
            }
            Some(_) => {}
        }
        let options = ["-std=c++17", "-O3", "-march=native", source.text, "-o", source.program, source.link];
        match run_tool("g++", &[&options[..], &["-pthread"]].concat(), folder.path())? {
            Some(ended) if ended.status.success() => Ok(Ok(Self { source, folder })),
            ended => {
                let said = ended.map(|ended| String::from_utf8_lossy(&ended.stderr).into_owned());
                Err(format!("{}: {}", source.text, said.unwrap_or_default()))
            }
        }
    }

    /// Starts it over a mesh: the program, and the seconds that it says `word` took.
    ///
    /// # Errors
    /// If it cannot be fed or ends early.
    pub fn start(&self, mesh: &EyeMesh, sight: &Sight, word: &str) -> Result<(Drawing, f64), String> {
        let scene = self.folder.path().join(SCENE);
        fs::write(&scene, scene_file(mesh, sight))
            .map_err(|error| format!("{}: {error}", scene.display()))?;
        let (process, said) = Process::start(self.source.program, self.folder.path(), SCENE)?;
        let seconds = said.strip_prefix(word).and_then(|seconds| seconds.trim().parse().ok());
        let seconds = seconds.ok_or_else(|| process.unexpected(&format!("{word} SECONDS"), &said))?;
        Ok((Drawing { process, size: sight.size }, seconds))
    }
}

/// A program over one mesh, waiting for questions.
#[derive(Debug)]
pub struct Drawing {
    process: Process,
    size: [u32; 2],
}

impl Drawing {
    /// The seconds that it answers to a question.
    ///
    /// # Errors
    /// If it does not answer so.
    pub fn seconds(&mut self, question: &str) -> Result<f64, String> {
        let said = self.process.ask(question)?;
        said.parse().map_err(|_| self.process.unexpected("seconds", &said))
    }

    /// Light of the last frame, line by line from the top left.
    ///
    /// # Errors
    /// If it does not write as many numbers as the picture has pixels.
    pub fn picture(&mut self) -> Result<Vec<f32>, String> {
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        let path = folder.path().join("picture");
        self.expect(&format!("picture {}", path.display()), "written")?;
        read_picture(&path, self.size)
    }

    /// Hands over a texture of so many columns and lines: its light, line by line from the top left.
    ///
    /// # Errors
    /// If it does not take it.
    pub fn texture(&mut self, [columns, lines]: [usize; 2], lights: &[f32]) -> Result<(), String> {
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        let path = folder.path().join("texture");
        let bytes: Vec<u8> = lights.iter().flat_map(|light| light.to_le_bytes()).collect();
        fs::write(&path, bytes).map_err(|error| format!("{}: {error}", path.display()))?;
        self.expect(&format!("texture {columns} {lines} {}", path.display()), "read")
    }

    /// Asks for something that is answered by one word.
    fn expect(&mut self, question: &str, word: &str) -> Result<(), String> {
        let said = self.process.ask(question)?;
        if said == word { Ok(()) } else { Err(self.process.unexpected(word, &said)) }
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
