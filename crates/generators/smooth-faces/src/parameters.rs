//! Run parameters of the generator, as `[faces]` and `--set faces.KEY=VALUE` give them.

use diagnostics::Reader;
use faces::{Animate, Cut, Interpolation, ModelShading, Order, Scan};
use ground_mesh::{FEWEST_CELLS, Rings};
use serde_json::Value;

/// Most cells along half the side of a ring. Chosen: finer ground takes gigabytes, as every triangle is drawn.
const MOST_GROUND_CELLS: u32 = 512;

/// Most channels of one computer (chosen; the study has four).
const MOST_CHANNELS: u32 = 64;

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
    /// What moves a sea: the sun of its list, or the numbers of its normals.
    pub animate: Animate,
    /// Which hulls ships have, and where the sea has its priority.
    pub hull: Hull,
    /// Channels that share the real-time computer, 1 or more: its words go to the image processor of each.
    pub channels: u32,
    /// Whether a picture is as late as the gear makes it.
    pub delayed: bool,
    /// Share of light from everywhere, 0..=1.
    pub ambient: f64,
    /// Rings of the ground; `None` where it is not drawn.
    pub ground: Option<Rings>,
    /// Most faces of a list.
    pub limit: u32,
}

/// Which hulls ships have, and where the sea has its priority.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Hull {
    /// Both are as the scenario has them.
    AsWritten,
    /// The sea has its priority before all other lists (reported as a wrong order).
    SeaFirst,
    /// Every ship has its whole hull in place of what hides it (reported as a wrong model).
    DeepHull,
}

impl Default for Parameters {
    /// Screen-linear brightness, the vertical scan and a sea that its sun moves are reported.
    fn default() -> Self {
        Self {
            order: Order::Depth,
            interpolation: Interpolation::Screen,
            shading: ModelShading::Smooth,
            cut: Cut::Fan,
            scan: Scan::Vertical,
            animate: Animate::Sun,
            hull: Hull::AsWritten,
            channels: 1,
            delayed: false,
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
const HULLS: [(&str, Hull); 3] =
    [("as-written", Hull::AsWritten), ("sea-first", Hull::SeaFirst), ("deep-hull", Hull::DeepHull)];

impl Parameters {
    /// The parameters of a `[faces]` table; the default where the table has no key.
    pub(crate) fn read(table: &Reader) -> Option<Self> {
        let usual = Self::default();
        let order = table.one_of("order", &ORDERS).default(usual.order);
        let interpolation = table.one_of("interpolation", &INTERPOLATIONS).default(usual.interpolation);
        let shading = table.one_of("shading", &SHADINGS).default(usual.shading);
        let cut = table.bool("cut").default(true);
        let scan = table.one_of("scan", &SCANS).default(usual.scan);
        let animate = table.one_of("animate", &ANIMATES).default(usual.animate);
        let hull = table.one_of("hull", &HULLS).default(usual.hull);
        let channels = table.u32("channels").between(1, MOST_CHANNELS).default(usual.channels);
        let delayed = table.bool("delayed").default(usual.delayed);
        let ambient = table.f64("ambient").between(0.0, 1.0).default(usual.ambient);
        let ground = ground(table);
        let limit = table.u32("limit").between(1, 10_000_000).default(usual.limit);
        Some(Self {
            order: order?,
            interpolation: interpolation?,
            shading: shading?,
            cut: if cut? { Cut::Fan } else { Cut::Uncut },
            scan: scan?,
            animate: animate?,
            hull: hull?,
            channels: channels?,
            delayed: delayed?,
            ambient: ambient?,
            ground: ground?,
            limit: limit?,
        })
    }

    /// Axis of the screen that scan lines lie across.
    pub(crate) fn across(&self) -> usize {
        match self.scan {
            Scan::Vertical => 0,
            Scan::Horizontal => 1,
        }
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
            "animate": word(&ANIMATES, &self.animate),
            "hull": word(&HULLS, &self.hull),
            "channels": self.channels,
            "delayed": self.delayed,
            "ambient": self.ambient,
            "ground": self.ground.is_some(),
            "ground_cells": rings.cells,
            "ground_half_side_m": rings.half_side,
            "limit": self.limit,
        })
    }
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
