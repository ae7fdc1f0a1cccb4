//! The format of a file: by its ending, which its first bytes must not contradict.

use std::path::Path;

use diagnostics::{Problem, ProblemList};

/// Formats that are read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Format {
    /// Wavefront OBJ, which is text.
    Obj,
    /// STL, binary or as text.
    Stl,
    /// PLY, binary or as text.
    Ply,
    /// glTF 2.0, its JSON.
    Gltf,
    /// glTF 2.0, JSON and buffer in one binary file.
    Glb,
}

/// Endings and names of formats.
const FORMATS: [(&str, Format, &str); 5] = [
    ("obj", Format::Obj, "Wavefront OBJ"),
    ("stl", Format::Stl, "STL"),
    ("ply", Format::Ply, "PLY"),
    ("gltf", Format::Gltf, "glTF"),
    ("glb", Format::Glb, "binary glTF"),
];

impl Format {
    /// The format of a file.
    ///
    /// # Errors
    /// If the ending is none that is read, or the first bytes are those of another format.
    pub fn of(path: &Path, name: &str, bytes: &[u8]) -> Result<Self, ProblemList> {
        let ending = path.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
        let Some((_, format, said)) = FORMATS.iter().find(|(known, ..)| *known == ending) else {
            let title = format!("the ending `{ending}` is no format of shapes that is read");
            return Err(Problem::of_file(name, title)
                .expected("a file that ends in .obj, .stl, .ply, .gltf or .glb")
                .help("export it again from the program that made it")
                .into());
        };
        match Self::by_content(bytes).filter(|found| found != format) {
            None => Ok(*format),
            Some(found) => {
                let is = |(_, format, _): &&(&str, Self, &str)| *format == found;
                let [ending, is] = FORMATS.iter().find(is).map_or(["", ""], |(ending, _, is)| [ending, is]);
                let title = format!("the file is named as {said}, but its first bytes are those of {is}");
                Err(Problem::of_file(name, title).help(format!("rename it to end in .{ending}")).into())
            }
        }
    }

    /// The format that the first bytes tell; no bytes tell an OBJ file.
    fn by_content(bytes: &[u8]) -> Option<Self> {
        let text = text::without_byte_order_mark(bytes).trim_ascii_start();
        let after_word =
            |word: &[u8]| text.strip_prefix(word)?.first().filter(|byte| byte.is_ascii_whitespace());
        match () {
            () if bytes.starts_with(b"glTF") => Some(Self::Glb),
            () if after_word(b"ply").is_some() => Some(Self::Ply),
            () if after_word(b"solid").is_some() => Some(Self::Stl),
            () if text.starts_with(b"{") => Some(Self::Gltf),
            () => None,
        }
    }
}
