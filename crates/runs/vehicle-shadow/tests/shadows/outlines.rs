//! The report's walk around figures against their union.

use glam::DVec2;
use quantities::unit_interval;
use solids::culture;
use vehicle_shadow::{Gate, OutlineRule, Shape, outlines, shadow_outlines};

use crate::scenes::{shot, to_sun};

type Polygon = Vec<DVec2>;

/// A convex polygon of random corners on an ellipse.
fn polygon(seed: u64, index: u64, middle: DVec2, size: f64) -> Polygon {
    let part = |k: u64| unit_interval(seed, &[index, k]);
    let mut angles: Vec<f64> = (0..3 + index % 5).map(|k| std::f64::consts::TAU * part(10 + k)).collect();
    angles.sort_by(f64::total_cmp);
    let radii = DVec2::new(0.3 + part(1), 0.3 + part(2)) * size;
    angles.into_iter().map(|angle| middle + radii * DVec2::new(libm::cos(angle), libm::sin(angle))).collect()
}

fn gate(polygons: &[Polygon], y: f64) -> Gate {
    let mut gate = Gate::default();
    polygons.iter().for_each(|polygon| {
        gate.add_polygon(polygon, y);
    });
    gate.join();
    gate
}

fn length(gate: &Gate) -> f64 {
    gate.stretches().iter().map(|[from, to]| to - from).sum()
}

/// Stretches of both and of either: their difference is nothing but rounding if they are equal.
fn difference(a: &Gate, b: &Gate) -> f64 {
    let mut either = Gate::default();
    a.stretches().iter().chain(b.stretches()).for_each(|stretch| either.add(*stretch));
    either.join();
    2.0 * length(&either) - length(a) - length(b)
}

fn crosses(polygon: &Polygon, from: DVec2, to: DVec2) -> bool {
    polygon.iter().zip(polygon.iter().cycle().skip(1)).any(|(&a, &b)| {
        let side = |p: DVec2, q: DVec2, r: DVec2| (q - p).perp_dot(r - p) > 0.0;
        side(a, b, from) != side(a, b, to) && side(from, to, a) != side(from, to, b)
    })
}

/// Where all figures hold one place there are no holes, and the walk is the union.
#[test]
fn the_walk_is_the_union_where_there_are_no_holes() {
    let mut corners = 0;
    for seed in 0..300 {
        let around = |index: u64| {
            let part = |k: u64| 2.0 * unit_interval(seed, &[index, 20 + k]) - 1.0;
            // A triangle of large corners around the origin, and something sticking out of it.
            let mut figure = polygon(seed, index, DVec2::new(part(0), part(1)) * 0.2, 1.5);
            figure.extend([DVec2::new(0.05, 0.0), DVec2::new(-0.05, 0.04), DVec2::new(-0.03, -0.05)]);
            hull(figure)
        };
        let figures: Vec<Polygon> = (0..2 + seed % 7).map(around).collect();
        let walked = outlines(&figures);
        // A figure that lies wholly within another touches nothing.
        corners += walked.iter().map(Vec::len).max().unwrap();
        for line in 0..60 {
            let y = -2.2 + 4.4 * (f64::from(line) + 0.37) / 60.0;
            let off = difference(&gate(&figures, y), &gate(&walked, y));
            assert!(off.abs() < 1e-9, "{seed}: {off} at {y}");
        }
    }
    assert!(corners > 300 * 8, "{corners}");
}

/// Gift wrapping, for the tests' own figures.
fn hull(points: Polygon) -> Polygon {
    let mut corners = vec![points.iter().copied().min_by(|a, b| a.x.total_cmp(&b.x)).unwrap()];
    loop {
        let last = corners[corners.len() - 1];
        let others = points.iter().copied().filter(|point| *point != last);
        let next = others
            .reduce(|best, point| if (best - last).perp_dot(point - last) < 0.0 { point } else { best });
        match next {
            Some(next) if next != corners[0] => corners.push(next),
            _ => return corners,
        }
    }
}

/// Figures anywhere: nothing of the union is lost, and what is added cannot be left without crossing a figure.
#[test]
fn the_walk_adds_holes_and_nothing_else() {
    const GRID: usize = 120;
    let (mut groups, mut holes) = (0, 0);
    for seed in 1000..1060 {
        let place =
            |index: u64| DVec2::new(unit_interval(seed, &[index, 50]), unit_interval(seed, &[index, 51]));
        let figures: Vec<Polygon> =
            (0..9).map(|index| polygon(seed, index, place(index) * 4.0, 0.9)).collect();
        let walked = outlines(&figures);
        groups += walked.len();
        let at = |index: usize| -1.6 + 7.2 * (index as f64 + 0.431) / GRID as f64;
        let inside =
            |polygons: &[Polygon], index: usize| gate(polygons, at(index / GRID)).holds(at(index % GRID));
        let [union, walk]: [Vec<bool>; 2] = [&figures, &walked]
            .map(|polygons| (0..GRID * GRID).map(|index| inside(polygons, index)).collect());
        let reached = flood(GRID, |from, to| {
            let [from, to] = [from, to].map(|index| DVec2::new(at(index % GRID), at(index / GRID)));
            !figures.iter().any(|figure| crosses(figure, from, to))
        });
        for index in 0..GRID * GRID {
            assert!(walk[index] || !union[index], "{seed}: lost at {index}");
            assert!(!(walk[index] && reached[index]), "{seed}: added outside at {index}");
            holes += usize::from(walk[index] && !union[index]);
        }
    }
    assert!(groups > 60 && holes > 100, "{groups} groups, {holes} places in holes");
}

