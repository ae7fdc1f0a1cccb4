use std::sync::Arc;

use glam::{DMat3, DVec3, EulerRot};
use proptest::prelude::{prop_assert, prop_assert_eq, prop_assume, proptest};
use scenario::{BodyShading, Curvature, Projection};
use solids::{Body, Kind, rocks};

use super::{Aspect, Field, Pencil};
use crate::likeness::Eye;
use crate::stack::Stack;
use crate::table::Drawing;
use crate::{FaceLight, Span, ViewPlane};

/// Spans with their sweeps.
fn by_sweep(drawing: &Drawing) -> impl Iterator<Item = (u32, Span)> {
    let spans = |stack: &Stack| &drawing.spans[stack.spans.clone()];
    drawing.stacks.iter().flat_map(move |(sweep, stack)| spans(stack).iter().map(|span| (*sweep, *span)))
}

/// By sweep, then from the top: no two faces of a body lie over one another.
fn sorted(drawing: &Drawing) -> Vec<(u32, Span)> {
    let mut spans: Vec<_> = by_sweep(drawing).collect();
    let order = |(sweep, span): &(u32, Span)| (*sweep, span.top.to_bits(), span.bottom.to_bits());
    spans.sort_by_key(order);
    spans
}

proptest! {
    /// To the bit: rocks anywhere in the picture, between two sweeps and on many.
    #[test]
    fn edge_by_edge_is_face_by_face(
        shape in 0..rocks::SHAPES,
        foot in [3.0..30.0f64, -9.0..9.0, -2.0..2.0],
        turns in [-3.0..3.0f64, -3.0..3.0, -3.0..3.0],
        is_straight in proptest::prelude::any::<bool>(),
        scale in 0.1..4.0f64,
        sweeps in 2..200i32,
        pitch in -0.4..0.4f64,
    ) {
        let solid = Arc::new(rocks::shapes(7).unwrap().swap_remove(shape));
        let turn = DMat3::from_euler(EulerRot::ZYX, turns[0], turns[1], turns[2]);
        let body = Body::place(1, Kind::Rock, &solid, DVec3::from_array(foot), &turn, scale);
        let view = ViewPlane {
            eye: [0.0; 3],
            heading: 0.0,
            pitch,
            projection: if is_straight { Projection::Exact } else { Projection::Corrected },
            curvature: Curvature::None,
            tan_half_height: 0.5,
            lines: 500.0,
        };
        let tangents: Vec<f64> =
            (0..sweeps).map(|sweep| 1.2 * f64::from(sweep) / f64::from(sweeps - 1) - 0.6).collect();
        let field = Field::new(&view, &tangents);
        let Some(aspect) = field.aspect(&body) else { return Ok(()) };
        let Aspect { sweeps, eye, .. } = &aspect;
        let (first, tangents) = (sweeps.start, &tangents[sweeps.clone()]);
        let light = FaceLight { sun: DVec3::new(-0.6, 0.48, 0.64), shading: BodyShading::Flat };
        let (sighting, vectors, half_height) = (&field.sighting, field.vectors, view.tan_half_height);
        let eye = Eye { sighting, vectors, light: &light, place: *eye, half_height };
        let mut pencil = Pencil::default();
        prop_assume!(pencil.likeness.take(&eye, &body, false) && pencil.likeness.is_inside);
        let (mut by_edges, mut by_faces) = (Drawing::default(), Drawing::default());
        // What one body leaves behind must not show in the next.
        for _ in 0..2 {
            by_edges = Drawing::default();
            pencil.draw(&field, &aspect, Span::default(), &mut by_edges);
        }
        pencil.draw_faces(&field, &solid, (first, tangents), Span::default(), &mut by_faces);
        // Together, so that whoever lays them over the lines asks for all at once.
        for (_, stack) in &by_edges.stacks {
            let spans = &by_edges.spans[stack.spans.clone()];
            prop_assert!(spans.windows(2).all(|pair| pair[0].goes_on(&pair[1])), "{:?}", spans);
            prop_assert_eq!(stack.ends, [spans[0].top, spans[spans.len() - 1].bottom]);
            let near = || spans.iter().flat_map(|span| span.near);
            prop_assert_eq!(stack.near, [near().fold(f32::INFINITY, f32::min), near().fold(0.0, f32::max)]);
        }
        let touch = |pair: &[(u32, Span)]| (pair[0].1.bottom - pair[1].1.top).abs() < 1e-3;
        let spans: Vec<_> = by_sweep(&by_edges).collect();
        let touches = spans.windows(2).filter(|pair| pair[0].0 == pair[1].0).all(touch);
        prop_assert!(touches, "{:?}", spans);
        prop_assert_eq!(sorted(&by_edges), sorted(&by_faces));
    }

    /// Sweeps that stand evenly, as they do, and others.
    #[test]
    fn the_first_sweep_is_found_that_a_search_finds(
        steps in proptest::collection::vec(0.0..0.1f64, 0..40),
        even in proptest::prelude::any::<bool>(),
        elsewhere in proptest::collection::vec(-2.0..4.0f64, 20),
    ) {
        let mut at = -0.6;
        let mut next = |step: &f64| {
            at += if even { 0.03 } else { *step };
            at
        };
        let tangents: Vec<f64> = steps.iter().map(&mut next).collect();
        let view = ViewPlane {
            eye: [0.0; 3],
            heading: 0.0,
            pitch: 0.0,
            projection: Projection::Exact,
            curvature: Curvature::None,
            tan_half_height: 0.5,
            lines: 500.0,
        };
        let field = Field::new(&view, &tangents);
        for across in tangents.iter().copied().chain(elsewhere).chain([f64::NEG_INFINITY, f64::INFINITY]) {
            prop_assert_eq!(field.first_sweep(across), tangents.partition_point(|&tangent| tangent < across));
        }
    }
}
