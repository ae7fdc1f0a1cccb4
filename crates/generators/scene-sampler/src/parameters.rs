//! Run parameters of sampling, the same keys for every generator that draws faces.

use diagnostics::Reader;
use light_points::{Accumulation, Blending, LeastDiameter};
use raster::{Filter, Pattern, Sampling};
use serde_json::{Value, json};
use translucency::Capacity;

/// Run parameters that decide how a scene is sampled.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameters {
    /// Sampling points of a pixel.
    pub pattern: Pattern,
    /// Whether the pattern is turned from pixel to pixel.
    pub rotate: bool,
    /// How sampling points make a pixel.
    pub filter: Filter,
    /// Translucent surfaces that a sampling point keeps; `None` is without limit.
    pub translucent: Option<u32>,
    /// Light points that it keeps; `None` is without limit.
    pub lights: Option<u32>,
    /// Whether both share one stack (EP-0611021, claim 4 read narrowly).
    pub shared_stack: bool,
    /// Least diameter of a light point (pixels).
    pub least_diameter: f64,
    /// Whether a light point's light is divided by what its disc covers.
    pub normalise: bool,
    /// How a light point meets what is behind it.
    pub blending: Blending,
    /// Whether calligraphic points dim those behind them.
    pub veil: Accumulation,
    /// Deviation of the beam's spot (pixels).
    pub spot: f64,
    /// In which order the beam draws its points.
    pub beam_order: BeamOrder,
    /// Which layers the picture shows.
    pub beam_layer: BeamLayer,
}

/// In which order the beam draws its points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BeamOrder {
    /// As they are read out (claim 7).
    NearToFar,
    /// Always the nearest on the screen, so that jumps are short.
    NearestNeighbour,
}

/// Which layers the picture shows: the beam may have a tube of its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BeamLayer {
    /// The raster with the beam's spots over it.
    Both,
    /// The raster without the beam.
    Raster,
    /// The beam's spots over black.
    Beam,
}

impl Default for Parameters {
    /// One light and four translucent surfaces a sampling point: the claims name one light (6); all other figures are chosen.
    fn default() -> Self {
        Self {
            pattern: Pattern::Four,
            rotate: false,
            filter: Filter::Box,
            translucent: Some(4),
            lights: Some(1),
            shared_stack: false,
            least_diameter: LeastDiameter::DEFAULT,
            normalise: true,
            blending: Blending::Hiding,
            veil: Accumulation::Points,
            spot: light_points::Spot::DEFAULT_SIGMA,
            beam_order: BeamOrder::NearToFar,
            beam_layer: BeamLayer::Both,
        }
    }
}

impl Parameters {
    /// The parameters of a generator's table; the default where the table has no key.
    pub fn read(table: &Reader) -> Option<Self> {
        let usual = Self::default();
        let patterns = Pattern::ALL.map(|pattern| (pattern.name(), pattern));
        let pattern = table.one_of("pattern", &patterns).default(usual.pattern);
        let rotate = table.bool("rotate").default(usual.rotate);
        let filters = [("box", Filter::Box), ("tent", Filter::Tent), ("gaussian", Filter::Gaussian)];
        let filter = table.one_of("filter", &filters).default(usual.filter);
        let translucent = capacity(table, "translucent", usual.translucent);
        let lights = capacity(table, "lights", usual.lights);
        let shared_stack = table.bool("shared_stack").default(usual.shared_stack);
        let least_diameter = table
            .f64("least_diameter_px")
            .above(0.0)
            .at_most(100.0)
            .unit("pixels")
            .default(usual.least_diameter);
        let normalise = table.bool("normalise").default(usual.normalise);
        let blendings = [("hiding", Blending::Hiding), ("additive", Blending::Additive)];
        let blending = table.one_of("blending", &blendings).default(usual.blending);
        let veils = [("points", Accumulation::Points), ("stack-only", Accumulation::StackOnly)];
        let veil = table.one_of("veil", &veils).default(usual.veil);
        let spot = table.f64("spot_px").between(0.05, 100.0).unit("pixels").default(usual.spot);
        let orders =
            [("near-to-far", BeamOrder::NearToFar), ("nearest-neighbour", BeamOrder::NearestNeighbour)];
        let beam_order = table.one_of("beam_order", &orders).default(usual.beam_order);
        let layers = [("both", BeamLayer::Both), ("raster", BeamLayer::Raster), ("beam", BeamLayer::Beam)];
        let beam_layer = table.one_of("beam_layer", &layers).default(usual.beam_layer);
        let read = Self {
            pattern: pattern?,
            rotate: rotate?,
            filter: filter?,
            translucent: translucent?,
            lights: lights?,
            shared_stack: shared_stack?,
            least_diameter: least_diameter?,
            normalise: normalise?,
            blending: blending?,
            veil: veil?,
            spot: spot?,
            beam_order: beam_order?,
            beam_layer: beam_layer?,
        };
        read.check(table)
    }

