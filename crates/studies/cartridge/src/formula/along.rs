//! Quantities at every sample of a sweep.

use landscape::LUNOID_RADIUS;
use parts::Spread;
use serde::Deserialize;

use super::basis::hermite;
use super::light::lambert;
use super::response::two_pole_ramp;
use crate::scene::ground::CartridgeGround;
use crate::scene::machine::MachineCase;

/// A quantity at every place of a sweep.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum Along {
    /// The number 0 at every place.
    Nothing,
    /// Height of the terrain (m): a plane or polynomial as written, else the sum over the region's four corners of words
    /// times `g_ip(u) g_jq(v)`.
    GroundHeight,
    /// Its slope to the north.
    GroundSlopeNorth,
    /// Its slope to the east.
    GroundSlopeEast,
    /// Albedo times Lambert's factor of the terrain's slopes.
    GroundLight,
    /// Height of the craters alone (m): `a (rho^2 / r^2 - 1)` within r of the middle, 0 outside.
    CraterHeight,
    /// Tangent of the elevation of flat ground on the lunoid: `-(H + z^2 / 2R) / z`.
    LunoidTangent,
    /// Height of the terrain where a smoother has the ramp of the north axis (m): its delay of a ramp is made up for, and at
    /// each fold two poles answer to a ramp of twice the slope. Registers change at the place of the fold itself.
    SmoothedHeight,
    /// Height of the terrain as its mirror image in the first row ahead has it, from there on (m).
    MirroredHeight,
    /// Height of the terrain while the register of one corner holds another's words between two ground ranges (m).
    LateWords {
        /// The corner, to the north and to the east.
        corner: [usize; 2],
        /// The corner whose words are there.
        stale: [usize; 2],
        /// From this ground range on, the stop that transfers them (m).
        from_m: f64,
        /// Up to this ground range, at which the right ones come (m).
        until_m: f64,
    },
    /// Height of level ground behind D/A multipliers with gain errors: `h (1 + sum of gain errors times weights)`, less the
    /// same error at the eye's foot, where the datum is trimmed (m).
    GainErrors,
}

impl Along {
    /// Value at ground range `range` (m) in a direction (north, east), which leads to `place` (m).
    pub fn at(&self, of: &MachineCase, range: f64, direction: [f64; 2]) -> f64 {
        let place = of.place(direction, range);
        let [height, north, east] = of.surface(place);
        match self {
            Self::Nothing => 0.0,
            Self::GroundHeight => height,
            Self::GroundSlopeNorth => north,
            Self::GroundSlopeEast => east,
            Self::GroundLight => lambert(&of.scene, [north, east]),
            Self::CraterHeight => craters(of, place),
            Self::LunoidTangent => {
                -(of.scene.eye_m[2] - height + range * range / (2.0 * LUNOID_RADIUS)) / range
            }
            Self::SmoothedHeight => of.surface([smoothed(of, range, direction[0]), place[1]])[0],
            Self::MirroredHeight => mirrored(of, place),
            Self::LateWords { corner, stale, from_m, until_m } => {
                let is_stale = (*from_m..*until_m).contains(&range);
                height + if is_stale { exchanged(of, place, *corner, *stale) } else { 0.0 }
            }
            Self::GainErrors => {
                let foot = of.place(direction, 0.0);
                height * (1.0 + gain_error(of, place)) - of.surface(foot)[0] * gain_error(of, foot)
            }
        }
    }

    /// Full scale that does not depend on the sweep: a single word's own size.
    pub fn full_scale(&self, of: &MachineCase) -> Option<f64> {
        match (self, &of.ground) {
            (Self::Nothing, _) => Some(1.0),
            (_, CartridgeGround::OneWord { value_m, .. }) => Some(value_m.abs()),
            _ => None,
        }
    }
}

fn craters(of: &MachineCase, [x, y]: [f64; 2]) -> f64 {
    let one = |bowl: &crate::scene::machine::Bowl| {
        let [dx, dy] = [x - bowl.centre_m[0], y - bowl.centre_m[1]];
        bowl.depth_m * ((dx * dx + dy * dy) / (bowl.radius_m * bowl.radius_m) - 1.0).min(0.0)
    };
    of.scene.craters.iter().map(one).sum()
}

