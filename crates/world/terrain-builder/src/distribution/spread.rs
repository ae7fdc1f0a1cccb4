//! Items that keep a least distance from those before them.

use std::collections::HashMap;

use super::{Distribution, Item};
use crate::frame::Frame;

/// Places that an item tries before it is left out (chosen).
const ATTEMPTS: u64 = 64;

/// Items in order; each takes the first of its places that is free.
pub fn apart(distribution: &Distribution, frame: &Frame, count: u64) -> Vec<Item> {
    let mut taken = Taken { separation: distribution.separation, cells: HashMap::new() };
    let mut items = Vec::new();
    for number in 0..count {
        let mut places = (0..ATTEMPTS).map(|attempt| distribution.item(frame, number, attempt));
        if let Some(item) = places.find(|item| taken.is_free(item.at)) {
            taken.take(item.at);
            items.push(item);
        }
    }
    items
}

/// Places that are taken, by square cells as wide as the separation: neighbours lie in the cells around.
struct Taken {
    separation: f64,
    cells: HashMap<[i64; 2], Vec<[f64; 2]>>,
}

impl Taken {
    fn cell(&self, at: [f64; 2]) -> [i64; 2] {
        at.map(|place| (place / self.separation).floor() as i64)
    }

    fn is_free(&self, at: [f64; 2]) -> bool {
        let [row, column] = self.cell(at);
        let around = (-1..=1).flat_map(|north| (-1..=1).map(move |east| [row + north, column + east]));
        around.filter_map(|cell| self.cells.get(&cell)).flatten().all(|other| {
            let way = [at[0] - other[0], at[1] - other[1]];
            way[0] * way[0] + way[1] * way[1] >= self.separation * self.separation
        })
    }

    fn take(&mut self, at: [f64; 2]) {
        self.cells.entry(self.cell(at)).or_default().push(at);
    }
}
