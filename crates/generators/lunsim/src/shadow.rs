//! Remote shadow, marched outwards from the sun along lines of the grid (block 13).

/// How far a march went.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct March {
    /// Points at which the roof was held against the ground.
    pub points: u64,
    /// Those of them whose roof came from between two points.
    pub between: u64,
}

/// Which points of a grid of `size` x `size` lie in the shadow of others. `steps` are its increments (m), `sun` the
/// direction to the sun on the map (along, across; unit) and `tangent` that of its elevation.
///
/// The march goes line by line away from the sun: rows if it stands rather along the line of sight, columns if rather
/// across it. A roof falls from each point with the sun's rays; what lies below the roof is dark. Where the sun is on a
/// cardinal point the roof of a point comes from the one point before it, which makes it the running maximum of the
/// report; otherwise from between two of them, linearly (our choice).
pub(crate) fn shadows(
    heights: &[f64],
    size: usize,
    steps: [f64; 2],
    sun: [f64; 2],
    tangent: f64,
) -> (Vec<bool>, March) {
    let rates = [sun[0] / steps[0], sun[1] / steps[1]];
    let main = if rates[0].abs() >= rates[1].abs() { 0 } else { 1 };
    let (towards, lean) = (rates[main], rates[1 - main] / rates[main].abs());
    let fall = tangent / towards.abs();
    let index = |line: usize, at: usize| if main == 0 { line * size + at } else { at * size + line };
    let mut dark = vec![false; size * size];
    let mut roof = vec![f64::NEG_INFINITY; size];
    let mut next = roof.clone();
    let mut march = March::default();
    for line in 0..size {
        let line = if towards > 0.0 { size - 1 - line } else { line };
        for at in 0..size {
            let point = index(line, at);
            let above = between(&roof, at as f64 + lean) - fall;
            dark[point] = above > heights[point];
            next[at] = above.max(heights[point]);
            march.points += 1;
        }
        std::mem::swap(&mut roof, &mut next);
    }
    march.between = if lean == 0.0 { 0 } else { march.points };
    (dark, march)
}

/// The roof at a place between its points; nothing falls from beyond its ends.
fn between(roof: &[f64], place: f64) -> f64 {
    let before = place.floor();
    let share = place - before;
    if before < 0.0 || before as usize >= roof.len() {
        return f64::NEG_INFINITY;
    }
    let low = roof[before as usize];
    if share == 0.0 || low == f64::NEG_INFINITY {
        return low;
    }
    roof.get(before as usize + 1).map_or(f64::NEG_INFINITY, |high| low + share * (high - low))
}

#[cfg(test)]
mod tests {
    use super::{March, shadows};

    /// A wall of 10 m at row or column 20 of ground of 1 m: under a sun of tangent 0.4 it shadows 25 m, whichever side
    /// the sun stands on.
    #[test]
    fn the_shadow_of_a_wall_is_its_height_over_the_tangent() {
        let (size, wall) = (64, 20);
        for (sun, is_row, sign) in
            [([1.0, 0.0], true, -1), ([-1.0, 0.0], true, 1), ([0.0, 1.0], false, -1), ([0.0, -1.0], false, 1)]
        {
            let line = |index: usize| if is_row { index / size } else { index % size };
            let heights: Vec<f64> =
                (0..size * size).map(|index| if line(index) == wall { 10.0 } else { 0.0 }).collect();
            // 0.97 m: no point falls on the very end of the shadow.
            let (dark, march) = shadows(&heights, size, [0.97, 0.97], sun, 0.4);
            assert_eq!(march, March { points: (size * size) as u64, between: 0 });
            for (index, dark) in dark.into_iter().enumerate() {
                let beyond = sign * (line(index) as i64 - wall as i64);
                assert_eq!(dark, (1..=25).contains(&beyond), "sun {sun:?}, {beyond} beyond the wall");
            }
        }
    }

    /// A ridge under a sun that is on no cardinal point: the shadow is as long along the ray.
    #[test]
    fn a_leaning_march_keeps_the_length_of_a_shadow() {
        let size = 200;
        let (sin, cos) = quantities::sin_cos(quantities::radians(30.0));
        // A ridge along the columns, so that only the part of the ray across it counts.
        let heights: Vec<f64> =
            (0..size * size).map(|index| if index / size == 150 { 20.0 } else { 0.0 }).collect();
        let (dark, march) = shadows(&heights, size, [1.0, 1.0], [cos, sin], 0.5);
        assert_eq!(march.between, (size * size) as u64);
        let shadowed = (0..150).filter(|row| dark[row * size + 20]).count();
        assert_eq!(shadowed, (20.0 / 0.5 * cos).floor() as usize);
        assert!((151..size).all(|row| !dark[row * size + 20]));
    }

    #[test]
    fn an_overhead_sun_and_level_ground_have_no_shadow() {
        let rough: Vec<f64> = (0..256).map(|index| f64::from(index * 37 % 11)).collect();
        let overhead = libm::tan(quantities::radians(90.0));
        assert!(!shadows(&rough, 16, [1.0; 2], [1.0, 0.0], overhead).0.contains(&true));
        assert!(!shadows(&[7.0; 256], 16, [1.0; 2], [0.6, 0.8], 1e-3).0.contains(&true));
    }
}