    /// All parameters for the record of a run.
    pub fn record(&self) -> Value {
        json!({
            "pattern": self.pattern.name(),
            "rotate": self.rotate,
            "filter": format!("{:?}", self.filter).to_lowercase(),
            "translucent": self.translucent,
            "lights": self.lights,
            "shared_stack": self.shared_stack,
            "least_diameter_px": self.least_diameter,
            "normalise": self.normalise,
            "blending": format!("{:?}", self.blending).to_lowercase(),
            "veil": format!("{:?}", self.veil).to_lowercase(),
            "spot_px": self.spot,
            "beam_order": format!("{:?}", self.beam_order).to_lowercase(),
            "beam_layer": format!("{:?}", self.beam_layer).to_lowercase(),
        })
    }

    /// What keys ask for together.
    fn check(self, table: &Reader) -> Option<Self> {
        if self.rotate && (self.pattern == Pattern::OffCentre16 || self.filter != Filter::Box) {
            let title = "`rotate` turns a pattern that is centred, under the filter `box`";
            table.report(table.problem("rotate", title).expected("another `pattern`, or `filter = \"box\"`"));
            return None;
        }
        if let Err(error) = LeastDiameter::new(self.least_diameter, &self.sampling()) {
            let problem = table.problem("least_diameter_px", error.to_string());
            table.report(problem.expected("a disc that the pattern cannot miss"));
            return None;
        }
        Some(self)
    }

    /// Sampling points of all pixels.
    pub fn sampling(&self) -> Sampling {
        let straight = || Sampling::new(self.pattern);
        if self.rotate { Sampling::turned(self.pattern).unwrap_or_else(straight) } else { straight() }
    }

    /// Whether a sampling point can run out of slots.
    pub fn has_limited_stacks(&self) -> bool {
        match self.capacity() {
            Capacity::Separate { translucent, lights } => translucent.or(lights).is_some(),
            Capacity::Shared(slots) => slots.is_some(),
        }
    }

    /// Slots of every sampling point.
    pub fn capacity(&self) -> Capacity {
        let Self { translucent, lights, .. } = *self;
        match self.shared_stack {
            true => Capacity::Shared(translucent.zip(lights).map(|(surfaces, lights)| surfaces + lights)),
            false => Capacity::Separate { translucent, lights },
        }
    }
}

/// Most slots that a key asks for. Chosen: more is what "unlimited" is for.
const MOST_SLOTS: i64 = 1000;

/// A number of slots, or -1 for no limit.
fn capacity(table: &Reader, key: &str, usual: Option<u32>) -> Option<Option<u32>> {
    let written = table.i64(key).between(-1, MOST_SLOTS).help("-1 is without limit");
    let slots = written.default(usual.map_or(-1, i64::from))?;
    Some(u32::try_from(slots).ok())
}