/// Places of a square grid that can be reached from its first.
fn flood(side: usize, is_open: impl Fn(usize, usize) -> bool) -> Vec<bool> {
    let mut reached = vec![false; side * side];
    let mut next = vec![0];
    while let Some(index) = next.pop() {
        if std::mem::replace(&mut reached[index], true) {
            continue;
        }
        let (x, y) = (index % side, index / side);
        let around = [
            (x > 0, index.wrapping_sub(1)),
            (x + 1 < side, index + 1),
            (y > 0, index.wrapping_sub(side)),
            (y + 1 < side, index + side),
        ];
        next.extend(
            around
                .into_iter()
                .filter(|(is_there, to)| *is_there && !reached[*to] && is_open(index, *to))
                .map(|(_, to)| to),
        );
    }
    reached
}

/// Boxes side by side share edges and corners: nothing is lost where lines lie on one another.
#[test]
fn figures_that_share_edges() {
    let square = |x: f64, y: f64| -> Polygon {
        [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|[u, v]| DVec2::new(x + u, y + v)).into()
    };
    let figures = vec![
        square(0.0, 0.0),
        square(1.0, 0.0),
        square(1.0, 1.0),
        square(0.0, 0.0),
        square(0.5, 0.0),
        square(5.0, 5.0),
    ];
    let walked = outlines(&figures);
    assert_eq!(walked.len(), 2, "two groups");
    // The lowest on the screen comes first.
    assert!(walked[0].iter().all(|corner| corner.y >= 5.0));
    for y in [0.3, 0.7, 1.2, 1.9, 5.5] {
        assert!(difference(&gate(&figures, y), &gate(&walked, y)).abs() < 1e-12, "{y}");
    }
}

#[test]
fn a_ring_loses_its_hole() {
    let bar = |low: [f64; 2], high: [f64; 2]| -> Polygon {
        [[low[0], low[1]], [high[0], low[1]], [high[0], high[1]], [low[0], high[1]]]
            .map(DVec2::from_array)
            .into()
    };
    let ring = [
        bar([0.0, 0.0], [4.0, 1.0]),
        bar([0.0, 3.0], [4.0, 4.0]),
        bar([0.2, 0.2], [1.0, 3.8]),
        bar([3.0, 0.2], [3.8, 3.8]),
    ];
    assert_eq!(gate(&ring, 2.0).stretches(), [[0.2, 1.0], [3.0, 3.8]]);
    let walked = outlines(&ring);
    assert_eq!(walked.len(), 1);
    let [[from, to]] = gate(&walked, 2.0).stretches()[..] else { panic!("{walked:?}") };
    assert!((from - 0.2).abs() < 1e-12 && (to - 3.8).abs() < 1e-12);
}

/// The shadow of a real vehicle, some sixty figures with common edges: the walk holds the union and adds holes.
#[test]
fn a_rover_is_walked_around() {
    let shape = Shape::new(culture::model("rover").unwrap(), 1.6334);
    for (azimuth, elevation) in [(200.0, 12.0), (170.0, 9.0), (215.0, 8.0), (190.0, 6.0)] {
        let shot = shot([0.0, 0.0, 1.6334], 1.6334, [4.0, -20.0, 10.0]);
        let outlines = [OutlineRule::Parts, OutlineRule::Walk]
            .map(|rule| shadow_outlines(shape.function(), &shot, to_sun(azimuth, elevation), rule).0);
        assert!(outlines[0].len() > 10, "{azimuth} {elevation}: {}", outlines[0].len());
        assert!(outlines[1].len() < outlines[0].len());
        let mut dark = 0.0;
        for line in 0..200 {
            let y = shot.field.tan_half_height * (2.0 * f64::from(line) - 199.0) / 200.0;
            let [parts, walk] = outlines.each_ref().map(|outlines| gate(outlines, y));
            let lost = length(&parts) + difference(&parts, &walk) - length(&walk);
            assert!(lost.abs() < 1e-8, "{azimuth} {elevation}: {lost} lost at {y}");
            dark += length(&parts);
        }
        assert!(dark > 1.0, "{dark}");
    }
}
