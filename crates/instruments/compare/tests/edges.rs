//! Edges of a scene: marked where they are, nothing else.

use compare::{CompareError, EDGE_PLANES, EdgeLimits, edge_mask};
use generator::{Label, PlaneKind, Planes, Shade};

/// Level ground at 100 m, seen in `columns` x `lines` pixels.
fn ground(columns: usize, lines: usize) -> Planes {
    let mut planes = Planes::new(columns, lines, &EDGE_PLANES);
    planes.get_mut(PlaneKind::Range).unwrap().fill(100.0);
    planes.get_mut(PlaneKind::NormalUp).unwrap().fill(1.0);
    planes.get_mut(PlaneKind::Label).unwrap().fill(f32::from(Label::Terrain.code()));
    planes
}

/// Normals that lean north by an angle of the line, a small one.
fn lean(planes: &mut Planes, angle: impl Fn(f64) -> f64) {
    let columns = planes.columns();
    for (kind, part) in
        [(PlaneKind::NormalNorth, libm::sin as fn(f64) -> f64), (PlaneKind::NormalUp, libm::cos)]
    {
        for (at, value) in planes.get_mut(kind).unwrap().iter_mut().enumerate() {
            *value = part(angle((at / columns) as f64)) as f32;
        }
    }
}

fn drawn(planes: &Planes) -> Vec<String> {
    let mask = edge_mask(planes, &EdgeLimits::default()).expect("good planes").pixels;
    let letters = |line: &[bool]| line.iter().map(|marked| if *marked { '#' } else { '.' }).collect();
    mask.chunks(planes.columns()).map(letters).collect()
}

#[test]
fn level_ground_has_no_edges() {
    let mask = edge_mask(&ground(5, 4), &EdgeLimits::default()).unwrap();
    assert_eq!((mask.masked(), mask.share()), (0, 0.0));
}

#[test]
fn outlines_are_two_pixels_wide_and_reach_one_beyond_their_ends() {
    let mut planes = ground(6, 5);
    planes.get_mut(PlaneKind::Label).unwrap()[2 * 6 + 3] = f32::from(Label::Rock.code());
    assert_eq!(drawn(&planes), ["......", "..###.", "..###.", "..###.", "......"]);
    let mask = edge_mask(&planes, &EdgeLimits::default()).unwrap();
    assert_eq!((mask.outlines, mask.ridges, mask.shadows, mask.kinks), (9, 0, 0, 0));
    assert_eq!(mask.share(), 0.3);
}

#[test]
fn remote_shadow_has_an_edge_and_local_shadow_has_none() {
    for (shade, count) in [(Shade::Remote, 2 * 4), (Shade::Local, 0)] {
        let mut planes = ground(4, 5);
        planes.get_mut(PlaneKind::Shadow).unwrap()[3 * 4..].fill(f32::from(shade.code()));
        let mask = edge_mask(&planes, &EdgeLimits::default()).unwrap();
        assert_eq!((mask.shadows, mask.masked()), (count, count), "{shade:?}");
    }
    // Black beside black is no step.
    let mut planes = ground(4, 5);
    let shadow = planes.get_mut(PlaneKind::Shadow).unwrap();
    shadow[..8].fill(f32::from(Shade::Local.code()));
    shadow[8..].fill(f32::from(Shade::Remote.code()));
    assert_eq!(edge_mask(&planes, &EdgeLimits::default()).unwrap().masked(), 0);
}

#[test]
fn ground_that_turns_evenly_is_smooth_however_much_it_turns() {
    for rate in [0.001, 0.03, 0.2] {
        let mut planes = ground(3, 12);
        lean(&mut planes, |line| rate * (line - 6.0));
        assert_eq!(edge_mask(&planes, &EdgeLimits::default()).unwrap().kinks, 0, "{rate}");
    }
    // And ground that turns more and more.
    let mut planes = ground(3, 12);
    lean(&mut planes, |line| 0.008 * line * line);
    assert_eq!(edge_mask(&planes, &EdgeLimits::default()).unwrap().kinks, 0);
}

/// A bowl of depth a = 20 m and radius 100 m meets level ground in a slope of 2 a / r = 0.4.
#[test]
fn the_rim_of_a_bowl_is_a_kink() {
    let mut planes = ground(2, 10);
    lean(&mut planes, |line| if line < 5.0 { 0.0 } else { libm::atan(0.4 * (1.0 - 0.1 * (line - 5.0))) });
    assert_eq!(drawn(&planes), ["..", "..", "..", "..", "##", "##", "..", "..", "..", ".."]);
    lean(&mut planes, |line| if line < 5.0 { 0.0 } else { 0.019 });
    assert_eq!(edge_mask(&planes, &EdgeLimits::default()).unwrap().kinks, 0);
}

#[test]
fn a_kink_at_the_border_of_the_picture_is_seen_from_within() {
    let mut planes = ground(1, 3);
    lean(&mut planes, |line| if line < 1.0 { 0.3 } else { 0.0 });
    assert_eq!(drawn(&planes), ["#", "#", "."]);
}

#[test]
fn ridges_are_those_of_the_ridge_mask() {
    let mut planes = ground(3, 5);
    planes.get_mut(PlaneKind::Range).unwrap()[..6].fill(200.0);
    assert_eq!(drawn(&planes), ["...", "###", "###", "###", "..."]);
    let tall = EdgeLimits { jump: 2.0, ..EdgeLimits::default() };
    assert_eq!(edge_mask(&planes, &tall).unwrap().masked(), 0);
}

#[test]
fn missing_planes_are_named() {
    let refused = edge_mask(&Planes::new(2, 2, &[PlaneKind::Range]), &EdgeLimits::default());
    assert!(matches!(refused, Err(CompareError::MissingPlane { kind: "label" })), "{refused:?}");
}
