//! Coefficient banks: nine words a corner, one or more levels (report III.A.1, section 5).

use std::hint::select_unpredictable;
use std::ops::RangeInclusive;

use crate::{MapFrame, basis};

/// Words a corner: height and its derivatives to order 2 in u and in v.
pub const WORDS: usize = 9;

/// The nine words of one corner, metres each: index `3 p + q` holds `d^(p+q) h_{x^p y^q}`.
pub type CornerWords = [f64; WORDS];

/// Why a level or bank cannot be made.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum BankError {
    /// Region size out of range.
    #[error("region size {0} m: expected 0.001 m to 1e9 m")]
    RegionSize(f64),
    /// Origin out of range.
    #[error("origin ({0}, {1}) m: expected two lengths of at most 1e9 m either way")]
    Origin(f64, f64),
    /// Fewer than two corners along an axis.
    #[error("{0} x {1} corners: expected at least 2 x 2, which enclose one region")]
    TooFewCorners(usize, usize),
    /// The number of corners is not what the shape says.
    #[error("{found} corners: expected {expected} for the given shape")]
    CornerCount {
        /// Number of corners that were given.
        found: usize,
        /// Corners that the shape needs.
        expected: usize,
    },
    /// A word is NaN, infinite or too large.
    #[error(
        "corner ({north}, {east}), word {word}: {value:?}: expected a number of at most 1e12 m either way"
    )]
    WordRange {
        /// Corner index to the north.
        north: usize,
        /// Corner index to the east.
        east: usize,
        /// Word index, `3 p + q`.
        word: usize,
        /// Value of the word that was found.
        value: f64,
    },
    /// A region without data that is not in the bank.
    #[error("region ({}, {}) without data: expected one of {} x {}", region[0], region[1], regions[0], regions[1])]
    VoidRegion {
        /// The region, north and east.
        region: [u32; 2],
        /// Regions of the finest level.
        regions: [u32; 2],
    },
    /// A number of the map that is out of its range.
    #[error("{what} of the map: found {found}; expected {low} to {high} (m, rad)")]
    Map {
        /// Name of the number.
        what: &'static str,
        /// Value that was found.
        found: f64,
        /// Least value that a bank may have.
        low: f64,
        /// Largest value that a bank may have.
        high: f64,
    },
    /// A bank without levels.
    #[error("bank without levels: expected at least one")]
    NoLevels,
    /// Levels not ordered from the finest to the coarsest.
    #[error("level {0} is not coarser than the one before: expected region sizes in ascending order")]
    LevelOrder(usize),
}

/// Lengths (m) between which corners stay apart and their squares stay finite, in f64.
const REGION_SIZES: RangeInclusive<f64> = 1e-3..=1e9;
/// Farthest origin of a level from that of the terrain axes, on either axis (m).
const FARTHEST: f64 = 1e9;
/// Largest word (m): slopes and their squares stay finite in f32.
const LARGEST_WORD: f64 = 1e12;

/// One grid of corners with regions of side [`region_size`](Self::region_size).
#[derive(Debug, Clone, PartialEq)]
pub struct Level {
    region_size: f64,
    origin: [f64; 2],
    corners: [usize; 2],
    words: Vec<CornerWords>,
}

impl Level {
    /// A level of `corners[0]` north by `corners[1]` east corners; `words[m * corners[1] + n]` is corner (m, n),
    /// which lies at `origin + region_size * (m, n)` (metres north, east).
    ///
    /// # Errors
    /// If the size, the origin or a word is out of its range, there is no region, or the count is wrong.
    pub fn new(
        region_size: f64,
        origin: [f64; 2],
        corners: [usize; 2],
        words: Vec<CornerWords>,
    ) -> Result<Self, BankError> {
        if !REGION_SIZES.contains(&region_size) {
            return Err(BankError::RegionSize(region_size));
        }
        if !origin.iter().all(|place| place.abs() <= FARTHEST) {
            return Err(BankError::Origin(origin[0], origin[1]));
        }
        if corners[0] < 2 || corners[1] < 2 {
            return Err(BankError::TooFewCorners(corners[0], corners[1]));
        }
        let expected = corners[0].saturating_mul(corners[1]);
        if words.len() != expected {
            return Err(BankError::CornerCount { found: words.len(), expected });
        }
        if let Some((corner, word)) = first_out_of_range(&words) {
            let (north, east) = (corner / corners[1], corner % corners[1]);
            return Err(BankError::WordRange { north, east, word, value: words[corner][word] });
        }
        Ok(Self { region_size, origin, corners, words })
    }

