//! Boundaries between two neighbouring profiles.

use crate::profile::Interval;

/// A directed piece of boundary in (p, q), shadow to its right.
pub(crate) type Piece = [[f64; 2]; 2];

/// One profile of a strip: its place across (m) and its shadow, ascending.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Side<'a> {
    pub(crate) p: f64,
    pub(crate) dark: &'a [Interval],
}

/// How far across the strip a tip reaches. A shadow with a round end is `c sqrt(d)` wide at a distance d from it; with
/// the end anywhere in the strip, this share makes the triangle on the last profile as large as the cap on average:
/// `share w s / 2` with `w = 2/3 c sqrt(s)` is `2/3 2/5 c s^(3/2)`.
pub(crate) const TIP: f64 = 0.8;

/// Places of a lattice across a strip on which profiles and tips lie.
pub(crate) const TIP_PLACES: u8 = 5;

/// Joins the shadow of two neighbouring profiles.
///
/// Intervals that overlap belong to one shadow: its starts are joined, and its ends. An interval that overlaps none
/// ends in a tip short of the other profile; so does the light between two intervals that one shadow joins.
/// Together with the intervals themselves the pieces are closed.
pub(crate) fn join(left: Side<'_>, right: Side<'_>, out: &mut Vec<Piece>) {
    let (from_left, from_right) = (tip_place(left.p, right.p), tip_place(right.p, left.p));
    let (mut l, mut r) = (0, 0);
    while l < left.dark.len() || r < right.dark.len() {
        let first = [l, r];
        [l, r] = end_of_shadow(left.dark, right.dark, first);
        let (ls, rs) = (&left.dark[first[0]..l], &right.dark[first[1]..r]);
        close_gaps(left.p, from_left, ls, out);
        close_gaps(right.p, from_right, rs, out);
        let tip = if ls.is_empty() { [from_right, centre(rs)] } else { [from_left, centre(ls)] };
        let start = |p: f64, dark: &[Interval]| dark.first().map_or(tip, |interval| [p, interval[0]]);
        let end = |p: f64, dark: &[Interval]| dark.last().map_or(tip, |interval| [p, interval[1]]);
        out.push([start(left.p, ls), start(right.p, rs)]);
        out.push([end(right.p, rs), end(left.p, ls)]);
    }
}

/// The shadow along the outer profile of a tile, as pieces: `away` from the sun or towards it.
pub(crate) fn edge(side: Side<'_>, away: bool, out: &mut Vec<Piece>) {
    for &[from, to] in side.dark {
        let ends = [[side.p, from], [side.p, to]];
        out.push(if away { ends } else { [ends[1], ends[0]] });
    }
}

/// Past the chain of intervals that begins at `first` (left, right) and overlaps across the strip.
fn end_of_shadow(left: &[Interval], right: &[Interval], first: [usize; 2]) -> [usize; 2] {
    let start = |dark: &[Interval], n: usize| dark.get(n).map_or(f64::INFINITY, |interval| interval[0]);
    let reach =
        |dark: &[Interval], first: usize, n: usize| dark[first..n].last().map_or(f64::NEG_INFINITY, |i| i[1]);
    let [mut l, mut r] = first;
    if start(left, l) <= start(right, r) {
        l += 1
    } else {
        r += 1
    }
    loop {
        if start(left, l) < reach(right, first[1], r) {
            l += 1;
        } else if start(right, r) < reach(left, first[0], l) {
            r += 1;
        } else {
            return [l, r];
        }
    }
}

fn tip_place(from: f64, to: f64) -> f64 {
    from + TIP * (to - from)
}

fn close_gaps(p: f64, tip: f64, dark: &[Interval], out: &mut Vec<Piece>) {
    for pair in dark.windows(2) {
        let [end, start] = [pair[0][1], pair[1][0]];
        let at_tip = [tip, 0.5 * (end + start)];
        if p < tip {
            out.push([at_tip, [p, end]]);
            out.push([[p, start], at_tip]);
        } else {
            out.push([[p, end], at_tip]);
            out.push([at_tip, [p, start]]);
        }
    }
}

fn centre(dark: &[Interval]) -> f64 {
    0.5 * (dark[0][0] + dark[dark.len() - 1][1])
}

#[cfg(test)]
mod tests {
    use super::{Piece, Side, TIP, edge, join};
    use crate::profile::Interval;
    use proptest::prelude::*;

    fn closed(left: &[Interval], right: &[Interval]) -> Vec<Piece> {
        let (left, right) = (Side { p: 0.0, dark: left }, Side { p: 2.0, dark: right });
        let mut pieces = Vec::new();
        join(left, right, &mut pieces);
        edge(left, false, &mut pieces);
        edge(right, true, &mut pieces);
        pieces
    }

    fn area(pieces: &[Piece]) -> f64 {
        pieces.iter().map(|[a, b]| 0.5 * (a[0] * b[1] - b[0] * a[1])).sum()
    }

    fn near(found: f64, expected: f64) {
        assert!((found - expected).abs() < 1e-12, "{found}, expected {expected}");
    }

    #[test]
    fn a_shadow_across_is_a_trapezium() {
        assert_eq!(area(&closed(&[[1.0, 3.0]], &[[2.0, 6.0]])), 6.0);
    }

    #[test]
    fn a_shadow_of_one_profile_is_a_triangle() {
        near(area(&closed(&[[1.0, 3.0]], &[])), 1.6);
        near(area(&closed(&[], &[[1.0, 3.0]])), 1.6);
        // Touching is not overlapping.
        near(area(&closed(&[[1.0, 2.0]], &[[2.0, 3.0]])), 1.6);
    }

    #[test]
    fn light_between_two_shadows_of_one_ends_in_a_tip() {
        let expected = 8.0 - TIP * 2.0;
        near(area(&closed(&[[0.0, 1.0], [3.0, 4.0]], &[[0.0, 4.0]])), expected);
        near(area(&closed(&[[0.0, 4.0]], &[[0.0, 1.0], [3.0, 4.0]])), expected);
    }

    fn intervals() -> impl Strategy<Value = Vec<Interval>> {
        prop::collection::btree_set(0u32..40, 0..12).prop_map(|places| {
            let places: Vec<f64> = places.into_iter().map(f64::from).collect();
            places.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect()
        })
    }

    proptest! {
        #[test]
        fn every_point_is_left_as_often_as_it_is_reached(left in intervals(), right in intervals()) {
            let mut ends: Vec<([u64; 2], i32)> = Vec::new();
            for [from, to] in closed(&left, &right) {
                ends.push((from.map(f64::to_bits), -1));
                ends.push((to.map(f64::to_bits), 1));
            }
            ends.sort_unstable();
            for point in ends.chunk_by(|a, b| a.0 == b.0) {
                prop_assert_eq!(point.iter().map(|end| end.1).sum::<i32>(), 0);
            }
        }

        #[test]
        fn no_place_is_enclosed_twice_or_backwards(left in intervals(), right in intervals(), p in 0.01f64..1.99) {
            // Along a profile inside the strip the pieces are crossed alternately.
            let mut crossings: Vec<(f64, i32)> = Vec::new();
            for [from, to] in closed(&left, &right) {
                if (from[0] <= p) != (to[0] <= p) {
                    let share = (p - from[0]) / (to[0] - from[0]);
                    crossings.push((from[1] + share * (to[1] - from[1]), if to[0] > from[0] { 1 } else { -1 }));
                }
            }
            crossings.sort_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1)));
            for (n, crossing) in crossings.iter().enumerate() {
                prop_assert_eq!(crossing.1, if n % 2 == 0 { 1 } else { -1 });
            }
        }
    }
}
