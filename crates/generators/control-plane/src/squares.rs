//! Squares of regions whose data are one chain of records (hardware section 4.7).

use std::collections::BTreeMap;

use data_bank::Piece;
use dpu::Sector;
use hardware_model::KindBank;
use landscape::Level;

/// Squares of regions over the finest level.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SquareGrid {
    /// South-west corner: north, east (m).
    origin: [f64; 2],
    /// Side of a square (m).
    side: f64,
    /// Squares to the north and to the east.
    counts: [u32; 2],
    /// Regions along the side of a square.
    regions: u32,
}

/// Something in a bank that is no terrain.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stored {
    /// Place that decides its square: north, east (m).
    pub anchor: [f64; 2],
    /// Least north and east of what it covers (m).
    pub low: [f64; 2],
    /// Largest north and east of what it covers (m).
    pub high: [f64; 2],
    /// Words of its data.
    pub words: u32,
}

/// The chains of one kind of data.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Chains {
    /// By number of the square.
    chains: BTreeMap<u32, Chain>,
    /// First and last record of each thing in its chain, in the order in which they came.
    links: Vec<[u32; 2]>,
}

/// What lies in one square.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Chain {
    /// Words that are filled, with those that are left free at the end of records.
    words: u64,
    low: [f64; 2],
    high: [f64; 2],
}

impl SquareGrid {
    /// The squares of `bank` over the finest level; what lies beyond its edge belongs to the squares along the edge.
    pub fn new(level: &Level, bank: &KindBank) -> Self {
        let regions = bank.record_regions;
        let counts =
            level.corners().map(|corners| (corners as u32).saturating_sub(1).div_ceil(regions).max(1));
        Self { origin: level.origin(), side: f64::from(regions) * level.region_size(), counts, regions }
    }

    /// Number of squares, to the north times to the east.
    pub fn count(&self) -> u32 {
        self.counts[0].saturating_mul(self.counts[1])
    }

    /// The square of a place (north, east; m).
    pub fn square_of(&self, place: [f64; 2]) -> u32 {
        let [north, east] = [0, 1].map(|axis: usize| {
            let along = ((place[axis] - self.origin[axis]) / self.side).floor();
            along.clamp(0.0, f64::from(self.counts[axis] - 1)) as u32
        });
        north * self.counts[1] + east
    }

    /// The south-west region of a square, or of the square of a record: north, east.
    pub fn region_of(&self, item: u32) -> [i64; 2] {
        let square = item % self.count();
        [square / self.counts[1], square % self.counts[1]].map(|along| i64::from(along * self.regions))
    }

    fn centre_of(&self, square: u32) -> [f64; 2] {
        let along = [square / self.counts[1], square % self.counts[1]];
        [0, 1].map(|axis: usize| self.origin[axis] + self.side * (f64::from(along[axis]) + 0.5))
    }

    /// Orders squares, or records, by the distance of their squares from `foot` (north, east; m); equal distances keep ascending squares.
    pub fn nearest_first(&self, pieces: &mut [Piece], foot: [f64; 2]) {
        let distance = |square: u32| {
            let [north, east] = self.centre_of(square % self.count());
            let [north, east] = [north - foot[0], east - foot[1]];
            north * north + east * east
        };
        pieces.sort_by(|a, b| distance(a.item).total_cmp(&distance(b.item)).then(a.item.cmp(&b.item)));
    }
}

impl Chains {
    /// The chains of everything in a bank with squares of `grid` and records of `record_words`. A thing begins in a new record where
    /// the present one has no room for it.
    pub fn new(grid: &SquareGrid, record_words: u32, stored: impl Iterator<Item = Stored>) -> Self {
        let mut all = Self::default();
        let room = u64::from(record_words);
        for Stored { anchor, low, high, words } in stored {
            let chain = all.chains.entry(grid.square_of(anchor)).or_insert(Chain { words: 0, low, high });
            let words = u64::from(words);
            if chain.words % room + words > room {
                chain.words = chain.words.next_multiple_of(room);
            }
            let last = chain.words + words.max(1) - 1;
            all.links.push([chain.words, last].map(|word| u32::try_from(word / room).unwrap_or(u32::MAX)));
            chain.words += words;
            for axis in 0..2 {
                chain.low[axis] = chain.low[axis].min(low[axis]);
                chain.high[axis] = chain.high[axis].max(high[axis]);
            }
        }
        all
    }

    /// Records of `grid` that hold thing number `thing`, which is anchored at a place (north, east; m).
    pub fn records_of(
        &self,
        grid: &SquareGrid,
        thing: usize,
        anchor: [f64; 2],
    ) -> impl Iterator<Item = u32> + use<> {
        let [first, last] = self.links[thing];
        let (square, squares) = (grid.square_of(anchor), grid.count());
        (first..=last).map_while(move |link| link.checked_mul(squares)?.checked_add(square))
    }

