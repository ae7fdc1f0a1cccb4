//! Widest discs that hold no sampling point, by geometry.

use raster::Pattern;

/// Points of the pixel in the middle and of those around it, `reach` pixels far.
fn points(pattern: Pattern, reach: i32) -> Vec<[f64; 2]> {
    let pixels = (-reach..=reach).flat_map(|x| (-reach..=reach).map(move |y| [x, y]));
    let place = |[x, y]: [i32; 2]| {
        let offsets = pattern.offsets().iter();
        offsets.map(move |offset| {
            [f64::from(x) + f64::from(offset[0]) / 64.0, f64::from(y) + f64::from(offset[1]) / 64.0]
        })
    };
    pixels.flat_map(place).collect()
}

fn distance([x, y]: [f64; 2], [u, v]: [f64; 2]) -> f64 {
    ((x - u) * (x - u) + (y - v) * (y - v)).sqrt()
}

/// Middle of the circle through three points, if they are not on one line.
fn middle([a, b, c]: [[f64; 2]; 3]) -> Option<[f64; 2]> {
    let ([bx, by], [cx, cy]) = ([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]);
    let twice = 2.0 * (bx * cy - by * cx);
    let (b2, c2) = (bx * bx + by * by, cx * cx + cy * cy);
    (twice != 0.0).then(|| [a[0] + (cy * b2 - by * c2) / twice, a[1] + (bx * c2 - cx * b2) / twice])
}

/// The widest empty circle touches three points. One of them lies in the middle pixel, the others within a diameter of it,
/// and no empty disc is wider than a pixel's two diagonals.
fn widest_empty_disc(pattern: Pattern) -> f64 {
    let (own, all) = (points(pattern, 0), points(pattern, 2));
    let mut widest: f64 = 0.0;
    for &a in &own {
        let near: Vec<_> = all.iter().copied().filter(|&b| b != a && distance(a, b) < 1.5).collect();
        for (i, &b) in near.iter().enumerate() {
            for &c in &near[..i] {
                let Some(at) = middle([a, b, c]) else { continue };
                let radius = distance(at, a);
                if 2.0 * radius > widest
                    && radius < 0.75
                    && near.iter().all(|&other| distance(at, other) > radius - 1e-12)
                {
                    widest = 2.0 * radius;
                }
            }
        }
    }
    widest
}

#[test]
fn the_widest_disc_that_misses_all_points() {
    for (pattern, published) in [
        (Pattern::One, std::f64::consts::SQRT_2),
        (Pattern::Four, 0.790569),
        (Pattern::Eight, 0.525595),
        (Pattern::Sixteen, 0.386405),
        (Pattern::Grid16, 0.353553),
        (Pattern::Lattice32, 0.227772),
        (Pattern::OffCentre16, 0.386405),
    ] {
        let (found, stated) = (widest_empty_disc(pattern), pattern.widest_miss());
        assert!((found - stated).abs() < 1e-12, "{}: {found:.17}, stated {stated:.17}", pattern.name());
        assert!((found - published).abs() < 5e-7, "{}: {found}, published {published}", pattern.name());
    }
}

#[test]
fn no_pattern_is_off_centre_but_the_fault() {
    for pattern in Pattern::ALL {
        let sums = pattern
            .offsets()
            .iter()
            .fold([0, 0], |[x, y], offset| [x + i32::from(offset[0]) - 32, y + i32::from(offset[1]) - 32]);
        let expected = if pattern == Pattern::OffCentre16 { -2 * 16 } else { 0 };
        assert_eq!(sums, [expected; 2], "{}", pattern.name());
    }
}

#[test]
fn names_lead_to_their_patterns() {
    let names = Pattern::ALL.map(Pattern::name);
    assert_eq!(names, ["1", "4", "8", "16", "grid16", "lattice32", "off-centre16"]);
    assert_eq!(names.map(Pattern::named), Pattern::ALL.map(Some));
    assert_eq!(Pattern::named("2"), None);
}