/// A place (regions) folded into 0..=1: forwards in even regions, backwards in odd ones.
fn folded(place: f64) -> f64 {
    let over = place.rem_euclid(2.0);
    if over < 1.0 { over } else { 2.0 - over }
}

/// No sweep crosses more lines (regions).
const FARTHEST: f64 = 4096.0;

/// Folds so far back have died out (time constants of the smoother).
const FORGOTTEN: f64 = 60.0;

/// Place to the north (m) that the smoothed ramp stands for. At a constant rate the ramp runs `v` regions a second; it is
/// ahead by the smoother's delay `2 z / w`, so where nothing folds it is where it should be. What a fold does to the smoothed
/// ramp, less what it does to the sharp one, is off.
fn smoothed(of: &MachineCase, range: f64, north: f64) -> f64 {
    let (programme, raster, size) = (of.settings.range, of.settings.raster, of.scene.region_size_m);
    let rate = north * programme.end / f64::from(raster.samples) / of.sample_time() / size;
    let place = (of.scene.eye_m[0] + range * north) / size;
    let (w, z) = (1.0 / of.model.analog.sweep.smoother, hardware_model::SMOOTHER_DAMPING);
    let delay = 2.0 * z / w;
    // Where the accumulator is, and how far back its folds are not forgotten.
    let back = (rate * FORGOTTEN / w).clamp(-FARTHEST, FARTHEST);
    let (now, oldest) = (place + (rate * delay).clamp(-FARTHEST, FARTHEST), place - back);
    let lines = (oldest.min(now).ceil() as i64)..=(oldest.max(now).floor() as i64);
    let off = lines.map(|line| {
        let since = (now - line as f64) / rate;
        // Behind an even line the ramp rises, behind an odd one it falls.
        let turn = if line.rem_euclid(2) == 0 { 2.0 } else { -2.0 };
        turn * rate.abs() * (two_pole_ramp(w, z, since) - (since - delay).max(0.0))
    });
    let off: f64 = off.sum();
    // In even regions the ground runs with the ramp, in odd ones against it.
    let with = if (place.floor() as i64).rem_euclid(2) == 0 { 1.0 } else { -1.0 };
    (place + with * off) * size
}

/// Beyond the first row ahead the ground runs backwards, and forwards again beyond the row before it.
fn mirrored(of: &MachineCase, [x, y]: [f64; 2]) -> f64 {
    let size = of.scene.region_size_m;
    let first = (of.scene.eye_m[0] / size).ceil();
    let seen = if x / size > first { (first - folded(x / size - first)) * size } else { x };
    of.surface([seen, y])[0]
}

/// What the height is off by while `corner` has the words of `stale`: each word's difference times its weight.
fn exchanged(of: &MachineCase, place: [f64; 2], corner: [usize; 2], stale: [usize; 2]) -> f64 {
    let size = of.scene.region_size_m;
    let [right, wrong] = [corner, stale].map(|corner| of.ground.words(corner, size));
    let [u, v] = [0, 1].map(|axis| place[axis] / size - corner[axis] as f64);
    let weight = |word: usize| hermite(word / 3, u)[0] * hermite(word % 3, v)[0];
    (0..9).map(|word| (wrong[word] - right[word]) * weight(word)).sum()
}

/// Gain errors of the four D/A multipliers of heights, each times its weight. The converter of the ramps' ends a and b
/// has the number `6 (3 a) + 3 b` of the lot; end 0 is that of even lines, where the ramp is 0 (fig. 19).
fn gain_error(of: &MachineCase, place: [f64; 2]) -> f64 {
    let (spread, sigma) = (Spread::new(of.model.seed), of.model.analog.multiplying_dac.gain_error);
    let ramp = place.map(|along| folded(along / of.scene.region_size_m));
    let weight = |end: usize, ramp: f64| hermite(0, if end == 0 { ramp } else { 1.0 - ramp })[0];
    let mut sum = 0.0;
    for (a, b) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
        let term = (18 * a + 3 * b) as u64;
        sum += spread.error("tg.mdac.gain", term, sigma) * weight(a, ramp[0]) * weight(b, ramp[1]);
    }
    sum
}