    /// Side of a region, d (m).
    pub fn region_size(&self) -> f64 {
        self.region_size
    }

    /// Place of corner (0, 0): north, east (m).
    pub fn origin(&self) -> [f64; 2] {
        self.origin
    }

    /// Corners to the north and to the east.
    pub fn corners(&self) -> [usize; 2] {
        self.corners
    }

    /// All corners, east fastest.
    pub fn words(&self) -> &[CornerWords] {
        &self.words
    }

    /// Index into [`words`](Self::words) of the corner nearest to (m, n) that is stored (6.5: pointers clamp).
    #[inline]
    pub fn clamped_index(&self, m: i64, n: i64) -> usize {
        self.line_index(0, m) + self.line_index(1, n)
    }

    /// What a lattice line across `axis` adds to the index of a corner on it: a corner's index is the sum of both.
    #[inline]
    pub fn line_index(&self, axis: usize, line: i64) -> usize {
        let nearest = line.min(self.corners[axis] as i64 - 1).max(0) as usize;
        nearest * select_unpredictable(axis == 0, self.corners[1], 1)
    }

    /// Extent: south, west, north, east edge (m).
    pub fn extent(&self) -> [f64; 4] {
        let [north, east] = self.corners.map(|count| (count - 1) as f64 * self.region_size);
        [self.origin[0], self.origin[1], self.origin[0] + north, self.origin[1] + east]
    }

    /// Position (x, y) (m) in units of regions from the origin.
    pub fn in_regions(&self, x: f64, y: f64) -> [f64; 2] {
        [(x - self.origin[0]) / self.region_size, (y - self.origin[1]) / self.region_size]
    }

    /// Region and local position (u, v) in [0, 1] of a point (m); `None` outside the stored area.
    pub fn locate(&self, x: f64, y: f64) -> Option<([usize; 2], [f64; 2])> {
        let at = self.in_regions(x, y);
        let mut region = [0; 2];
        let mut local = [0.0; 2];
        for axis in 0..2 {
            let last = (self.corners[axis] - 1) as f64;
            if !(at[axis] >= 0.0 && at[axis] <= last) {
                return None;
            }
            let index = at[axis].floor().min(last - 1.0);
            region[axis] = index as usize;
            local[axis] = at[axis] - index;
        }
        Some((region, local))
    }

    /// The four corners of a region, `[i][j]` with i to the north, j to the east.
    ///
    /// # Panics
    /// If the region is not stored.
    pub fn region(&self, region: [usize; 2]) -> [[&CornerWords; 2]; 2] {
        let at = |i: usize, j: usize| &self.words[(region[0] + i) * self.corners[1] + region[1] + j];
        [[at(0, 0), at(0, 1)], [at(1, 0), at(1, 1)]]
    }

    /// Height and its derivatives in u and v (all metres): the direct sum of 5.1.
    pub fn height_and_slopes(&self, region: [usize; 2], [u, v]: [f64; 2]) -> [f64; 3] {
        let corners = self.region(region);
        let along_v = |weights: &[f64; 6], i: usize, p: usize| {
            (0..6).map(|jq| weights[jq] * corners[i][jq / 3][3 * p + jq % 3]).sum::<f64>()
        };
        let (gu, gv) = (basis::values(u), basis::values(v));
        let (du, dv) = (basis::derivatives(u), basis::derivatives(v));
        let mut sums = [0.0; 3];
        for ip in 0..6 {
            let value = along_v(&gv, ip / 3, ip % 3);
            sums[0] += gu[ip] * value;
            sums[1] += du[ip] * value;
            sums[2] += gu[ip] * along_v(&dv, ip / 3, ip % 3);
        }
        sums
    }

    /// Height alone (m), bit for bit that of [`height_and_slopes`](Self::height_and_slopes).
    pub fn height(&self, region: [usize; 2], [u, v]: [f64; 2]) -> f64 {
        let corners = self.region(region);
        let (gu, gv) = (basis::values(u), basis::values(v));
        let along_v =
            |i: usize, p: usize| (0..6).map(|jq| gv[jq] * corners[i][jq / 3][3 * p + jq % 3]).sum::<f64>();
        (0..6).fold(0.0, |sum, ip| sum + gu[ip] * along_v(ip / 3, ip % 3))
    }

