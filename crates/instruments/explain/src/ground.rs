//! What a sample of a sweep is: place, registers, and the share of every block.

use control_plane::RegisterState;
use landscape::{Landscape, Level};
use serde::Serialize;
use sweep_program::Colour;

use crate::column::SweepColumn;

/// A hold register at a sample.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ColourState {
    /// Name of the register's colour.
    pub colour: &'static str,
    /// Corner of the region that has this colour: north and east index.
    pub wanted: [i64; 2],
    /// Corner whose words it holds; none if the data bank has not delivered.
    pub held: Option<[i64; 2]>,
    /// Whether any of the nine words is of another corner.
    pub stale: bool,
    /// Which: orders p and q of the derivatives to the north and to the east.
    pub stale_words: Vec<[usize; 2]>,
    /// What it adds to the height (m).
    pub height_m: f64,
}

/// Ground that a pixel shows.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GroundPoint {
    /// Sample of the sweep.
    pub sample: usize,
    /// Its time from the first sample (µs).
    pub time_us: f64,
    /// Ground range of the sample (m).
    pub range_m: f64,
    /// Place on the map: north, east (m).
    pub place_m: [f64; 2],
    /// Level of terrain: `fine` or `coarse`.
    pub level: &'static str,
    /// Region: north and east index.
    pub region: [i64; 2],
    /// Folded ramps X and Y, 0..=1.
    pub ramps: [f64; 2],
    /// States of the polarity flip-flops of X and Y.
    pub polarity: [f64; 2],
    /// Hold registers, one for each colour.
    pub colours: Vec<ColourState>,
    /// Height of the terrain generator (m).
    pub terrain_height_m: f64,
    /// Its slopes to the north and to the east.
    pub terrain_slopes: [f64; 2],
    /// Reflectivity that the terrain generator puts out.
    pub terrain_reflectivity: f64,
    /// Craters whose footprint holds the place, by their number in the list.
    pub craters: Vec<u32>,
    /// Those of them that the sweep does not know, as their records are in no storage buffer yet.
    pub craters_not_there: Vec<u32>,
    /// Whether the square of regions lacks its boundaries of shadow, as their records are in no storage buffer yet.
    pub shadows_not_there: bool,
    /// What the craters add (m).
    pub feature_height_m: f64,
    /// Whether VS1 shows features.
    pub features_shown: bool,
    /// Whether the gate of the shadow controller is on.
    pub in_shadow: bool,
    /// What craters add to the gain of texture, which is 1 without any.
    pub grain: f64,
    /// Signal of the texture generator at the sample.
    pub texture: f64,
    /// Composite height of terrain and features (m).
    pub height_m: f64,
    /// Composite reflectivity of the ground at the sample.
    pub reflectivity: f64,
    /// Tangent of its elevation.
    pub elevation: f64,
    /// Highest tangent so far.
    pub hold: f64,
    /// Change of its elevation (tangents a microsecond), where occlusion goes by it.
    pub elevation_change: Option<f64>,
    /// What the write beam is driven with.
    pub video: f64,
    /// Line of the beam, from the top of what is written.
    pub line: f64,
    /// Ground ranges (m) of the stretch right behind that this place hides.
    pub hides_m: Option<[f64; 2]>,
}

impl GroundPoint {
    /// The ground at `sample` of a sweep that runs in `direction`; `state` of the registers then, by level; the fine level is
    /// drawn up to `fine_end_m`, and a sample takes `period_us`.
    pub(crate) fn at(
        sample: usize,
        column: &SweepColumn,
        states: &[RegisterState],
        (fine_end_m, direction): (f64, [f64; 2]),
        landscape: &Landscape,
        eye: [f64; 3],
        period_us: f64,
    ) -> Self {
        let of = |name: &str| column.at(name, sample);
        let range_m = of("sweep.range");
        let is_coarse = states.len() > 1 && range_m > fine_end_m;
        let (index, prefix) = if is_coarse { (1, "coarse.") } else { (0, "") };
        let (state, level) = (&states[index], &landscape.bank().levels()[index]);
        let place_m: [f64; 2] = std::array::from_fn(|axis| eye[axis] + range_m * direction[axis]);
        let region = level.in_regions(place_m[0], place_m[1]).map(|place| place.floor() as i64);
        let colours = Colour::ALL.map(|colour| {
            let [hold, ..] = &state.colours[colour as usize];
            ColourState {
                colour: colour.name(),
                wanted: corner_place(level, hold.wanted),
                held: hold.corner().map(|corner| corner_place(level, corner)),
                stale: !hold.stale().is_empty(),
                stale_words: (0..9)
                    .filter(|&word| hold.stale().has(word))
                    .map(|word| [word / 3, word % 3])
                    .collect(),
                height_m: of(&format!("tg.{prefix}{}.height", colour.name())),
            }
        });
        let hidden = column.hidden_behind(sample);
        let ramps = ["x", "y"].map(|axis| of(&format!("sweep.{prefix}{axis}")));
        Self {
            sample,
            time_us: sample as f64 * period_us,
            range_m,
            place_m,
            level: if is_coarse { "coarse" } else { "fine" },
            region,
            ramps,
            polarity: state.polarity,
            colours: colours.into(),
            terrain_height_m: of("tg.height"),
            terrain_slopes: [of("tg.slope.u"), of("tg.slope.v")],
            terrain_reflectivity: of("tg.reflectivity"),
            craters: craters_at(landscape, place_m),
            craters_not_there: Vec::new(),
            shadows_not_there: false,
            feature_height_m: of("fg.height"),
            features_shown: of("mu.vs1") > 0.5,
            in_shadow: of("sc.gate") > 0.5,
            grain: of("fg.grain"),
            texture: of("txg.texture"),
            height_m: of("mu.height"),
            reflectivity: of("mu.reflectivity"),
            elevation: of("dpp.elevation"),
            hold: of("dpp.hold"),
            elevation_change: None,
            video: of("sm.video"),
            line: of("dpp.y"),
            hides_m: hidden.map(|samples| samples.map(|k| column.at("sweep.range", last_of(column, k)))),
        }
    }
}

fn last_of(column: &SweepColumn, sample: usize) -> usize {
    sample.min(column.all("sweep.range").len().saturating_sub(1))
}

/// North and east index of a corner of `level`, from its index in the storage buffer.
pub fn corner_place(level: &Level, corner: u32) -> [i64; 2] {
    let (corner, columns) = (corner as usize, level.corners()[1]);
    [(corner / columns) as i64, (corner % columns) as i64]
}

fn craters_at(landscape: &Landscape, [x, y]: [f64; 2]) -> Vec<u32> {
    let mut found = Vec::new();
    landscape.features().in_box([x, y], [x, y], &mut found);
    found.retain(|&index| {
        let crater = landscape.features().crater(index);
        let [dx, dy] = [x - crater.centre()[0], y - crater.centre()[1]];
        dx * dx + dy * dy < crater.outer() * crater.outer()
    });
    found.sort_unstable();
    found
}
