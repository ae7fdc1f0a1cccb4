//! What a frame takes, counted, and how long that is.

use lod_tiles::{State, Surface, Tile, TilePieces, Version};
use scenario::View;
use timing::{Task, UnitUse};

use super::Hardware;

/// The processor: what the program does for each tile.
pub const CPU: &str = "cpu";
/// What goes from the program to the board.
const BUS: &str = "bus";
/// The board's two stages, which work at the same time.
const VERTEX: &str = "gpu.vertex";
const TRIANGLE: &str = "gpu.triangle";
/// Pictures that are read back.
const CAPTURE: &str = "capture";

/// The units of a frame, in the order of their work.
const UNITS: [&str; 5] = [CPU, BUS, VERTEX, TRIANGLE, CAPTURE];

/// Ticks of its records in a second: whole nanoseconds.
pub const SECOND: u64 = 1_000_000_000;

/// Nodes under a tile's level that show one of several versions: four outer faces, four corners.
const VERSION_NODES: u64 = 8;

/// Triangles of a level in a frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
struct LevelTriangles {
    /// Of cells that touch no side of their tile.
    inner: u64,
    /// On the sides of tiles whose neighbours all have the same level.
    same: u64,
    /// On the sides of tiles with a neighbour of another level.
    adapted: u64,
}

/// The work of a frame in pieces.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Work {
    /// All tiles: the program looks at each.
    tiles: u64,
    /// Visits of the neighbour rule.
    visits: u64,
    /// Words of the uniform array.
    words: u64,
    /// Nodes that show another child than in the frame before.
    switches: u64,
    /// Triangles of the tiles in view, the finest level first.
    levels: Vec<LevelTriangles>,
    /// Vertices of the tiles in view that are where their level has them.
    still: u64,
    /// Vertices of those that have moved on their way to the next level.
    morphing: u64,
    /// Bytes of the picture that are read back.
    bytes: u64,
}

impl Work {
    /// The work of a frame that shows `tiles` of a surface, after one of the state `before`; the first one sets every node. `words` are those of
    /// the uniform array.
    pub fn of(surface: &Surface<'_>, before: Option<&State>, tiles: &[Tile], words: u64) -> Self {
        let mut work = Self {
            tiles: surface.state.tiles().len() as u64,
            visits: surface.state.visits(),
            words,
            switches: switches(surface, before),
            levels: vec![LevelTriangles::default(); surface.levels],
            ..Self::default()
        };
        tiles.iter().for_each(|tile| work.add(surface, *tile));
        work
    }

    /// The same with a picture of `view` that is read back, where the hardware holds pictures.
    pub fn captured(self, view: &View, hardware: &Hardware) -> Self {
        let bytes = u64::from(hardware.capture.is_held) * picture_bytes(view, hardware);
        Self { bytes, ..self }
    }

    fn add(&mut self, surface: &Surface<'_>, tile: Tile) {
        let TilePieces { inner, border, still, morphing } = surface.pieces(tile);
        let level = &mut self.levels[surface.tile_state(tile).level];
        let is_same = surface.versions(tile) == [Version::Same; 4];
        level.inner += inner;
        *if is_same { &mut level.same } else { &mut level.adapted } += border;
        self.still += still;
        self.morphing += morphing;
    }

    /// Words of the uniform array.
    pub fn words(&self) -> u64 {
        self.words
    }

    /// Triangles and vertices of the tiles in view.
    pub fn drawn(&self) -> [u64; 2] {
        let triangles = self.levels.iter().map(|level| level.inner + level.same + level.adapted).sum();
        [triangles, self.still + self.morphing]
    }

    /// The tasks of the frame that have something to do, in the order of the viewer, timed in nanoseconds.
    pub fn tasks(&self, hardware: &Hardware) -> Vec<Task> {
        let Hardware { viewer, board, capture } = hardware;
        let of_tile = |task: &str| named(CPU, task, self.tiles, self.tiles * viewer.tile_ns);
        let mut tasks = vec![
            of_tile("distance"),
            of_tile("level"),
            named(CPU, "neighbours", self.visits, self.visits * viewer.visit_ns),
            of_tile("versions"),
            of_tile("percentage"),
            named(BUS, "percentages", self.words, self.words * viewer.word_ns),
            named(BUS, "switches", self.switches, self.switches * viewer.switch_ns),
        ];
        for (task, pieces) in [("still", self.still), ("morphing", self.morphing)] {
            tasks.push(named(VERTEX, task, pieces, at_rate(pieces, board.vertices_s)));
        }
        for (number, level) in self.levels.iter().enumerate() {
            let kinds = [("inner", level.inner), ("same", level.same), ("adapted", level.adapted)];
            for (kind, pieces) in kinds {
                let task = format!("level-{number}.{kind}");
                tasks.push(named(TRIANGLE, &task, pieces, at_rate(pieces, board.triangles_s)));
            }
        }
        tasks.push(named(CAPTURE, "read-back", self.bytes, at_rate(self.bytes, capture.readback_bytes_s)));
        // A record has what takes time.
        tasks.retain(|task| task.pieces > 0 && task.ticks > 0);
        tasks
    }
}