    /// The same ground for regions `factor` times larger: every word scaled by `factor^(p+q)` (section 8).
    pub fn scale_words(words: &CornerWords, factor: f64) -> CornerWords {
        let powers = [1.0, factor, factor * factor];
        std::array::from_fn(|index| words[index] * powers[index / 3] * powers[index % 3])
    }
}

fn first_out_of_range(words: &[CornerWords]) -> Option<(usize, usize)> {
    // NaN is not in the range either.
    let is_good = |word: &f64| word.abs() <= LARGEST_WORD;
    let first = |nine: &CornerWords| nine.iter().position(|word| !is_good(word));
    words.iter().enumerate().find_map(|(corner, nine)| first(nine).map(|word| (corner, word)))
}

/// Where a bank lies on the Moon: its plane touches the lunoid at this point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Georeference {
    /// Latitude of the tangent point (rad, planetocentric).
    pub latitude: f64,
    /// Longitude of the tangent point (rad, east).
    pub longitude: f64,
    /// Place of the tangent point in the bank's axes: north, east (m).
    pub at: [f64; 2],
    /// Direction of true north there, clockwise from the bank's north axis (rad); `None` in banks made before it was kept.
    pub true_north: Option<f64>,
}

/// All terrain of a problem area: levels from the finest to the coarsest.
#[derive(Debug, Clone, PartialEq)]
pub struct Bank {
    title: String,
    levels: Vec<Level>,
    georeference: Option<Georeference>,
    voids: Vec<[u32; 2]>,
    map: Option<MapFrame>,
}

impl Bank {
    /// A bank of `levels`, finest first.
    ///
    /// # Errors
    /// If there is no level or they are not in ascending order of region size.
    pub fn new(
        title: impl Into<String>,
        levels: Vec<Level>,
        georeference: Option<Georeference>,
    ) -> Result<Self, BankError> {
        if levels.is_empty() {
            return Err(BankError::NoLevels);
        }
        if let Some(at) = levels.windows(2).position(|pair| pair[1].region_size <= pair[0].region_size) {
            return Err(BankError::LevelOrder(at + 1));
        }
        Ok(Self { title: title.into(), levels, georeference, voids: Vec::new(), map: None })
    }

    /// The same bank, with the regions (north, east) of its finest level for which the survey had no data: the
    /// ground there is drawn, but nothing stands on it.
    ///
    /// # Errors
    /// If a region is not stored.
    pub fn with_voids(mut self, mut voids: Vec<[u32; 2]>) -> Result<Self, BankError> {
        let [north, east] = self.finest().corners().map(|count| (count - 1) as u32);
        if let Some(region) = voids.iter().find(|region| region[0] >= north || region[1] >= east) {
            return Err(BankError::VoidRegion { region: *region, regions: [north, east] });
        }
        voids.sort_unstable();
        voids.dedup();
        self.voids = voids;
        Ok(self)
    }

    /// The same bank, with how its axes lie in the map of its elevation file. A map with a known projection says where true
    /// north is at the bank's place, whatever the place said of it.
    pub fn with_map(mut self, map: Option<MapFrame>) -> Self {
        if let Some(place) = &mut self.georeference {
            place.true_north = map.and_then(|map| map.true_north(place.at)).or(place.true_north);
        }
        Self { map, ..self }
    }

    /// How its axes lie in the map of its elevation file, if that is known.
    pub fn map(&self) -> Option<&MapFrame> {
        self.map.as_ref()
    }

    /// Regions of the finest level without data, ascending.
    pub fn voids(&self) -> &[[u32; 2]] {
        &self.voids
    }

    /// Whether the survey had no data for a region of the finest level.
    pub fn is_void(&self, region: [usize; 2]) -> bool {
        self.voids.binary_search(&region.map(|index| index as u32)).is_ok()
    }

    /// What the ground is, for people.
    pub fn title(&self) -> &str {
        &self.title
    }

    /// Levels, finest first; never empty.
    pub fn levels(&self) -> &[Level] {
        &self.levels
    }

    /// Returns the level with the smallest regions.
    pub fn finest(&self) -> &Level {
        &self.levels[0]
    }

    /// Where it lies on the Moon, if known.
    pub fn georeference(&self) -> Option<Georeference> {
        self.georeference
    }
}

#[cfg(test)]
mod tests {
    use super::{Bank, BankError, Level};

