//! One sweep, in the order of section 24.

use std::collections::BTreeMap;

use crate::craters::Met;
use crate::event::Event;
use crate::fan::direction;
use crate::given::Given;
use crate::levels::{GroundSample, Terrain, terrain};
use crate::light::Light;
use crate::loads::{DrawnCrater, Loads, Passing, craters};
use crate::output_amplifiers::OutputAmplifiers;
use crate::parts::Array;
use crate::scene::SceneData;
use crate::shadows::segments;
use crate::wires;
use landscape::Level;

/// What one sweep gave, up to the last sample within the stored ground.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Record {
    /// Signals by the name that the machine gives them.
    pub signals: BTreeMap<String, Vec<f64>>,
    /// How near each sample of a signal is to a threshold that decides it, in the unit of the signal that is compared
    /// there or as a share of a radius; signals that nothing decides are not here.
    pub margins: BTreeMap<String, Vec<f64>>,
    /// Event lists of both levels, and loads of craters and of shadow boundaries.
    pub events: Vec<Event>,
    /// The last tick of each level's walk: later events are nobody's.
    pub last_ticks: [i64; 2],
    /// Ticks, by level, in which rounding says when a stop is seen.
    pub undecided: [Vec<i64>; 2],
    /// Whether rounding says which tick sees a load of a crater or of a shadow boundary.
    pub loads_undecided: bool,
    /// Instants of the stops of the fine level, in accumulator steps from the first sample, with axis (0 is X).
    pub stops: Vec<(f64, usize)>,
    /// Distance of the accumulators of either level from another word of their converters (full scales), by sample: the least within
    /// the memory of the parts.
    pub stairs: Vec<f64>,
    /// When the comparator behind each line generator answers (steps), edge by edge of the given gate of shadow; none for an edge before
    /// the first sample or behind the last.
    pub shadow_answers: Vec<Option<f64>>,
    /// Samples within the stored ground.
    pub samples: usize,
    /// Whether the sweep left the stored ground before its end.
    pub left_the_area: bool,
    /// Whether it met a crater or an edge of shadow: what main signals with amplifiers do there it does not know.
    pub has_breaks: bool,
}

impl Record {
    pub(crate) fn put(&mut self, name: &str, value: f64) {
        append(&mut self.signals, name, value);
    }

    pub(crate) fn put_margin(&mut self, name: &str, value: f64) {
        append(&mut self.margins, name, value);
    }
}

/// Adds a value to the list of this name. A name is copied once.
fn append(lists: &mut BTreeMap<String, Vec<f64>>, name: &str, value: f64) {
    match lists.get_mut(name) {
        Some(list) => list.push(value),
        None => drop(lists.insert(name.to_owned(), vec![value])),
    }
}

/// Walks sweep `sweep` step by step.
pub fn interpret(scene: &SceneData<'_>, sweep: u32, given: &Given<'_>) -> Record {
    let set_up = given.frame.set_ups[sweep as usize];
    let direction = direction(scene, set_up);
    let mut terrain = terrain(scene, sweep, direction, given);
    let passing = Passing { sweep, direction, ranges: given.ranges, end: terrain.end(scene) };
    let craters = craters(scene, &passing, &given.frame.absent_features);
    let wires = OutputAmplifiers::of(scene, given);
    let mut walker = Walker {
        scene,
        given,
        sweep,
        set_up,
        direction,
        wires,
        light: Light::of(scene, direction),
        craters: met(scene, &craters.drawn),
        record: Record::default(),
    };
    walker.array(&terrain);
    drive(&wires, &mut terrain.ground);
    let composite = walker.landscape(&terrain.ground, &craters);
    walker.project(&terrain.ground, &composite);
    // The gate of another sweep's set-up comes with the times of that sweep.
    let lines = if set_up == sweep { given.lines } else { &[] };
    walker.finish(terrain, [craters, segments(scene, &passing, lines)])
}

/// The array of real parts of a level (0 fine, 1 coarse) as sweep `sweep` drives it; none where the level or its parts are not there.
pub fn array(scene: &SceneData<'_>, sweep: u32, given: &Given<'_>, level: usize) -> Option<Array> {
    let direction = direction(scene, given.frame.set_ups[sweep as usize]);
    let Terrain { fine, coarse, .. } = terrain(scene, sweep, direction, given);
    [Some(fine), coarse].into_iter().nth(level)??.array
}

/// Height and slopes of the terrain behind their amplifiers.
fn drive(wires: &OutputAmplifiers<'_>, ground: &mut [GroundSample]) {
    let pass =
        |name: &str, value: fn(&GroundSample) -> f64| wires.pass(name, ground.iter().map(value).collect());
    let heights = pass("tg.height", |ground| ground.height);
    let north = pass("tg.slope.u", |ground| ground.slopes[0]);
    let east = pass("tg.slope.v", |ground| ground.slopes[1]);
    for (k, ground) in ground.iter_mut().enumerate() {
        *ground = GroundSample { height: heights[k], slopes: [north[k], east[k]] };
    }
}

/// Craters that the sweep draws, in the order of the list.
pub(crate) fn met(scene: &SceneData<'_>, craters: &[DrawnCrater]) -> Vec<Met> {
    let all = scene.landscape.features();
    craters.iter().map(|drawn| Met { crater: all.crater(drawn.crater), from: drawn.from }).collect()
}

/// A sweep on its way from block to block.
pub(crate) struct Walker<'a> {
    pub scene: &'a SceneData<'a>,
    pub given: &'a Given<'a>,
    /// Number of the sweep.
    pub sweep: u32,
    /// The sweep whose set-up this one is drawn with.
    pub set_up: u32,
    pub direction: [f64; 2],
    pub wires: OutputAmplifiers<'a>,
    pub light: Light,
    pub craters: Vec<Met>,
    pub record: Record,
}

impl Walker<'_> {
    /// Signals of the arrays.
    fn array(&mut self, terrain: &Terrain) {
        let coarse = terrain.coarse.iter().map(|walk| ("coarse.", walk, self.scene.coarse()));
        let levels: Vec<_> =
            [("", &terrain.fine, Some(self.scene.fine()))].into_iter().chain(coarse).collect();
        for (name, walk, level) in levels {
            let region_size = level.map_or(1.0, Level::region_size);
            self.record.signals.extend(wires::of(name, &walk.samples, region_size));
            let stairs = &mut self.record.stairs;
            stairs.resize(stairs.len().max(walk.samples.len()), f64::INFINITY);
            stairs
                .iter_mut()
                .zip(&walk.samples)
                .for_each(|(least, sample)| *least = least.min(sample.stairs));
        }
    }

    fn finish(mut self, terrain: Terrain, loads: [Loads; 2]) -> Record {
        let Terrain { fine, coarse, ground } = terrain;
        self.record.has_breaks = !self.craters.is_empty() || self.given.shadow.iter().any(|gate| *gate > 0.5);
        self.record.samples = ground.len();
        self.record.left_the_area = ground.len() < self.given.ranges.len();
        self.record.stops = fine.stops;
        self.record.last_ticks = [fine.last_tick, coarse.as_ref().map_or(i64::MIN, |walk| walk.last_tick)];
        self.record.undecided =
            [fine.undecided, coarse.as_ref().map_or(vec![], |walk| walk.undecided.clone())];
        self.record.loads_undecided = loads.iter().any(|loads| loads.undecided);
        let [craters, segments] = loads.map(|loads| loads.events);
        let coarse = coarse.map_or(vec![], |walk| walk.events);
        self.record.events = [fine.events, coarse, craters, segments].concat();
        self.record
    }
}
