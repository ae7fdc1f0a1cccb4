//! The area of a circle within a rectangle, in closed form.

/// Area within the rectangle from `low` to `high` of the circle of a radius about the origin.
///
/// Every edge of the rectangle and the middle span a triangle: the sum of what the circle has in common with them, with the
/// sign of their turn, is the area.
pub fn area_within(radius: f64, low: [f64; 2], high: [f64; 2]) -> f64 {
    let nearest = [0, 1].map(|axis| 0.0_f64.clamp(low[axis], high[axis]));
    if dot(nearest, nearest) >= radius * radius {
        return 0.0;
    }
    let corners = [low, [high[0], low[1]], high, [low[0], high[1]]];
    let sum: f64 = (0..4).map(|k| triangle(radius, corners[k], corners[(k + 1) % 4])).sum();
    sum.clamp(0.0, (high[0] - low[0]) * (high[1] - low[1]))
}

/// Signed area within the circle of the triangle of its middle and an edge: a sector, a triangle and a sector.
fn triangle(radius: f64, from: [f64; 2], to: [f64; 2]) -> f64 {
    let along = [to[0] - from[0], to[1] - from[1]];
    let squared = dot(along, along);
    let distance = cross(from, to) / squared.sqrt();
    let foot = -dot(from, along) / squared;
    let half = ((radius * radius - distance * distance).max(0.0) / squared).sqrt();
    let [enters, leaves] = [foot - half, foot + half].map(|share| {
        let share = share.clamp(0.0, 1.0);
        [from[0] + share * along[0], from[1] + share * along[1]]
    });
    sector(radius, from, enters) + cross(enters, leaves) / 2.0 + sector(radius, leaves, to)
}

fn sector(radius: f64, from: [f64; 2], to: [f64; 2]) -> f64 {
    radius * radius / 2.0 * libm::atan2(cross(from, to), dot(from, to))
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

#[cfg(test)]
mod tests {
    use super::area_within;
    use std::f64::consts::PI;

    #[test]
    fn parts_of_a_circle() {
        assert!((area_within(1.0, [-2.0; 2], [3.0; 2]) - PI).abs() < 1e-15);
        assert!((area_within(1.0, [0.0; 2], [2.0; 2]) - PI / 4.0).abs() < 1e-15);
        assert_eq!(area_within(1.0, [-0.5; 2], [0.5; 2]), 1.0);
        assert_eq!(area_within(1.0, [0.8; 2], [2.0; 2]), 0.0);
        // Beyond the chord at 1/2: a sixth of the circle's sectors less a triangle, twice.
        let beyond = PI / 3.0 - 3.0_f64.sqrt() / 4.0;
        assert!((area_within(1.0, [0.5, -2.0], [2.0, 2.0]) - beyond).abs() < 1e-15);
    }

    /// Whatever its radius and middle, a circle is the sum of its parts in all pixels.
    #[test]
    fn the_pixels_of_a_circle_have_its_area() {
        for (radius, x, y) in [(0.75, 0.0, 0.0), (0.1, 0.3, 0.9), (0.75, 0.13, 0.57), (9.3, 0.5, 0.25)] {
            let pixels = (0..24 * 24).map(|i| [f64::from(i % 24) - 12.0 - x, f64::from(i / 24) - 12.0 - y]);
            let sum: f64 = pixels.map(|[x, y]| area_within(radius, [x, y], [x + 1.0, y + 1.0])).sum();
            assert!((sum / (PI * radius * radius) - 1.0).abs() < 1e-13, "{radius}: {sum}");
        }
    }
}
