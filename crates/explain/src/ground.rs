//! What a sample of a sweep is: place, registers, and the share of every block.

use landscape::{Landscape, Level};
use serde::Serialize;
use sweep_program::{Colour, SweepProgram};

use crate::column::SweepColumn;
use crate::registers::state_at;

/// A hold register at a sample.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ColourState {
    /// Its colour.
    pub colour: &'static str,
    /// Corner of the region that has this colour: north and east index.
    pub wanted: [i64; 2],
    /// Corner whose words it holds; none if the data bank has not delivered.
    pub held: Option<[i64; 2]>,
    /// Whether these differ.
    pub stale: bool,
    /// What it adds to the height (m); none on the coarse level, whose inner wires are no signals.
    pub height_m: Option<f64>,
}

/// Ground that a pixel shows.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GroundPoint {
    /// Sample of the sweep.
    pub sample: usize,
    /// Its time from the first sample (µs).
    pub time_us: f64,
    /// Ground range (m).
    pub range_m: f64,
    /// Place on the map: north, east (m).
    pub place_m: [f64; 2],
    /// `fine` or `coarse`.
    pub level: &'static str,
    /// Region: north and east index.
    pub region: [i64; 2],
    /// Folded ramps X and Y, 0..=1.
    pub ramps: [f64; 2],
    /// Polarity flip-flops.
    pub polarity: [f64; 2],
    /// Hold registers.
    pub colours: Vec<ColourState>,
    /// Height of the terrain generator (m).
    pub terrain_height_m: f64,
    /// Its slopes to the north and to the east.
    pub terrain_slopes: [f64; 2],
    /// Its reflectivity.
    pub terrain_reflectivity: f64,
    /// Craters whose footprint holds the place, by their number in the list.
    pub craters: Vec<u32>,
    /// What they add (m).
    pub feature_height_m: f64,
    /// Whether VS1 shows features.
    pub features_shown: bool,
    /// Whether the gate of the shadow controller is on.
    pub in_shadow: bool,
    /// What texture adds.
    pub texture: f64,
    /// Composite height (m).
    pub height_m: f64,
    /// Composite reflectivity.
    pub reflectivity: f64,
    /// Tangent of its elevation.
    pub elevation: f64,
    /// Highest tangent so far.
    pub hold: f64,
    /// Line of the beam, from the top of what is written.
    pub line: f64,
    /// Ground ranges (m) of the stretch right behind that this place hides.
    pub hides_m: Option<[f64; 2]>,
}

impl GroundPoint {
    /// The ground at `sample`; `programs` of the fine and of the coarse level, `period_us` of a sample.
    pub(crate) fn at(
        sample: usize,
        column: &SweepColumn,
        programs: &[SweepProgram],
        landscape: &Landscape,
        eye: [f64; 3],
        period_us: f64,
    ) -> Self {
        let of = |name: &str| column.at(name, sample);
        let range_m = of("sweep.range");
        let is_coarse = programs.len() > 1 && range_m > programs[0].end_range;
        let index = usize::from(is_coarse);
        let (program, level) = (&programs[index], &landscape.bank().levels()[index]);
        let [cos, sin] = program.start.direction;
        let place_m = [eye[0] + range_m * cos, eye[1] + range_m * sin];
        let region = level.in_regions(place_m[0], place_m[1]).map(|place| place.floor() as i64);
        let state = state_at(program, sample);
        let inner =
            |colour: Colour| (!is_coarse).then(|| column.at(&format!("tg.{}.height", colour.name()), sample));
        let colours = Colour::ALL.map(|colour| {
            let wanted = wanted(region, colour);
            let held = state.held[colour as usize].map(|corner| place_of(level, corner));
            ColourState {
                colour: colour.name(),
                wanted,
                stale: held != Some(wanted),
                held,
                height_m: inner(colour),
            }
        });
        let hidden = column.hidden_behind(sample);
        Self {
            sample,
            time_us: sample as f64 * period_us,
            range_m,
            place_m,
            level: if is_coarse { "coarse" } else { "fine" },
            region,
            ramps: [of("sweep.x"), of("sweep.y")],
            polarity: state.polarity,
            colours: colours.into(),
            terrain_height_m: of("tg.height"),
            terrain_slopes: [of("tg.slope.u"), of("tg.slope.v")],
            terrain_reflectivity: of("tg.reflectivity"),
            craters: craters_at(landscape, place_m),
            feature_height_m: of("fg.height"),
            features_shown: of("mu.vs1") > 0.5,
            in_shadow: of("sc.gate") > 0.5,
            texture: of("txg.texture"),
            height_m: of("mu.height"),
            reflectivity: of("mu.reflectivity"),
            elevation: of("dpp.elevation"),
            hold: of("dpp.hold"),
            line: of("dpp.y"),
            hides_m: hidden.map(|samples| samples.map(|k| column.at("sweep.range", last_of(column, k)))),
        }
    }
}

fn last_of(column: &SweepColumn, sample: usize) -> usize {
    sample.min(column.all("sweep.range").len().saturating_sub(1))
}

/// The corner of a region that has a colour: parities of its indices are those of the colour.
fn wanted(region: [i64; 2], colour: Colour) -> [i64; 2] {
    let far = [colour.at_far_x(), colour.at_far_y()];
    std::array::from_fn(|axis| {
        let is_odd = region[axis].rem_euclid(2) == 1;
        region[axis] + i64::from(is_odd != far[axis])
    })
}

fn place_of(level: &Level, corner: u32) -> [i64; 2] {
    let (corner, columns) = (corner as usize, level.corners()[1]);
    [(corner / columns) as i64, (corner % columns) as i64]
}

fn craters_at(landscape: &Landscape, [x, y]: [f64; 2]) -> Vec<u32> {
    let mut found = Vec::new();
    landscape.features().in_box([x, y], [x, y], &mut found);
    let craters = landscape.features().craters();
    found.retain(|&index| {
        let crater = &craters[index as usize];
        let [dx, dy] = [x - crater.centre()[0], y - crater.centre()[1]];
        dx * dx + dy * dy < crater.outer() * crater.outer()
    });
    found.sort_unstable();
    found
}

#[cfg(test)]
mod tests {
    use super::wanted;
    use sweep_program::Colour;

    #[test]
    fn the_corners_of_a_region_have_all_colours() {
        for region in [[0, 0], [3, 4], [-1, 2], [-5, -7]] {
            let mut corners = Colour::ALL.map(|colour| wanted(region, colour));
            for (colour, [m, n]) in Colour::ALL.into_iter().zip(corners) {
                assert_eq!(Colour::of_corner(m, n), colour);
            }
            corners.sort_unstable();
            let [k, l] = region;
            assert_eq!(corners, [[k, l], [k, l + 1], [k + 1, l], [k + 1, l + 1]]);
        }
    }
}
