//! A town of boxes from photographs: what panels lose that straddle the edges of roofs.

use std::collections::BTreeSet;

use exact::Exact;
use generator::{Generator, PlaneKind, Planes, Session};
use glam::DVec2;
use landscape::Level;
use lunoid_tests::Shipped;
use signal::Probe;

/// Over the roofs, before the eye goes down into the street.
const FRAME: u64 = 40;
/// Columns and lines of the pictures that are measured.
const SIZE: [usize; 2] = [320, 240];
/// Distances of posts (m).
const SPACINGS: [u32; 4] = [16, 8, 4, 2];
/// Where the light of a pixel comes from.
const DRAPES: [&str; 3] = ["texture", "gouraud", "panel"];
/// Ranges of neighbours that differ by more (m) lie on both sides of an edge.
const JUMP: f32 = 3.0;
/// Pixels on both sides of an edge that count as edge pixels.
const REACH: usize = 2;
/// A pixel whose range is farther from that of `exact` (m) is wrong.
const FAR: f32 = 1.0;
/// A pixel whose light is farther from that of `exact` is wrong.
const UNLIKE: f32 = 0.05;
/// Ground that is lower (m) is street.
const STREET: f32 = 0.01;
/// The data sheet, which has the table.
const SHEET: &str = include_str!("../../docs/blocks/panels.md");

fn shipped() -> Shipped {
    Shipped::changed("photo-town", None, |scenario| {
        (scenario.raster.columns, scenario.raster.lines) = (Some(SIZE[0] as u32), Some(SIZE[1] as u32));
    })
}

fn session(shipped: &Shipped, spacing: u32, drape: &str) -> Box<dyn Session> {
    let sets = [("panels.spacing_m", spacing.to_string()), ("panels.drape", format!("\"{drape}\""))];
    let sets = sets.each_ref().map(|(key, value)| (*key, value.as_str()));
    let generator =
        registry::configure_with(&::panels::ROW, &sets).unwrap_or_else(|problems| panic!("{problems}"));
    generator.prepare(shipped.stage().stage()).unwrap()
}

fn plane(planes: &Planes, kind: PlaneKind) -> &[f32] {
    planes.get(kind).unwrap()
}

/// Whether two values are farther apart than `most`; two infinite ones are not.
fn differ(a: f32, b: f32, most: f32) -> bool {
    a != b && (a - b).abs() > most
}

/// Pixels within reach of a jump of the range.
fn edges(ranges: &[f32]) -> Vec<bool> {
    let [columns, lines] = SIZE;
    let near = |at: usize, count: usize| at.saturating_sub(REACH)..(at + REACH + 1).min(count);
    let mut found = vec![false; ranges.len()];
    for (line, column) in (0..lines).flat_map(|line| (0..columns).map(move |column| (line, column))) {
        let at = line * columns + column;
        let right = (column + 1 < columns).then(|| ranges[at + 1]);
        let below = ranges.get(at + columns).copied();
        if [right, below].into_iter().flatten().any(|other| differ(other, ranges[at], JUMP)) {
            near(line, lines).for_each(|line| {
                found[line * columns..][..columns][near(column, columns)].fill(true);
            });
        }
    }
    found
}

/// Share (%) of the pixels that `chosen` names at which two planes are farther apart than `most`.
fn wrong(chosen: &[bool], [a, b]: [&[f32]; 2], most: f32) -> f64 {
    let count = chosen.iter().filter(|is_chosen| **is_chosen).count();
    let apart = |at: usize| chosen[at] && differ(a[at], b[at], most);
    100.0 * (0..a.len()).filter(|at| apart(*at)).count() as f64 / count as f64
}

/// Mean distance of two planes over the pixels that `chosen` names.
fn apart(chosen: &[bool], [a, b]: [&[f32]; 2]) -> f64 {
    let all: Vec<f64> =
        (0..a.len()).filter(|at| chosen[*at]).map(|at| f64::from((a[at] - b[at]).abs())).collect();
    all.iter().sum::<f64>() / all.len() as f64
}

