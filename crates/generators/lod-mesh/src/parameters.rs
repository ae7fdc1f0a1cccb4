//! Run parameters of the generator, as `[lod]` and `--set lod.KEY=VALUE` give them.

use diagnostics::Reader;
use lod_tiles::{Edges, Stitch};

/// Run parameters that no other generator has, and those of sampling.
#[derive(Debug, Clone, PartialEq)]
pub struct Parameters {
    /// How a scene is sampled.
    pub sampling: scene_sampler::Parameters,
    /// Order n of a tile: it has `2^n` cells a side.
    pub order: u32,
    /// Distance of posts (m); `None` parts the longer side of the ground into 1024 cells.
    pub spacing: Option<f64>,
    /// Most levels; `None` is all that tiles of the order have.
    pub levels: Option<u32>,
    /// Ends of the ranges of all levels (m), the finest first; empty where they follow from `tolerance`.
    pub ranges: Vec<f64>,
    /// Error of a level (pixels) that is allowed where its range begins.
    pub tolerance: f64,
    /// Shares (0 to 1) of the ranges over which levels morph: one for all, or one each.
    pub shares: Vec<f64>,
    /// How a level becomes the next one.
    pub transition: Transition,
    /// Who decides on edges.
    pub edges: Edges,
    /// How tiles are joined.
    pub stitch: Stitch,
    /// Where the light of the ground comes from.
    pub light: GroundLight,
    /// What the ground shows.
    pub show: Show,
    /// Level whose posts have the slopes that light looks up; 0 is the finest.
    pub light_level: u32,
    /// Bits of a fraction on its way to the board; 0 leaves it as it is.
    pub percent_bits: u32,
    /// What becomes of more tiles than the board has slots for.
    pub slots: Slots,
    /// What a frame that takes too long does to the next one.
    pub clock: Clock,
    /// Height at which boulders stand.
    pub boulders: Boulders,
    /// Least diameter (pixels) of a boulder that is drawn; 0 draws all, with all faces.
    pub boulder_px: f64,
}

/// How a level becomes the next one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Transition {
    /// Vertices move until the level is the next one.
    Morph,
    /// At once, at the end of the range.
    Switch,
}

/// Where the light of the ground comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GroundLight {
    /// The slopes of the finest posts, looked up pixel by pixel: the same at all levels.
    Map,
    /// The slopes of the vertices as they are drawn.
    Live,
    /// The light map and the albedo of the terrain database, for the sun that it was made under.
    Stored,
}

/// What the ground shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Show {
    /// Its light, as the eye sees it.
    Light,
    /// Levels and fractions as colours, under its light.
    Levels,
    /// The edges of its triangles in those colours, over dark ground.
    Wires,
}

/// What becomes of more tiles than the board has slots for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Slots {
    /// All have one, as on boards of today; timing tells the slots of the document's.
    Unlimited,
    /// The ground is refused, as reported.
    Refuse,
    /// Neighbouring tiles share a slot, and with it a fraction.
    Share,
}

/// What a frame that takes too long does to the next one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Clock {
    /// Nothing: every pose is drawn.
    Stepped,
    /// The next pose is the one at the time reached.
    RealTime,
}

/// Height at which boulders stand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Boulders {
    /// On the ground below them.
    OnGround,
    /// At height 0, as reported: buried in hills, hovering over valleys.
    AtMeanRadius,
}

impl Default for Parameters {
    /// Morphing over two fifths of a range is the document's own example for its three levels (chapter 6). All else is chosen.
    fn default() -> Self {
        Self {
            sampling: scene_sampler::Parameters::default(),
            order: 5,
            spacing: None,
            levels: None,
            ranges: Vec::new(),
            tolerance: 1.0,
            shares: vec![0.4],
            transition: Transition::Morph,
            edges: Edges::Shared,
            stitch: Stitch::CoarseSide,
            light: GroundLight::Map,
            show: Show::Light,
            light_level: 0,
            percent_bits: 0,
            slots: Slots::Unlimited,
            clock: Clock::Stepped,
            boulders: Boulders::OnGround,
            boulder_px: 1.0,
        }
    }
}

