//! Where labels of points stand, so that none lies over another or over a mark.

use crate::lettering::{self, Size};
use crate::mark::Area;

/// Between a mark and its label (pixels).
const GAP: f32 = 4.0;
/// Distances from its point at which a label is tried that has no room beside its mark.
const AWAY: [f32; 3] = [18.0, 30.0, 44.0];
/// Directions in which it is tried, right and up first, as parts of the distance.
const WAYS: [(f32, f32); 8] =
    [(0.8, -0.6), (0.8, 0.6), (-0.8, -0.6), (-0.8, 0.6), (0.3, -1.0), (0.3, 1.0), (-0.3, -1.0), (-0.3, 1.0)];

/// A label that has found its place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Placed {
    /// Begin of its base line.
    pub at: (f32, f32),
    /// Where a line from its point meets it; `None` if it stands beside its mark.
    pub leader: Option<(f32, f32)>,
}

/// Places that are taken.
pub(crate) struct Labels {
    within: Area,
    size: Size,
    mark: f32,
    taken: Vec<Area>,
}

impl Labels {
    /// Labels of a size for marks at `points`, half as wide as `mark`; none leaves `within`.
    pub fn new(within: Area, size: Size, mark: f32, points: impl Iterator<Item = (f32, f32)>) -> Self {
        let square = |(x, y)| Area { left: x - mark, top: y - mark, width: 2.0 * mark, height: 2.0 * mark };
        Self { within, size, mark, taken: points.map(square).collect() }
    }

    /// A place for `text` near the point `at`; `None` if there is no room.
    pub fn place(&mut self, text: &str, at: (f32, f32)) -> Option<Placed> {
        let wide = lettering::width(text, self.size);
        let beside = self.mark + GAP;
        let near = [(beside, -self.mark), (beside, self.mark), (-beside, -self.mark), (-beside, self.mark)];
        let near = near.into_iter().map(|way| (way, false));
        let far = AWAY.into_iter().flat_map(|away| WAYS.map(|(x, y)| ((away * x, away * y), true)));
        let (area, is_led) = near.chain(far).find_map(|((dx, dy), is_led)| {
            let area = self.area(wide, (at.0 + dx, at.1 + dy), dx < 0.0);
            self.is_free(&area).then_some((area, is_led))
        })?;
        self.taken.push(area);
        let near_end = if area.left > at.0 { area.left - 1.0 } else { area.right() + 1.0 };
        let leader = is_led.then_some((near_end, area.top + area.height / 2.0));
        Some(Placed { at: (area.left, area.bottom() - 0.2 * self.size), leader })
    }

    /// A line of text whose middle is as high as `y`, ending or beginning at `x`.
    fn area(&self, wide: f32, (x, y): (f32, f32), is_left: bool) -> Area {
        let left = if is_left { x - wide } else { x };
        Area { left, top: y - self.size / 2.0, width: wide, height: self.size }
    }

    fn is_free(&self, area: &Area) -> bool {
        let Area { left, top, .. } = self.within;
        let is_within = area.left >= left
            && area.top >= top
            && area.right() <= self.within.right()
            && area.bottom() <= self.within.bottom();
        is_within && !self.taken.iter().any(|other| overlap(area, other))
    }
}

fn overlap(a: &Area, b: &Area) -> bool {
    a.left < b.right() && b.left < a.right() && a.top < b.bottom() && b.top < a.bottom()
}

#[cfg(test)]
mod tests {
    use super::{Labels, overlap};
    use crate::mark::Area;

    const PANEL: Area = Area { left: 0.0, top: 0.0, width: 400.0, height: 300.0 };

    #[test]
    fn labels_of_points_in_one_place_stand_apart() {
        let points: Vec<(f32, f32)> = (0..9).map(|k| (200.0 + k as f32, 150.0)).collect();
        let mut labels = Labels::new(PANEL, 12.0, 4.0, points.iter().copied());
        let placed: Vec<_> = points.iter().map(|at| labels.place("geometric", *at)).collect();
        assert!(placed[0].is_some_and(|first| first.leader.is_none()));
        assert!(placed.iter().flatten().count() >= 6, "{placed:?}");
        assert!(placed.iter().flatten().any(|label| label.leader.is_some()));
        let areas = &labels.taken;
        for (index, a) in areas.iter().enumerate().skip(points.len()) {
            assert!(areas[..index].iter().all(|b| !overlap(a, b)), "{a:?}");
        }
    }

    #[test]
    fn a_label_stays_within_the_panel() {
        let corner = (398.0, 2.0);
        let mut labels = Labels::new(PANEL, 12.0, 4.0, [corner].into_iter());
        let placed = labels.place("16000", corner).unwrap();
        assert!(placed.at.0 + 5.0 * 7.0 < 400.0 && placed.at.1 > 6.0, "{placed:?}");
        assert!(
            labels
                .place("a label that is wider than the panel is, and by far: no room for it", corner)
                .is_none()
        );
    }
}