/// What stands at a place of the ground: the height of a roof or street (mm), or none on a wall, in a region whose corners differ.
fn kind(level: &Level, at: DVec2) -> Option<i64> {
    let [row, column] = [at.x, at.y].map(|along| (along / level.region_size()) as usize);
    let height = |[up, right]: [usize; 2]| level.words()[(row + up) * level.corners()[1] + column + right][0];
    let heights = [[0, 0], [0, 1], [1, 0], [1, 1]].map(height);
    heights.iter().all(|other| *other == heights[0]).then_some((1000.0 * heights[0]) as i64)
}

/// Share (%) of the panels of so many metres that have more than one kind of ground within them.
fn straddling(level: &Level, spacing: u32) -> f64 {
    /// Places along each side of a cell.
    const PLACES: u32 = 16;
    let cells = 200 / spacing;
    let share = |place: u32| (f64::from(place) + 0.5) / f64::from(PLACES);
    let mut panels = 0;
    for corner in (0..cells * cells).map(|cell| DVec2::new((cell / cells).into(), (cell % cells).into())) {
        // The southern panel, then the northern one: a cell is cut from south-east to north-west.
        let mut kinds = [BTreeSet::new(), BTreeSet::new()];
        for place in (0..PLACES * PLACES).map(|at| DVec2::new(share(at / PLACES), share(at % PLACES))) {
            let at = f64::from(spacing) * (corner + place);
            kinds[usize::from(place.x + place.y > 1.0)].insert(kind(level, at));
        }
        panels += kinds.iter().filter(|kinds| kinds.len() > 1).count();
    }
    100.0 * panels as f64 / f64::from(2 * cells * cells)
}

/// Planes of the frame by a generator made ready.
fn drawn(shipped: &Shipped, session: &dyn Session, kinds: &[PlaneKind]) -> Planes {
    let mut planes = Planes::new(SIZE[0], SIZE[1], kinds);
    session.frame(FRAME, &shipped.pose(FRAME).pose, &mut planes, &mut Probe::off()).unwrap();
    planes
}

#[test]
fn the_sheet_has_the_table_of_the_town() {
    let shipped = shipped();
    let judge = Exact.prepare(shipped.stage().stage()).unwrap();
    let exact = drawn(&shipped, &*judge, &[PlaneKind::Range, PlaneKind::Intensity, PlaneKind::Height]);
    let truth = [PlaneKind::Range, PlaneKind::Intensity].map(|kind| plane(&exact, kind));
    let edges = edges(truth[0]);
    let heights = plane(&exact, PlaneKind::Height).iter();
    let streets: Vec<bool> =
        heights.zip(truth[0]).map(|(height, range)| *height < STREET && range.is_finite()).collect();
    let mut rows = Vec::new();
    let mut measured = Vec::new();
    for spacing in SPACINGS {
        let kinds = [PlaneKind::Range, PlaneKind::Intensity];
        let found = DRAPES.map(|drape| drawn(&shipped, &*session(&shipped, spacing, drape), &kinds));
        let range = wrong(&edges, [plane(&found[0], PlaneKind::Range), truth[0]], FAR);
        let light = [0, 1, 2].map(|way| plane(&found[way], PlaneKind::Intensity));
        let unlike = light.map(|light| wrong(&edges, [light, truth[1]], UNLIKE));
        let smeared = light.map(|light| apart(&streets, [light, truth[1]]));
        let straddling = straddling(shipped.landscape.level(), spacing);
        rows.push(format!(
            "| {spacing} | {straddling:.1} | {range:.0} | {:.0} | {:.0} | {:.0} | {:.3} | {:.3} | {:.3} |",
            unlike[0], unlike[1], unlike[2], smeared[0], smeared[1], smeared[2]
        ));
        measured.push((straddling, range, unlike, smeared));
    }
    let missing: Vec<&String> = rows.iter().filter(|row| !SHEET.contains(row.as_str())).collect();
    assert!(missing.is_empty(), "not in the sheet:\n{}", rows.join("\n"));
    // Closer posts: fewer panels straddle, fewer edges are wrong. One grey a panel is worse than texture at edges, and in streets that are there at all.
    for pair in measured.windows(2) {
        assert!(pair[1].0 < pair[0].0 && pair[1].1 < pair[0].1, "{measured:?}");
    }
    assert!(measured.iter().all(|(_, _, unlike, _)| unlike[2] > unlike[0]), "{measured:?}");
    assert!(measured[1..].iter().all(|(_, _, _, smeared)| smeared[2] > 2.0 * smeared[0]), "{measured:?}");
}
