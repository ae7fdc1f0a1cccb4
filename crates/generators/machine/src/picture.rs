//! A picture while it is written: each tile is read as soon as its last sweep is there, and of the cells of a frame only
//! those are kept that a tile waits for.

use std::ops::Range;
use std::sync::{Arc, Mutex, PoisonError};

use signal::LANES;
use sweep_memory::{Reading, Sweeps, Tile};

use crate::pool::Pool;

/// What a group of sweeps has written, sweep by sweep.
pub(crate) type Cells = Arc<Vec<f32>>;

/// The tiles of a picture.
pub(crate) struct Picture<'a> {
    reading: Reading,
    tiles: Vec<Waiting<'a>>,
}

/// A tile that waits for groups of sweeps.
struct Waiting<'a> {
    groups: Range<usize>,
    state: Mutex<State<'a>>,
}

struct State<'a> {
    tile: Tile<'a>,
    /// Those of its groups that are there, in their order.
    cells: Vec<Option<Cells>>,
}

impl<'a> Picture<'a> {
    /// A picture that is read into `pixels` (row by row): those of its tiles whose sweeps are all among the `written`.
    pub fn new(reading: Reading, pixels: &'a mut [f32], written: &Range<u32>) -> Self {
        let written = written.start as usize..written.end as usize;
        let waiting = |tile: Tile<'a>| {
            let sweeps = reading.sweeps(&tile.columns);
            if sweeps.start < written.start || written.end < sweeps.end {
                return None;
            }
            let groups = sweeps.start / LANES..sweeps.end.div_ceil(LANES);
            let cells = vec![None; groups.len()];
            Some(Waiting { groups, state: Mutex::new(State { tile, cells }) })
        };
        Self { reading, tiles: Tile::all(pixels, reading.columns).into_iter().filter_map(waiting).collect() }
    }

    /// Takes what group `group` has written, and reads the tiles that waited for it alone. Cells that no tile waits for
    /// any more go to `done`.
    pub fn take(&self, group: usize, cells: Cells, done: &Pool<Cells>) {
        for Waiting { groups, state } in self.tiles.iter().filter(|tile| tile.groups.contains(&group)) {
            let mut state = state.lock().unwrap_or_else(PoisonError::into_inner);
            let State { tile, cells: there } = &mut *state;
            there[group - groups.start] = Some(Arc::clone(&cells));
            if there.iter().all(Option::is_some) {
                self.read(groups.start, there, tile);
                there.drain(..).flatten().for_each(|cells| give_back(cells, done));
            }
        }
        give_back(cells, done);
    }

    fn read(&self, first: usize, groups: &[Option<Cells>], tile: &mut Tile<'_>) {
        let mut sweeps: Vec<&[f32]> = Vec::with_capacity(groups.len() * LANES);
        sweeps.extend(groups.iter().flatten().flat_map(|cells| cells.chunks_exact(self.reading.cells)));
        self.reading.read(Sweeps { first: first * LANES, cells: &sweeps }, tile);
    }
}

/// Whoever is the last to have them leaves them to the next group.
fn give_back(mut cells: Cells, done: &Pool<Cells>) {
    if Arc::get_mut(&mut cells).is_some() {
        done.give_back(cells);
    }
}