/// Words of the keys, with what they mean.
const TRANSITIONS: [(&str, Transition); 2] = [("morph", Transition::Morph), ("switch", Transition::Switch)];
const EDGES: [(&str, Edges); 2] = [("shared", Edges::Shared), ("per-tile", Edges::PerTile)];
const STITCHES: [(&str, Stitch); 3] =
    [("coarse-side", Stitch::CoarseSide), ("fine-side", Stitch::FineSide), ("none", Stitch::None)];
const LIGHTS: [(&str, GroundLight); 3] =
    [("map", GroundLight::Map), ("live", GroundLight::Live), ("stored", GroundLight::Stored)];
const SHOWS: [(&str, Show); 3] = [("light", Show::Light), ("levels", Show::Levels), ("wires", Show::Wires)];
const SLOTS: [(&str, Slots); 3] =
    [("unlimited", Slots::Unlimited), ("refuse", Slots::Refuse), ("share", Slots::Share)];
const CLOCKS: [(&str, Clock); 2] = [("stepped", Clock::Stepped), ("real-time", Clock::RealTime)];
const BOULDERS: [(&str, Boulders); 2] =
    [("ground", Boulders::OnGround), ("mean-radius", Boulders::AtMeanRadius)];

impl Parameters {
    /// The parameters of a `[lod]` table; the default where the table has no key.
    pub(crate) fn read(table: &Reader) -> Option<Self> {
        let usual = Self::default();
        let sampling = scene_sampler::Parameters::read(table);
        let order = table.u32("order").between(1, 12).default(usual.order);
        let spacing = table.f64("spacing_m").between(0.01, 1e6).unit("m").optional();
        let levels = table.u32("levels").between(1, 13).optional();
        let ranges = table.f64_list("ranges_m").above(0.0).unit("m").default(usual.ranges);
        let tolerance = table.f64("tolerance_px").between(0.01, 1e4).unit("pixels").default(usual.tolerance);
        let shares = table.f64_list("morph_percent").between(0.0, 100.0).unit("percent").default(vec![40.0]);
        let transition = table.one_of("transition", &TRANSITIONS).default(usual.transition);
        let edges = table.one_of("edges", &EDGES).default(usual.edges);
        let stitch = table.one_of("stitch", &STITCHES).default(usual.stitch);
        let light = table.one_of("light", &LIGHTS).default(usual.light);
        let show = table.one_of("show", &SHOWS).default(usual.show);
        let light_level = table.u32("light_level").at_most(12).default(usual.light_level);
        let percent_bits =
            table.u32("percent_bits").at_most(24).unit("bits").help("0 leaves fractions as they are");
        let percent_bits = percent_bits.default(usual.percent_bits);
        let slots = table.one_of("slots", &SLOTS).default(usual.slots);
        let clock = table.one_of("clock", &CLOCKS).default(usual.clock);
        let boulders = table.one_of("boulders", &BOULDERS).default(usual.boulders);
        let boulder_px = table.f64("boulder_px").between(0.0, 1e4).unit("pixels").default(usual.boulder_px);
        let read = Self {
            sampling: sampling?,
            order: order?,
            spacing: known(table, "spacing_m", spacing)?,
            levels: known(table, "levels", levels)?,
            ranges: ranges?,
            tolerance: tolerance?,
            shares: shares?.into_iter().map(|percent| percent / 100.0).collect(),
            transition: transition?,
            edges: edges?,
            stitch: stitch?,
            light: light?,
            show: show?,
            light_level: light_level?,
            percent_bits: percent_bits?,
            slots: slots?,
            clock: clock?,
            boulders: boulders?,
            boulder_px: boulder_px?,
        };
        read.check(table)
    }

    /// How many levels are asked for.
    pub fn level_count(&self) -> usize {
        let all = self.order + 1;
        self.levels.map_or(all, |levels| levels.min(all)) as usize
    }

