//! Terrain and craters under a line: the first place where the line meets them.

use features::Rise;
use landscape::Landscape;

use crate::ceilings::{BLOCKS, Ceilings};
use crate::line::Line;
use crate::relief::{Blend, Relief, Sheet, Track};
use crate::rings::{Added, Passage};
use crate::walk::Walk;

/// Lists that are used again for every line.
#[derive(Debug, Clone, Default)]
pub struct Scratch {
    cuts: Vec<f64>,
    added: Added,
}

/// A stretch of a line over one level, or over two that fade into each other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Zone {
    /// The level, finest first.
    pub level: usize,
    /// The level that it fades into, and where.
    pub into: Option<(usize, Blend)>,
    /// Its ends (m of range).
    pub ends: [f64; 2],
}

/// Where a line meets the ground.
#[derive(Debug, Clone, Copy)]
pub struct Met<'a> {
    /// Ground range of that place (m).
    pub range: f64,
    /// Terrain along the line at that place.
    pub relief: Relief<'a>,
}

/// All ground of a landscape.
#[derive(Debug, Clone, Copy)]
pub struct Ground<'a> {
    landscape: &'a Landscape,
    ceilings: &'a Ceilings,
}

impl<'a> Ground<'a> {
    /// The ground of a landscape and the bounds above it.
    pub fn new(landscape: &'a Landscape, ceilings: &'a Ceilings) -> Self {
        Self { landscape, ceilings }
    }

    /// What craters add at a place (m).
    pub fn craters_at(&self, place: [f64; 2]) -> Rise {
        self.ceilings.craters().at(self.landscape.features(), place)
    }

    /// Height of terrain and craters at a place (m), from the finest level that has it; `None` outside all.
    pub fn height(&self, [x, y]: [f64; 2]) -> Option<f64> {
        let mut levels = self.landscape.bank().levels().iter();
        let terrain = levels.find_map(|level| {
            let (region, local) = level.locate(x, y)?;
            Some(level.height_and_slopes(region, local)[0])
        })?;
        Some(terrain + self.craters_at([x, y]).height)
    }

    /// Returns the number of levels that are stored.
    pub fn levels(&self) -> usize {
        self.landscape.bank().levels().len()
    }

