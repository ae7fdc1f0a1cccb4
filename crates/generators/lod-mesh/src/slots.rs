//! What becomes of the fractions of tiles on their way to the graphics board.

use lod_tiles::{State, Terrain};

use crate::parameters::{Parameters, Slots};

/// Largest order of a tile.
const LARGEST_ORDER: u32 = 12;

/// The state as the board has it: fractions that share slots, in words of few bits.
pub fn on_board(terrain: &Terrain, state: State, run: &Parameters, slots: Option<u32>) -> State {
    let state = match (run.slots, slots) {
        (Slots::Share, Some(slots)) => shared(terrain, &state, slots),
        _ => state,
    };
    match run.percent_bits {
        0 => state,
        bits => {
            let most = f64::from((1_u32 << bits) - 1);
            state.with_fractions(|_, tile| (tile.fraction * most).round() / most)
        }
    }
}

/// How many words a state has in the uniform array.
pub fn words(terrain: &Terrain, run: &Parameters, slots: Option<u32>) -> u64 {
    match (run.slots, slots) {
        (Slots::Share, Some(slots)) => {
            let side = block_side(terrain, slots);
            terrain.counts().map(|count| count.div_ceil(side) as u64).iter().product()
        }
        _ => terrain.counts().map(|count| count as u64).iter().product(),
    }
}

/// Side (tiles) of the smallest square blocks that have a slot each.
fn block_side(terrain: &Terrain, slots: u32) -> usize {
    let counts = terrain.counts();
    let fits =
        |side: &usize| counts.map(|count| count.div_ceil(*side)).iter().product::<usize>() <= slots as usize;
    (1..=counts[0].max(counts[1])).find(fits).unwrap_or(1)
}

/// Every tile of a block has the fraction of the block's middle tile.
fn shared(terrain: &Terrain, state: &State, slots: u32) -> State {
    let (side, [columns, rows]) = (block_side(terrain, slots), terrain.counts());
    let middle = |at: usize, count: usize| (at / side * side + side / 2).min(count - 1);
    state.with_fractions(|number, _| {
        let [column, row] = [middle(number % columns, columns), middle(number / columns, rows)];
        state.tile(row * columns + column).fraction
    })
}

/// The least order, that of `terrain` or above, whose tiles have a slot each; `None` if no tile is large enough.
pub fn fitting_order(terrain: &Terrain, slots: u32) -> Option<u32> {
    let cells = terrain.counts().map(|count| count << terrain.order());
    let tiles = |order: u32| cells.map(|cells| cells.div_ceil(1 << order)).iter().product::<usize>();
    (terrain.order()..=LARGEST_ORDER).find(|order| tiles(*order) <= slots as usize)
}

#[cfg(test)]
mod tests {
    use super::*;
    use lod_tiles::TileState;

    /// 5 x 3 tiles of two cells a side, each with a fraction of its own.
    fn ground() -> (Terrain, State) {
        let places = |count: usize| (0..count).map(|at| at as f64).collect::<Vec<f64>>();
        let terrain = Terrain::new(1, [places(11), places(7)], vec![0.0; 77]).unwrap();
        let tiles = (0..15).map(|number| TileState { level: 0, fraction: f64::from(number) / 16.0 });
        let state = State::of(&terrain, tiles.collect());
        (terrain, state)
    }

    #[test]
    fn tiles_share_slots_in_the_smallest_blocks_that_fit() {
        let (terrain, state) = ground();
        let run = Parameters { slots: Slots::Share, ..Parameters::default() };
        assert_eq!([14, 6, 5].map(|slots| words(&terrain, &run, Some(slots))), [6, 6, 2]);
        let shared = on_board(&terrain, state.clone(), &run, Some(14));
        let sixteenths: Vec<u32> = shared.tiles().iter().map(|tile| (16.0 * tile.fraction) as u32).collect();
        // Blocks of two by two have the fraction of their tile at the top right, those at the border of the last one that there is.
        assert_eq!(sixteenths, [6, 6, 8, 8, 9, 6, 6, 8, 8, 9, 11, 11, 13, 13, 14]);
        assert_eq!(on_board(&terrain, state.clone(), &run, Some(15)), state, "all have a slot");
        assert_eq!(on_board(&terrain, state.clone(), &run, None), state, "slots without limit");
    }

    #[test]
    fn fractions_of_few_bits_are_the_nearest() {
        let (terrain, state) = ground();
        let run = Parameters { percent_bits: 2, ..Parameters::default() };
        let thirds: Vec<f64> =
            on_board(&terrain, state, &run, None).tiles().iter().map(|tile| 3.0 * tile.fraction).collect();
        assert_eq!(thirds[..6], [0.0, 0.0, 0.0, 1.0, 1.0, 1.0]);
        assert_eq!(thirds[14], 3.0);
    }

    #[test]
    fn larger_tiles_are_fewer() {
        let (terrain, _) = ground();
        assert_eq!(
            [15, 14, 6, 5, 1].map(|slots| fitting_order(&terrain, slots)),
            [Some(1), Some(2), Some(2), Some(3), Some(4)]
        );
    }
}