    /// Whether a list is one of all levels. Where `levels` is fewer than the list has, the rest of the list is not used.
    fn fits(&self, entries: usize) -> bool {
        let all = self.order as usize + 1;
        entries == self.level_count()
            || (self.levels.is_some() && (self.level_count()..=all).contains(&entries))
    }

    /// What keys ask for together.
    fn check(self, table: &Reader) -> Option<Self> {
        let (asked, all) = (self.levels.unwrap_or(1), self.order + 1);
        let falling = self.ranges.windows(2).position(|pair| pair[1] <= pair[0]);
        let fault = if asked > all {
            let words = format!("{asked} levels of tiles of order {}", self.order);
            Some(("levels", words, format!("at most {all}, or a higher `order`")))
        } else if let Some(before) = falling {
            let [end, next] = [self.ranges[before], self.ranges[before + 1]];
            let words =
                format!("level {} ends at {next} m, where level {before} ends at {end} m", before + 1);
            Some(("ranges_m", words, "ends that rise, the finest level first".to_owned()))
        } else if !self.ranges.is_empty() && !self.fits(self.ranges.len()) {
            let words = format!("{} ranges for {} levels", self.ranges.len(), self.level_count());
            Some(("ranges_m", words, "as many ends as `levels`".to_owned()))
        } else if self.shares.len() != 1 && !self.fits(self.shares.len()) {
            let words = format!("{} shares for {} levels", self.shares.len(), self.level_count());
            Some(("morph_percent", words, "one number, or one for each level".to_owned()))
        } else if self.light_level > self.order {
            let words = format!("level {} of tiles of order {}", self.light_level, self.order);
            Some(("light_level", words, format!("at most {}, the coarsest", self.order)))
        } else if self.light_level > 0 && self.light != GroundLight::Map {
            let light = word(&LIGHTS, &self.light);
            let words = format!("level {}, where light is {light}", self.light_level);
            Some(("light_level", words, "0, or light = \"map\"".to_owned()))
        } else {
            None
        };
        match fault {
            Some((key, words, expected)) => {
                table.report(table.problem(key, words).expected(expected));
                None
            }
            None => Some(self),
        }
    }
}

/// An optional key: `None` where it is wrong, not where it is missing.
fn known<T>(table: &Reader, key: &str, value: Option<T>) -> Option<Option<T>> {
    (value.is_some() || !table.has(key)).then_some(value)
}

/// The word of a value.
pub(crate) fn word<T: PartialEq>(words: &[(&'static str, T)], value: &T) -> &'static str {
    words.iter().find(|(_, known)| known == value).map_or("", |(word, _)| word)
}

impl Parameters {
    /// All parameters for the record of a run.
    pub(crate) fn record(&self) -> serde_json::Value {
        let mut record = self.sampling.record();
        let own = [
            ("order", self.order.into()),
            ("spacing_m", self.spacing.into()),
            ("levels", self.level_count().into()),
            ("ranges_m", self.ranges.clone().into()),
            ("tolerance_px", self.tolerance.into()),
            ("morph_percent", self.shares.iter().map(|share| 100.0 * share).collect::<Vec<_>>().into()),
            ("transition", word(&TRANSITIONS, &self.transition).into()),
            ("edges", word(&EDGES, &self.edges).into()),
            ("stitch", word(&STITCHES, &self.stitch).into()),
            ("light", word(&LIGHTS, &self.light).into()),
            ("show", word(&SHOWS, &self.show).into()),
            ("light_level", self.light_level.into()),
            ("percent_bits", self.percent_bits.into()),
            ("slots", word(&SLOTS, &self.slots).into()),
            ("clock", word(&CLOCKS, &self.clock).into()),
            ("boulders", word(&BOULDERS, &self.boulders).into()),
            ("boulder_px", self.boulder_px.into()),
        ];
        own.into_iter().for_each(|(key, value)| record[key] = value);
        record
    }
}
