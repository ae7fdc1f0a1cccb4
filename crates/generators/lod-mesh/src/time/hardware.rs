//! What the viewer ran on: times and memories, as `hardware-models/programs/lod-mesh.toml` has them.

use diagnostics::{ProblemList, Reader, TomlFile};
use serde_json::{Value, json};

/// The file as the program carries it.
pub(crate) const SHIPPED: &str = include_str!("../../../../../hardware-models/programs/lod-mesh.toml");

/// Name of the file that ships, for messages.
pub(crate) const FILE: &str = "built-in programs/lod-mesh.toml";

/// Tables of the file.
pub(crate) const TABLES: [&str; 3] = ["viewer", "board", "capture"];

/// Nanoseconds in a microsecond.
const MICROSECOND: f64 = 1e3;

/// Largest number of bytes of a memory (chosen): sums then fit 64 bits with room.
const MOST_BYTES: f64 = 1e15;

/// The computer and the graphics board of the viewer; times are whole nanoseconds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Hardware {
    /// What its program takes for a frame, and before the mission.
    pub viewer: Viewer,
    /// Rates and memories of the board.
    pub board: Board,
    /// What becomes of a picture that is drawn.
    pub capture: Capture,
}

/// Times of the viewer's program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Viewer {
    /// Time of one step of a tile: distance, level, versions, percentage (ns).
    pub tile_ns: u64,
    /// Time of a visit of the neighbour rule (ns).
    pub visit_ns: u64,
    /// Time of a word of the uniform array (ns).
    pub word_ns: u64,
    /// Time of a node that shows another child (ns).
    pub switch_ns: u64,
    /// Bytes in a second that are read from the database, 1 or more.
    pub read_bytes_s: u64,
    /// Time of a vertex of a version, before the mission (ns).
    pub build_ns: u64,
    /// Time of a ray of the light map, before the mission (ns).
    pub ray_ns: u64,
}

/// Rates and memories of the graphics board.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Board {
    /// Triangles in a second, 1 or more.
    pub triangles_s: u64,
    /// Vertices in a second, 1 or more.
    pub vertices_s: u64,
    /// Percentages that its uniform array holds; `None` is without limit.
    pub uniform_slots: Option<u32>,
    /// Bytes of its memory.
    pub memory_bytes: u64,
    /// Bytes of a vertex.
    pub vertex_bytes: u64,
    /// Bytes of a triangle.
    pub triangle_bytes: u64,
    /// Bytes of a texel of the light map.
    pub texel_bytes: u64,
}

/// What becomes of a picture that is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Capture {
    /// Whether it is read back, and held until the run ends.
    pub is_held: bool,
    /// Bytes of a pixel.
    pub pixel_bytes: u64,
    /// Bytes in a second that are read back, 1 or more.
    pub readback_bytes_s: u64,
    /// Bytes of the memory that holds pictures.
    pub memory_bytes: u64,
}

impl Hardware {
    /// The figures of the file that ships.
    ///
    /// # Errors
    /// Every fault of it: a program that carries a faulty one.
    pub fn shipped() -> Result<Self, ProblemList> {
        TomlFile::read_text(FILE, SHIPPED, Self::read)
    }

    /// The figures of the three tables; every key is needed.
    pub(crate) fn read(root: &Reader) -> Option<Self> {
        let [viewer, board, capture] = TABLES.map(|name| root.table_or_empty(name));
        let (viewer, board, capture) = (self::viewer(&viewer), self::board(&board), self::capture(&capture));
        Some(Self { viewer: viewer?, board: board?, capture: capture? })
    }

    /// What decides pictures under a clock of real time, for the record of a run.
    pub(crate) fn record(&self) -> Value {
        let Self { viewer, board, capture } = self;
        let microseconds = |ns: u64| ns as f64 / MICROSECOND;
        json!({
            "tile_us": microseconds(viewer.tile_ns),
            "visit_us": microseconds(viewer.visit_ns),
            "word_us": microseconds(viewer.word_ns),
            "switch_us": microseconds(viewer.switch_ns),
            "triangles_s": board.triangles_s,
            "vertices_s": board.vertices_s,
            "held": capture.is_held,
            "pixel_bytes": capture.pixel_bytes,
            "readback_bytes_s": capture.readback_bytes_s,
        })
    }
}