fn named(unit: &str, task: &str, pieces: u64, ticks: u64) -> Task {
    Task { unit: unit.into(), task: task.into(), pieces, ticks }
}

/// Time (ns) of so many pieces at a rate, rounded up.
pub fn at_rate(pieces: u64, per_second: u64) -> u64 {
    let ticks = (u128::from(pieces) * u128::from(SECOND)).div_ceil(u128::from(per_second));
    u64::try_from(ticks).unwrap_or(u64::MAX)
}

/// Bytes of a picture.
pub fn picture_bytes(view: &View, hardware: &Hardware) -> u64 {
    u64::from(view.columns) * u64::from(view.lines) * hardware.capture.pixel_bytes
}

/// Use of all units by the tasks of a frame.
pub fn units(tasks: &[Task]) -> Vec<UnitUse> {
    let of = |unit: &str| UnitUse { unit: unit.into(), busy: busy(tasks, unit), longest_queue: 0 };
    UNITS.map(of).into()
}

fn busy(tasks: &[Task], unit: &str) -> u64 {
    tasks.iter().filter(|task| task.unit == unit).map(|task| task.ticks).sum()
}

/// Time (ns) of a frame: program, transfer, board, read-back one after another; the board's stages work at the same time.
pub fn frame_time(tasks: &[Task]) -> u64 {
    let [cpu, bus, vertex, triangle, capture] = UNITS.map(|unit| busy(tasks, unit));
    cpu + bus + vertex.max(triangle) + capture
}

/// The unit that takes most of a frame.
pub fn slowest(tasks: &[Task]) -> &'static str {
    let times = UNITS.map(|unit| (busy(tasks, unit), unit));
    times.into_iter().rev().max_by_key(|(busy, _)| *busy).map_or(CPU, |(_, unit)| unit)
}

/// Nodes that show another child than in the state before: the level of a tile, its outer faces, and the corners beside one of those. A tile that
/// takes another level sets all that it has.
fn switches(surface: &Surface<'_>, before: Option<&State>) -> u64 {
    let all = 1 + VERSION_NODES;
    let Some(before) = before else { return all * surface.state.tiles().len() as u64 };
    let earlier = Surface { state: before, ..*surface };
    let of_tile = |tile: Tile| {
        if surface.tile_state(tile).level != earlier.tile_state(tile).level {
            return all;
        }
        let (now, then) = (surface.versions(tile), earlier.versions(tile));
        let [left, right, bottom, top] = [0, 1, 2, 3].map(|side| now[side] != then[side]);
        let sides = [left, right, bottom, top].into_iter();
        let corners = [left || bottom, right || bottom, left || top, right || top];
        sides.chain(corners).filter(|is_changed| *is_changed).count() as u64
    };
    surface.terrain.tiles().map(of_tile).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The specification's figures (section 12): 512 triangles, 46 208 of them, and how many fit a sixtieth of a second.
    #[test]
    fn the_board_was_never_the_limit_of_the_thesis() {
        let rate = Hardware::shipped().unwrap().board.triangles_s;
        assert_eq!((at_rate(512, rate), at_rate(46_208, rate)), (2829, 255_293));
        assert!((3_016_000..3_017_000).contains(&(rate / 60)));
        assert_eq!(at_rate(2 * 1228 * 1228, rate).div_ceil(SECOND / 60), 1);
    }

    #[test]
    fn stages_of_the_board_work_at_the_same_time() {
        let of = |unit: &str, ticks: u64| named(unit, "work", 1, ticks);
        let tasks = [of(CPU, 5), of(BUS, 7), of(VERTEX, 11), of(TRIANGLE, 30), of(CAPTURE, 13)];
        assert_eq!((frame_time(&tasks), slowest(&tasks)), (5 + 7 + 30 + 13, TRIANGLE));
        assert_eq!(units(&tasks).iter().map(|unit| unit.busy).collect::<Vec<_>>(), [5, 7, 11, 30, 13]);
    }
}
