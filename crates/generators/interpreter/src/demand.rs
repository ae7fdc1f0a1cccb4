//! Corners that a frame asks its storage buffer for (hardware section 4.7; sheet of the data bank).

use scenario::Pose;

use crate::clock::starts;
use crate::fan::{direction, tangent};
use crate::scene::SceneData;

/// What rounding may take from a sweep along a boundary of regions.
const ROUNDING: f64 = 1e-9;

/// The corners of level `number` that frame `frame` can meet, the nearest to the eye's foot first.
pub fn demand(scene: &SceneData<'_>, number: usize, frame: u64) -> Vec<[i64; 2]> {
    let at = |frame: u64| scene.course.get((frame as usize).min(scene.course.len().saturating_sub(1)));
    let Some(now) = at(frame) else { return Vec::new() };
    let before = at(frame.saturating_sub(1)).unwrap_or(now);
    let edges = edges(scene, now, margin(scene, frame, [before, now]));
    let level = &scene.landscape.bank().levels()[number];
    let foot: [f64; 2] =
        std::array::from_fn(|axis| (now.eye[axis] - level.origin()[axis]) / level.region_size());
    let settings = scene.settings;
    let far = scene
        .switch(frame, now.attitude.heading)
        .filter(|_| number == 0)
        .map_or(f64::INFINITY, |switch| switch.range);
    let reach = far.min(settings.range.end) / level.region_size();
    let [north, east] = level.corners().map(|corners| corners as i64);
    let mut corners = Vec::new();
    for region in (0..north - 1).flat_map(|m| (0..east - 1).map(move |n| [m, n])) {
        if touches(region, foot, edges, reach) {
            corners.extend(corners_of(region));
        }
    }
    let distance = |corner: &[i64; 2]| {
        let [m, n] = [corner[0] as f64 - foot[0], corner[1] as f64 - foot[1]];
        m * m + n * n
    };
    corners.sort_by(|a, b| distance(a).total_cmp(&distance(b)).then(a.cmp(b)));
    corners.dedup();
    corners
}

fn corners_of([m, n]: [i64; 2]) -> [[i64; 2]; 4] {
    [[m, n], [m, n + 1], [m + 1, n], [m + 1, n + 1]]
}

/// How far the view can turn until a drum has come round once and a half (rad).
fn margin(scene: &SceneData<'_>, frame: u64, [before, now]: [&Pose; 2]) -> f64 {
    let whole = 2.0 * std::f64::consts::PI;
    let turned = (now.attitude.heading - before.attitude.heading).rem_euclid(whole);
    let starts = starts(scene, frame);
    let ticks = starts[starts.len() - 1] - starts[0];
    let rotation = scene.settings.data_banks.drum.map_or(0, |drum| drum.rotation);
    turned.min(whole - turned) * (1.5 * rotation as f64 / ticks as f64).ceil()
}

/// Directions of the left and of the right edge of what is asked for; none where that goes all around.
fn edges(scene: &SceneData<'_>, pose: &Pose, margin: f64) -> Option<[[f64; 2]; 2]> {
    let seen =
        SceneData { eye: pose.eye, heading: pose.attitude.heading, pitch: pose.attitude.pitch, ..*scene };
    let ends = [0, seen.settings.raster.sweeps - 1];
    let [left, right] = ends.map(|sweep| libm::atan(tangent(&seen, sweep)));
    if right - left + 2.0 * margin >= std::f64::consts::PI {
        return None;
    }
    let beside = |sweep: u32, angle: f64| {
        let ([north, east], (sin, cos)) = (direction(&seen, sweep), (libm::sin(angle), libm::cos(angle)));
        [cos * north - sin * east, sin * north + cos * east]
    };
    Some([beside(ends[0], -margin), beside(ends[1], margin)])
}

/// Whether a region has a corner to the right of the left edge, one to the left of the right edge, and a place within reach.
fn touches(region: [i64; 2], foot: [f64; 2], edges: Option<[[f64; 2]; 2]>, reach: f64) -> bool {
    let from_foot = corners_of(region).map(|corner| [corner[0] as f64 - foot[0], corner[1] as f64 - foot[1]]);
    let to_the_right = |of: [f64; 2], place: [f64; 2]| of[0] * place[1] - of[1] * place[0];
    let is_between = edges.is_none_or(|[left, right]| {
        from_foot.iter().any(|&corner| to_the_right(left, corner) >= -ROUNDING)
            && from_foot.iter().any(|&corner| to_the_right(right, corner) <= ROUNDING)
    });
    let nearest: [f64; 2] = std::array::from_fn(|axis| 0.0f64.clamp(from_foot[0][axis], from_foot[3][axis]));
    is_between && nearest[0] * nearest[0] + nearest[1] * nearest[1] <= reach * reach + ROUNDING
}