fn viewer(table: &Reader) -> Option<Viewer> {
    let keys = ["tile_us", "visit_us", "word_us", "switch_us"];
    let [tile, visit, word, switch] = keys.map(|key| time(table, key));
    let read = count(table, "read_bytes_s", "1/s");
    let [build, ray] = ["build_us", "ray_us"].map(|key| time(table, key));
    Some(Viewer {
        tile_ns: tile?,
        visit_ns: visit?,
        word_ns: word?,
        switch_ns: switch?,
        read_bytes_s: read?,
        build_ns: build?,
        ray_ns: ray?,
    })
}

fn board(table: &Reader) -> Option<Board> {
    let [triangles, vertices] = ["triangles_s", "vertices_s"].map(|key| count(table, key, "1/s"));
    let slots = table.u32("uniform_slots").help("0 is without limit").required();
    let memory = count(table, "memory_bytes", "bytes");
    let sizes = ["vertex_bytes", "triangle_bytes", "texel_bytes"].map(|key| size(table, key));
    let [vertex, triangle, texel] = sizes;
    Some(Board {
        triangles_s: triangles?,
        vertices_s: vertices?,
        uniform_slots: slots.map(|slots| (slots > 0).then_some(slots))?,
        memory_bytes: memory?,
        vertex_bytes: vertex?,
        triangle_bytes: triangle?,
        texel_bytes: texel?,
    })
}

fn capture(table: &Reader) -> Option<Capture> {
    let held = table.bool("held").required();
    let pixel = size(table, "pixel_bytes");
    let readback = count(table, "readback_bytes_s", "1/s");
    let memory = count(table, "memory_bytes", "bytes");
    Some(Capture { is_held: held?, pixel_bytes: pixel?, readback_bytes_s: readback?, memory_bytes: memory? })
}

/// A time in microseconds, up to a second, as nanoseconds.
fn time(table: &Reader, key: &str) -> Option<u64> {
    let time = table.f64(key).between(0.0, 1e6).unit("µs").required()?;
    Some((time * MICROSECOND).round() as u64)
}

/// A whole number from 1 to [`MOST_BYTES`], which may be written with an exponent.
fn count(table: &Reader, key: &str, unit: &'static str) -> Option<u64> {
    let whole = |number: &f64| number.fract() == 0.0;
    let number = table.f64(key).between(1.0, MOST_BYTES).unit(unit).must("a whole number", whole);
    number.required().map(|number| number as u64)
}

/// Bytes of a small thing.
fn size(table: &Reader, key: &str) -> Option<u64> {
    table.u32(key).between(1, 1000).unit("bytes").required().map(u64::from)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_shipped_file_is_the_computer_of_the_thesis() {
        let Hardware { board, capture, viewer } = Hardware::shipped().unwrap();
        assert_eq!((board.triangles_s, board.uniform_slots), (181_000_000, Some(224)));
        assert_eq!((board.memory_bytes, capture.memory_bytes), (512 << 20, 16 << 30));
        assert_eq!((viewer.tile_ns, viewer.visit_ns), (200, 50));
    }

    /// As in every file of `hardware-models/`.
    #[test]
    fn every_value_says_where_it_comes_from() {
        let values: Vec<&str> =
            SHIPPED.lines().filter(|line| line.contains(" = ") && !line.starts_with('#')).collect();
        assert_eq!(values.len(), 18);
        for line in values {
            let (_, comment) = line.split_once(" # ").unwrap_or_default();
            let statuses = ["reported", "unsourced", "chosen"];
            assert!(statuses.iter().any(|status| comment.starts_with(status)), "{line}");
        }
    }

    #[test]
    fn values_out_of_range_are_refused_by_name() {
        for (written, wrong) in [
            ("triangles_s = 181e6", "triangles_s = 0.5"),
            ("tile_us = 0.2", "tile_us = -1"),
            ("uniform_slots = 224", "uniform_slots = -1"),
            ("vertex_bytes = 32", "vertex_bytes = 0"),
            ("read_bytes_s = 60e6", "read_bytes_s = nan"),
            ("held = true", "held = 1"),
        ] {
            let text = SHIPPED.replace(written, wrong);
            let told = TomlFile::read_text("a file", &text, Hardware::read).unwrap_err().to_string();
            assert!(told.contains(wrong.split(' ').next().unwrap()), "{told}");
        }
    }
}