    /// Squares with anything that reaches into `sector`, whose lengths are in metres, each with its records.
    pub fn met_by(&self, sector: &Sector, record_words: u32) -> Vec<Piece> {
        let foot = sector.foot;
        let from_foot = |place: [f64; 2]| [place[0] - foot[0], place[1] - foot[1]];
        let is_met = |chain: &Chain| sector.meets(from_foot(chain.low), from_foot(chain.high));
        let met = self.chains.iter().filter(|(_, chain)| is_met(chain));
        met.map(|(&item, chain)| Piece { item, records: records(chain.words, record_words) }).collect()
    }
}

/// The same pieces record by record, the first of each before all second ones.
pub fn record_by_record(pieces: &[Piece], squares: u32) -> Vec<Piece> {
    let longest = pieces.iter().map(|piece| piece.records).max().unwrap_or(0);
    let links = (0..longest).flat_map(|link| {
        let there = pieces.iter().filter(move |piece| link < piece.records);
        there.filter_map(move |piece| Some(Piece::one(piece.item.checked_add(link.checked_mul(squares)?)?)))
    });
    links.collect()
}

fn records(words: u64, record_words: u32) -> u32 {
    u32::try_from(words.div_ceil(u64::from(record_words))).unwrap_or(u32::MAX)
}

#[cfg(test)]
mod tests {
    use super::{Chains, SquareGrid, Stored, record_by_record};
    use data_bank::Piece;
    use dpu::Sector;
    use hardware_model::{BankPlace, KindBank};
    use landscape::Level;

    fn grid(record_regions: u32) -> SquareGrid {
        let level = Level::new(100.0, [50.0, -50.0], [8, 6], vec![[0.0; 9]; 48]).unwrap();
        let place = BankPlace::Apart;
        SquareGrid::new(
            &level,
            &KindBank { place, record_words: 20, record_regions, buffer_words: None, edit: 0.0 },
        )
    }

    fn circle(anchor: [f64; 2], radius: f64, words: u32) -> Stored {
        let [low, high] = [-radius, radius].map(|radius| anchor.map(|place| place + radius));
        Stored { anchor, low, high, words }
    }

    #[test]
    fn squares_tile_the_regions_and_what_is_beyond_belongs_to_the_edge() {
        assert_eq!((grid(1).count(), grid(2).count(), grid(9).count()), (35, 12, 1));
        assert_eq!(grid(1).square_of([50.0, -50.0]), 0);
        assert_eq!(grid(1).square_of([149.9, 50.0]), 1);
        assert_eq!(grid(2).square_of([250.0, -50.0]), 3);
        assert_eq!(grid(1).square_of([-1e9, 1e9]), 4);
        assert_eq!(grid(2).region_of(4), [2, 2]);
    }

    #[test]
    fn chains_are_as_long_as_their_words_and_reach_as_far_as_what_lies_in_them() {
        let grid = grid(1);
        let stored = [
            circle([60.0, 0.0], 5.0, 8),
            circle([70.0, 0.0], 300.0, 13),
            circle([260.0, 0.0], 1.0, 20),
            circle([80.0, 0.0], 1.0, 7),
            circle([90.0, 0.0], 1.0, 45),
        ];
        let chains = Chains::new(&grid, 20, stored.into_iter());
        let records =
            |thing: usize| chains.records_of(&grid, thing, stored[thing].anchor).collect::<Vec<_>>();
        // 8 and 13 words have no room in one record of 20, 13 and 7 have; 45 need three.
        assert_eq!([0, 1, 2, 3].map(records), [[0], [35], [10], [35]].map(Vec::from));
        assert_eq!(records(4), [70, 105, 140]);
        // Only the wide one reaches back to where the sector looks.
        let sector = Sector { foot: [-100.0, 0.0], edges: None, range: 10.0 };
        assert_eq!(chains.met_by(&sector, 20), [Piece { item: 0, records: 5 }]);
        let far = Sector { foot: [900.0, 0.0], edges: None, range: 640.0 };
        let mut pieces = chains.met_by(&far, 20);
        grid.nearest_first(&mut pieces, far.foot);
        assert_eq!(pieces.iter().map(|piece| piece.item).collect::<Vec<_>>(), [10, 0]);
        let records: Vec<u32> = record_by_record(&pieces, 35).iter().map(|piece| piece.item).collect();
        assert_eq!(records, [10, 0, 35, 70, 105, 140]);
        assert_eq!(grid.region_of(140), grid.region_of(0));
    }
}
