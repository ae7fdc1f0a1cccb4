//! Words of shadow boundaries on their way to the line generators (section 11; hardware section 3.7).

use hardware_model::ShadowParts;

use crate::clock::starts;
use crate::event::Part;
use crate::loads::{Line, Loads, Passing, Request};
use crate::scene::SceneData;

/// Words of a boundary.
const SEGMENT_WORDS: f64 = 4.0;

/// Two changes of the gate nearer than this are none (m).
const RESOLUTION: f64 = 1e-6;

/// A line of shadow on the ground.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShadowLine {
    /// From, to (north, east; m), shadow to the right.
    pub ends: [[f64; 2]; 2],
    /// From which tick on the storage buffer has it; none if it has not in this frame.
    pub there_from: Option<i64>,
}

/// Where the sweep crosses a line of shadow.
#[derive(Debug, Clone, Copy)]
struct Crossing {
    /// Ground range of the crossing (m).
    range: f64,
    /// 1 where a shadow begins, -1 where one ends.
    step: i32,
    /// Ground ranges between which the sweep is beside the line (m).
    beside: [f64; 2],
}

/// Loads of the boundaries that the sweep crosses; none in a scan converter, which takes them all with its map.
pub fn segments(scene: &SceneData<'_>, passing: &Passing<'_>, lines: &[ShadowLine]) -> Loads {
    let settings = scene.settings;
    let (Some(fineness), ShadowParts::Digital { line_generators }) =
        (settings.shadows, settings.shadow_controller)
    else {
        return Loads::default();
    };
    let reach = fineness.reach.unwrap_or(settings.range.end).min(settings.range.end);
    let begins = starts(scene, scene.frame)[passing.sweep as usize];
    let is_there = |line: &&ShadowLine| line.there_from.is_some_and(|tick| tick <= begins);
    let lines: Vec<ShadowLine> = lines.iter().filter(is_there).copied().collect();
    let mut boundaries = boundaries(scene, passing.direction, &lines, reach);
    boundaries.sort_by(|a, b| a.beside[0].total_cmp(&b.beside[0]).then(a.range.total_cmp(&b.range)));
    let request = |Crossing { range, beside, .. }: Crossing| Request {
        part: Part::Segment { line_generator: None },
        pool: 0,
        taken: beside,
        due: range,
        end: beside[1].min(reach),
        not_before: None,
    };
    let requests: Vec<Request> = boundaries.into_iter().map(request).collect();
    Line::new(scene, passing, SEGMENT_WORDS, settings.segment_words).serve(&requests, line_generators)
}

/// Where the sweep changes between light and shadow: of shadows that overlap only the outermost edges.
fn boundaries(scene: &SceneData<'_>, direction: [f64; 2], lines: &[ShadowLine], reach: f64) -> Vec<Crossing> {
    let mut crossings: Vec<Crossing> =
        lines.iter().filter_map(|line| crossing(scene, direction, line)).collect();
    crossings.sort_by(|a, b| a.range.total_cmp(&b.range).then(b.step.cmp(&a.step)));
    // Beyond the last line there is no shadow.
    let mut depth = -crossings.iter().map(|crossing| crossing.step).sum::<i32>();
    let mut changes: Vec<Crossing> = Vec::new();
    for crossing in crossings.into_iter().filter(|crossing| crossing.range <= reach) {
        let before = depth;
        depth += crossing.step;
        if (before > 0) == (depth > 0) {
            continue;
        }
        match changes.last() {
            Some(last) if crossing.range - last.range < RESOLUTION => drop(changes.pop()),
            _ => changes.push(crossing),
        }
    }
    changes
}

/// Where the sweep crosses a line, if it does ahead of the eye.
fn crossing(scene: &SceneData<'_>, [cos, sin]: [f64; 2], line: &ShadowLine) -> Option<Crossing> {
    let [from, to] = line.ends.map(|[north, east]| [north - scene.eye[0], east - scene.eye[1]]);
    let [a, b] = [from, to].map(|[north, east]| cos * east - sin * north);
    if (a < 0.0) == (b < 0.0) {
        return None;
    }
    let [near, far] = [from, to].map(|[north, east]| north * cos + east * sin);
    let range = (a * far - b * near) / (a - b);
    // A line generator compares along the axis on which the line is longer.
    let extent = [0, 1].map(|axis| (to[axis] - from[axis]).abs());
    let axis = usize::from(extent[1] > extent[0]);
    let rate = [cos, sin][axis];
    let [first, last] = [from, to].map(|end| end[axis] / rate);
    let beside = if rate == 0.0 { [0.0, f64::INFINITY] } else { [first.min(last).max(0.0), first.max(last)] };
    (range > 0.0).then_some(Crossing { range, step: if a < 0.0 { -1 } else { 1 }, beside })
}