    /// `line` over level `index`.
    pub fn track(&self, index: usize, line: &Line) -> Track<'a> {
        Track::new(&self.landscape.bank().levels()[index], self.ceilings.level(index), line)
    }

    /// The region of level `index` in which `line` is at `range` (m); `None` outside the level.
    pub fn sheet(&self, index: usize, line: &Line, range: f64) -> Option<Sheet<'a>> {
        let track = self.track(index, line);
        let [x, y] = line.place(range);
        let (region, _) = track.level.locate(x, y)?;
        Some(Sheet::new(track, region))
    }

    /// The terrain of `zone` at `range` (m) of `line`; `None` outside its levels.
    pub fn relief(&self, zone: &Zone, line: &Line, range: f64) -> Option<Relief<'a>> {
        let fine = self.sheet(zone.level, line, range)?;
        Some(match zone.into {
            None => Relief::One(fine),
            Some((level, blend)) => Relief::Two(fine, self.sheet(level, line, range)?, blend),
        })
    }

    /// Whether `line` has risen above all ground by the range `from` (m).
    pub fn is_below(&self, line: &Line, from: f64) -> bool {
        line.rise >= 0.0 && line.risen(from) > self.ceilings.highest()
    }

    /// The first place of a zone where `line` is in or under the ground. A line that begins outside the level is
    /// followed from where it comes in.
    pub fn meet(&self, line: &Line, zone: &Zone, scratch: &mut Scratch) -> Option<Met<'a>> {
        let track = self.track(zone.level, line);
        let [from, to] = [zone.ends[0].max(track.inside()[0]), zone.ends[1]];
        let mut walk = Walk::new(track.regions(), track.origin, track.step, from, to)?;
        let mut block = Checked::default();
        loop {
            if self.is_below(line, walk.from()) {
                return None;
            }
            if zone.into.is_none() && block.is_passed(&track, line, &mut walk) {
                continue;
            }
            let stretch = walk.next()?;
            let (fine, ends) = (Sheet::new(track, stretch.region), [stretch.from, stretch.to]);
            let met = match zone.into {
                None => self.meet_relief(Relief::One(fine), line, ends, scratch),
                Some((level, blend)) => self.meet_faded(fine, (level, blend), line, ends, scratch),
            };
            if met.is_some() {
                return met;
            }
        }
    }

    /// The same within one region of the fine level, over the regions of the coarse one.
    fn meet_faded(
        &self,
        fine: Sheet<'a>,
        (level, blend): (usize, Blend),
        line: &Line,
        [from, to]: [f64; 2],
        scratch: &mut Scratch,
    ) -> Option<Met<'a>> {
        let track = self.track(level, line);
        let mut walk = Walk::new(track.regions(), track.origin, track.step, from, to)?;
        walk.find_map(|stretch| {
            let relief = Relief::Two(fine, Sheet::new(track, stretch.region), blend);
            self.meet_relief(relief, line, [stretch.from, stretch.to], scratch)
        })
    }

    fn meet_relief(
        &self,
        relief: Relief<'a>,
        line: &Line,
        ends: [f64; 2],
        scratch: &mut Scratch,
    ) -> Option<Met<'a>> {
        let rise = relief.crater_rise();
        if relief.is_under(line, ends, rise.unwrap_or(0.0)) {
            return None;
        }
        let range = match rise {
            None => bare(&relief, line, ends, scratch),
            Some(_) => self.meet_craters(&relief, line, ends, scratch),
        };
        range.map(|range| Met { range, relief })
    }

    fn meet_craters(
        &self,
        relief: &Relief,
        line: &Line,
        ends: [f64; 2],
        scratch: &mut Scratch,
    ) -> Option<f64> {
        let craters = self.ceilings.craters();
        craters.parts(line, ends).find_map(|part| {
            let Some(cell) = part.cell.filter(|&cell| !craters.in_cell(cell).is_empty()) else {
                return (!relief.is_under(line, part.ends, 0.0))
                    .then(|| bare(relief, line, part.ends, scratch))?;
            };
            if relief.is_under(line, part.ends, craters.rise(cell)) {
                return None;
            }
            self.meet_cell(relief, line, part.ends, cell, scratch)
        })
    }

    /// Cuts a part at every circle that the line crosses: between them the ground has a closed form.
    fn meet_cell(
        &self,
        relief: &Relief,
        line: &Line,
        [from, to]: [f64; 2],
        cell: usize,
        scratch: &mut Scratch,
    ) -> Option<f64> {
        let features = self.landscape.features();
        let listed = self.ceilings.craters().in_cell(cell);
        let passages = || listed.iter().filter_map(|&index| Passage::new(features.crater(index), line));
        let Scratch { cuts, added } = scratch;
        cuts.clear();
        passages().for_each(|passage| passage.crossings([from, to], cuts));
        cuts.sort_unstable_by(f64::total_cmp);
        cuts.push(to);
        let mut start = from;
        for &end in cuts.iter() {
            let piece = [std::mem::replace(&mut start, end), end];
            added.clear();
            passages().for_each(|passage| passage.add(piece, added));
            if piece[1] <= piece[0] || relief.is_under(line, piece, added.crests) {
                continue;
            }
            if let Some(share) = relief.first_reach(line, piece, added) {
                return Some(piece[0] + share * (piece[1] - piece[0]));
            }
        }
        None
    }
}

/// Meets the terrain where there are no craters.
fn bare(relief: &Relief, line: &Line, ends: [f64; 2], scratch: &mut Scratch) -> Option<f64> {
    scratch.added.clear();
    let share = relief.first_reach(line, ends, &scratch.added)?;
    Some(ends[0] + share * (ends[1] - ends[0]))
}

/// The blocks that the line was last found not to pass over.
#[derive(Default)]
struct Checked([Option<[usize; 2]>; 2]);

impl Checked {
    /// Leaves the block of regions in which the walk is, if the line passes above all of it.
    fn is_passed(&mut self, track: &Track, line: &Line, walk: &mut Walk) -> bool {
        for (tier, size) in BLOCKS.into_iter().enumerate() {
            let Some(end) = walk.block_end(size as i64) else { return false };
            let block = walk.region().map(|index| index / size);
            if self.0[tier] == Some(block) {
                continue;
            }
            self.0[tier] = Some(block);
            let reaches = end > walk.from();
            if reaches && line.lowest(walk.from(), end) > track.ceilings.block(tier, walk.region()) {
                walk.leave_block(size as i64);
                return true;
            }
        }
        false
    }
}
