//! Pixels whose centres lie in a triangle.

/// Calls `each` for every pixel (column, line) of a picture of `size` (columns, lines) whose centre lies in a triangle of pixels I, J. A
/// centre on a side is in the triangle that has the side as a left or an upper one; so each centre is in one of two triangles that share a side.
pub fn pixels(corners: [[f64; 2]; 3], size: [usize; 2], mut each: impl FnMut(usize, usize)) {
    let [a, b, c] = corners;
    let area = cross(a, b, c);
    if area == 0.0 || !area.is_finite() {
        return;
    }
    // Clockwise on the screen, where J runs downward: then the inside has positive edge functions.
    let corners = if area > 0.0 { [a, b, c] } else { [a, c, b] };
    let range = |axis: usize| {
        let ends = corners.map(|corner| corner[axis]);
        let low = ends.into_iter().fold(f64::INFINITY, f64::min);
        let high = ends.into_iter().fold(f64::NEG_INFINITY, f64::max);
        let index = |at: f64| at.clamp(0.0, size[axis] as f64) as usize;
        index((low - 0.5).ceil())..index((high + 0.5).floor())
    };
    for line in range(1) {
        for column in range(0) {
            let centre = [column as f64 + 0.5, line as f64 + 0.5];
            if (0..3).all(|k| is_inside(corners[k], corners[(k + 1) % 3], centre)) {
                each(column, line);
            }
        }
    }
}

/// Twice the area of a triangle, positive where it runs clockwise on a screen whose second axis runs downward.
fn cross(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// Whether a centre lies on the inner side of an edge, or on an edge that is a left or an upper one.
fn is_inside(from: [f64; 2], to: [f64; 2], centre: [f64; 2]) -> bool {
    // Both triangles of a side work out the same number, of opposite sign.
    let is_turned = (to[0], to[1]) < (from[0], from[1]);
    let side = if is_turned { -cross(to, from, centre) } else { cross(from, to, centre) };
    let is_left_or_upper = to[1] < from[1] || (to[1] == from[1] && to[0] > from[0]);
    side > 0.0 || (side == 0.0 && is_left_or_upper)
}
