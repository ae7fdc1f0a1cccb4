//! The report's law: the ground is flat and level, so the shadow is one projection of the string (19.3 to 19.5).

use glam::{DVec2, DVec3};

use crate::function::CharacteristicFunction;
use crate::gate::{Gate, Gates};
use crate::hull::hull;
use crate::outline::outlines;
use crate::shot::middle;
use crate::view_lines::{LineCounts, view_lines};
use crate::{Chain, Shot};

/// How a vehicle of several convex figures becomes outlines.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OutlineRule {
    /// Each figure by itself; a line is dark where it is inside any.
    Parts,
    /// The report's walk around all of them; holes are lost.
    Walk,
}

/// Outlines of the vehicle's shadow on the view-plane at distance 1, and what the lines of the string were.
pub fn shadow_outlines(
    function: &CharacteristicFunction,
    shot: &Shot,
    to_sun: DVec3,
    rule: OutlineRule,
) -> (Vec<Vec<DVec2>>, LineCounts) {
    let (ends, counts) = view_lines(function, &Chain::new(shot, to_sun), shot.view_distance());
    let figures: Vec<Vec<DVec2>> =
        ends.into_iter().filter_map(hull).filter(|figure| is_seen(figure, shot)).collect();
    let found = match rule {
        OutlineRule::Parts => figures,
        OutlineRule::Walk => outlines(&figures),
    };
    (found, counts)
}

/// Whether a figure may reach into the picture: its box does.
fn is_seen(figure: &[DVec2], shot: &Shot) -> bool {
    let half = DVec2::new(shot.field.tan_half_width, shot.field.tan_half_height);
    let low = figure.iter().copied().fold(DVec2::INFINITY, DVec2::min);
    let high = figure.iter().copied().fold(DVec2::NEG_INFINITY, DVec2::max);
    low.cmplt(half).all() && high.cmpgt(-half).all()
}

/// Where each of `lines` lines of the picture is dark.
pub fn flat_gates(outlines: &[Vec<DVec2>], shot: &Shot, lines: usize) -> Gates {
    let line = |line: usize| {
        let y = middle(shot.field.tan_half_height, line, lines);
        let mut gate = Gate::default();
        let edges = outlines.iter().map(|outline| gate.add_polygon(outline, y)).sum();
        gate.join();
        (gate, edges)
    };
    Gates::of((0..lines).map(line).collect())
}
