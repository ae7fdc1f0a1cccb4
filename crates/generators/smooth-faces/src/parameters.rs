//! Run parameters of the generator, as `[faces]` and `--set faces.KEY=VALUE` give them.

use diagnostics::Reader;
use faces::{Animate, Cut, Interpolation, ModelShading, Order, Scan};
use ground_mesh::{FEWEST_CELLS, Rings};
use serde_json::Value;

/// Most cells along half the side of a ring. Chosen: finer ground takes gigabytes, as every triangle is drawn.
const MOST_GROUND_CELLS: u32 = 512;

/// Run parameters that decide its pictures.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameters {
    /// Which face wins a sample.
    pub order: Order,
    /// Where brightness runs linearly.
    pub interpolation: Interpolation,
    /// How bodies and ground are shaded; flat makes all lists flat.
    pub shading: ModelShading,
    /// Whether faces are cut in triangles.
    pub cut: Cut,
    /// Direction of scan lines.
    pub scan: Scan,
    /// What moves a sea, and how fast.
    pub animation: Animation,
    /// Pieces that a scan line holds; `None` is without limit.
    pub edges_line: Option<u32>,
    /// Share of light from everywhere, 0..=1.
    pub ambient: f64,
    /// Rings of the ground; `None` where it is not drawn.
    pub ground: Option<Rings>,
    /// Most faces of a list.
    pub limit: u32,
}

/// What moves a sea, and the time that it takes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Animation {
    /// The sun of the list, or the numbers of its normals.
    pub by: Animate,
    /// Time of a frame that the real-time computer has for normals (us).
    pub spare_us: f64,
    /// Its time for one normal (us).
    pub normal_us: f64,
}

impl Animation {
    /// The frame whose normals a sea of so many vertices shows in `frame`: the last one that was wholly written.
    pub fn shown(&self, frame: u64, vertices: u64) -> u64 {
        let every = (vertices as f64 * self.normal_us / self.spare_us).ceil().max(1.0) as u64;
        frame / every * every
    }
}

impl Default for Parameters {
    /// Spare time and time of a normal are chosen by the specification; screen-linear brightness and the vertical scan are reported.
    fn default() -> Self {
        Self {
            order: Order::Depth,
            interpolation: Interpolation::Screen,
            shading: ModelShading::Smooth,
            cut: Cut::Fan,
            scan: Scan::Vertical,
            animation: Animation { by: Animate::Sun, spare_us: 5000.0, normal_us: 15.0 },
            edges_line: None,
            ambient: 0.0,
            ground: Some(Rings { half_side: 32.0, cells: 64 }),
            limit: 200_000,
        }
    }
}

/// Words of the keys, with what they mean.
const ORDERS: [(&str, Order); 2] = [("depth", Order::Depth), ("lists", Order::Lists)];
const INTERPOLATIONS: [(&str, Interpolation); 2] =
    [("screen", Interpolation::Screen), ("perspective", Interpolation::Perspective)];
const SHADINGS: [(&str, ModelShading); 3] =
    [("smooth", ModelShading::Smooth), ("as-written", ModelShading::AsWritten), ("flat", ModelShading::Flat)];
const SCANS: [(&str, Scan); 2] = [("vertical", Scan::Vertical), ("horizontal", Scan::Horizontal)];
const ANIMATES: [(&str, Animate); 2] = [("sun", Animate::Sun), ("normals", Animate::Normals)];

impl Parameters {
    /// The parameters of a `[faces]` table; the default where the table has no key.
    pub(crate) fn read(table: &Reader) -> Option<Self> {
        let usual = Self::default();
        let order = table.one_of("order", &ORDERS).default(usual.order);
        let interpolation = table.one_of("interpolation", &INTERPOLATIONS).default(usual.interpolation);
        let shading = table.one_of("shading", &SHADINGS).default(usual.shading);
        let cut = table.bool("cut").default(true);
        let scan = table.one_of("scan", &SCANS).default(usual.scan);
        let animation = animation(table, usual.animation);
        let edges_line = table.u32("edges_line").at_most(1_000_000).default(0);
        let ambient = table.f64("ambient").between(0.0, 1.0).default(usual.ambient);
        let ground = ground(table);
        let limit = table.u32("limit").between(1, 10_000_000).default(usual.limit);
        Some(Self {
            order: order?,
            interpolation: interpolation?,
            shading: shading?,
            cut: if cut? { Cut::Fan } else { Cut::Uncut },
            scan: scan?,
            animation: animation?,
            edges_line: Some(edges_line?).filter(|slots| *slots > 0),
            ambient: ambient?,
            ground: ground?,
            limit: limit?,
        })
    }

    /// All parameters for the record of a run.
    pub(crate) fn record(&self) -> Value {
        let rings = self.ground.unwrap_or(Rings { half_side: 0.0, cells: 0 });
        serde_json::json!({
            "order": word(&ORDERS, &self.order),
            "interpolation": word(&INTERPOLATIONS, &self.interpolation),
            "shading": word(&SHADINGS, &self.shading),
            "cut": self.cut == Cut::Fan,
            "scan": word(&SCANS, &self.scan),
            "animate": word(&ANIMATES, &self.animation.by),
            "spare_us": self.animation.spare_us,
            "normal_us": self.animation.normal_us,
            "edges_line": self.edges_line.unwrap_or(0),
            "ambient": self.ambient,
            "ground": self.ground.is_some(),
            "ground_cells": rings.cells,
            "ground_half_side_m": rings.half_side,
            "limit": self.limit,
        })
    }
}

fn animation(table: &Reader, usual: Animation) -> Option<Animation> {
    let by = table.one_of("animate", &ANIMATES).default(usual.by);
    let spare = table.f64("spare_us").between(1.0, 1e6).unit("us").default(usual.spare_us);
    let normal = table.f64("normal_us").between(0.001, 1e6).unit("us").default(usual.normal_us);
    Some(Animation { by: by?, spare_us: spare?, normal_us: normal? })
}

/// Rings of the ground, where it is drawn.
fn ground(table: &Reader) -> Option<Option<Rings>> {
    let is_drawn = table.bool("ground").default(true);
    let rule = "a multiple of 4";
    let cells = table.u32("ground_cells").between(FEWEST_CELLS, MOST_GROUND_CELLS);
    let cells = cells.must(rule, |cells| cells.is_multiple_of(4)).default(64);
    let half_side = table.f64("ground_half_side_m").between(0.1, 1e5).unit("m").default(32.0);
    let rings = Rings { half_side: half_side?, cells: cells? };
    Some(is_drawn?.then_some(rings))
}

/// The word of a value.
pub(crate) fn word<T: PartialEq>(words: &[(&'static str, T)], value: &T) -> &'static str {
    words.iter().find(|(_, known)| known == value).map_or("", |(word, _)| word)
}