    /// Lattice of check table 23.2.
    fn table_23_2() -> Level {
        let corner = |i: i64, j: i64| {
            std::array::from_fn(|word| {
                let (p, q) = (word as i64 / 3, word as i64 % 3);
                let sum = 17 * i + 29 * j + 37 * p + 43 * q + 11 * i * p + 5 * j * q + 3 * p * q;
                (sum % 23 - 11) as f64
            })
        };
        let words = vec![corner(0, 0), corner(0, 1), corner(1, 0), corner(1, 1)];
        Level::new(400.0, [0.0, 0.0], [2, 2], words).unwrap()
    }

    #[test]
    fn check_table_23_2() {
        let rows = [
            ([0.3, 0.7], [-2.944858166825, 1.00136185875, 1.44958876875]),
            ([0.5, 0.5], [-2.477783203125, 6.00439453125, -3.39990234375]),
            ([0.125, 0.9], [-3.652162429122925, 6.70809858215332, -2.722060398101807]),
            ([1.0, 0.25], [5.10595703125, 7.97900390625, -13.927734375]),
            ([0.0, 1.0], [-5.0, 9.0, -3.0]),
        ];
        for (at, expected) in rows {
            let found = table_23_2().height_and_slopes([0, 0], at);
            assert_eq!(table_23_2().height([0, 0], at), found[0]);
            for (found, expected) in found.into_iter().zip(expected) {
                assert!((found - expected).abs() < 1e-13, "{at:?}: {found} against {expected}");
            }
        }
    }

    #[test]
    fn points_are_located_up_to_the_far_edge() {
        let level = table_23_2();
        assert_eq!(level.locate(400.0, 400.0), Some(([0, 0], [1.0, 1.0])));
        assert_eq!(level.locate(-0.001, 0.0), None);
        assert_eq!(level.locate(0.0, 400.001), None);
        assert_eq!(level.locate(f64::NAN, 0.0), None);
    }

    #[test]
    fn regions_without_data_are_known() {
        let words = vec![[0.0; 9]; 12];
        let bank =
            || Bank::new("", vec![Level::new(1.0, [0.0; 2], [3, 4], words.clone()).unwrap()], None).unwrap();
        let bank_with = bank().with_voids(vec![[1, 2], [0, 1], [1, 2]]).unwrap();
        assert_eq!(bank_with.voids(), [[0, 1], [1, 2]]);
        assert!(bank_with.is_void([1, 2]) && !bank_with.is_void([1, 1]));
        let refused = bank().with_voids(vec![[2, 0]]);
        assert_eq!(refused, Err(BankError::VoidRegion { region: [2, 0], regions: [2, 3] }));
    }

    #[test]
    fn impossible_levels_are_refused() {
        let words = vec![[0.0; 9]; 4];
        assert_eq!(Level::new(0.0, [0.0; 2], [2, 2], words.clone()), Err(BankError::RegionSize(0.0)));
        assert!(matches!(
            Level::new(1.0, [f64::NAN, 0.0], [2, 2], words.clone()),
            Err(BankError::Origin(..))
        ));
        assert_eq!(Level::new(1e10, [0.0; 2], [2, 2], words.clone()), Err(BankError::RegionSize(1e10)));
        assert_eq!(Level::new(1.0, [0.0, 2e9], [2, 2], words.clone()), Err(BankError::Origin(0.0, 2e9)));
        assert_eq!(Level::new(1.0, [0.0; 2], [1, 4], words.clone()), Err(BankError::TooFewCorners(1, 4)));
        let short = Level::new(1.0, [0.0; 2], [2, 3], words);
        assert_eq!(short, Err(BankError::CornerCount { found: 4, expected: 6 }));
        let mut poisoned = vec![[0.0; 9]; 4];
        poisoned[2][5] = f64::INFINITY;
        let refused = Level::new(1.0, [0.0; 2], [2, 2], poisoned);
        assert_eq!(refused, Err(BankError::WordRange { north: 1, east: 0, word: 5, value: f64::INFINITY }));
        assert_eq!(Bank::new("", vec![], None), Err(BankError::NoLevels));
        let of_size = |size: f64| Level::new(size, [0.0; 2], [2, 2], vec![[0.0; 9]; 4]).unwrap();
        let descending = Bank::new("", vec![of_size(2.0), of_size(5.0), of_size(5.0)], None);
        assert_eq!(descending, Err(BankError::LevelOrder(2)));
    }
}
