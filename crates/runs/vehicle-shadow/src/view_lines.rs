//! Lines of the string on the view-plane: four types, clipped at its distance (section 19.4).

use std::ops::AddAssign;

use glam::{DVec2, DVec3};

use crate::Chain;
use crate::function::CharacteristicFunction;

/// What becomes of a line of the string.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LineType {
    /// 1: both ends lie beyond the view-plane.
    Visible,
    /// 2: one end does.
    Partial,
    /// 3: neither end lies beyond the view-plane.
    Hidden,
    /// 4: the line is not displayed.
    Trace,
}

impl LineType {
    /// Of a line with ends at these distances ahead, before a view-plane at `distance` (m). The report's list says
    /// negative, its test greater than D: the test is right, or points just ahead of the eye would be thrown far away.
    pub fn of(ahead: [f64; 2], shown: bool, distance: f64) -> Self {
        match (shown, ahead[0] > distance, ahead[1] > distance) {
            (false, ..) => Self::Trace,
            (true, true, true) => Self::Visible,
            (true, false, false) => Self::Hidden,
            _ => Self::Partial,
        }
    }
}

/// How many lines were of each type, in the report's order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
pub struct LineCounts {
    /// Number of lines of type 1.
    pub visible: u64,
    /// Number of lines of type 2.
    pub partial: u64,
    /// Number of lines of type 3.
    pub hidden: u64,
    /// Number of lines of type 4.
    pub trace: u64,
}

impl LineCounts {
    fn count(&mut self, line: LineType) {
        *match line {
            LineType::Visible => &mut self.visible,
            LineType::Partial => &mut self.partial,
            LineType::Hidden => &mut self.hidden,
            LineType::Trace => &mut self.trace,
        } += 1;
    }
}

impl AddAssign for LineCounts {
    fn add_assign(&mut self, other: Self) {
        self.visible += other.visible;
        self.partial += other.partial;
        self.hidden += other.hidden;
        self.trace += other.trace;
    }
}

/// Ends of the displayed lines of each figure on the view-plane at distance 1, and what the lines were.
pub fn view_lines(
    function: &CharacteristicFunction,
    chain: &Chain,
    distance: f64,
) -> (Vec<Vec<DVec2>>, LineCounts) {
    let mut counts = LineCounts::default();
    let figure = |figure| {
        let mut view = FigureView { chain, distance, ends: Vec::new(), section: Vec::new() };
        for (from, to, shown) in function.lines(figure) {
            counts.count(if shown { view.add([from, to]) } else { LineType::Trace });
        }
        view.close()
    };
    (function.figures().iter().map(figure).collect(), counts)
}

/// One figure on the view-plane. What lies under the ground casts nothing: the figure ends in its section with the
/// ground (our choice).
struct FigureView<'a> {
    chain: &'a Chain,
    distance: f64,
    ends: Vec<DVec2>,
    /// Where lines come out of the ground, in camera axes.
    section: Vec<DVec3>,
}

impl FigureView<'_> {
    /// Adds a displayed line.
    fn add(&mut self, ends: [DVec3; 2]) -> LineType {
        let Some(ends) = self.above_ground(ends) else { return LineType::Hidden };
        let shadows = ends.map(|end| self.chain.shadow(end));
        let line = LineType::of(shadows.map(|end| end.x), true, self.distance);
        match line {
            LineType::Visible => self.ends.extend(shadows.map(project)),
            LineType::Partial => {
                self.ends.push(self.clip(shadows));
                self.ends.extend(shadows.into_iter().filter(|end| end.x > self.distance).map(project));
            }
            LineType::Hidden | LineType::Trace => {}
        }
        line
    }

    fn above_ground(&mut self, ends: [DVec3; 2]) -> Option<[DVec3; 2]> {
        let [a, b] = ends.map(|end| self.chain.height(end));
        if (a < 0.0) == (b < 0.0) {
            return (a >= 0.0).then_some(ends);
        }
        let out = ends[0] + (ends[1] - ends[0]) * (a / (a - b));
        self.section.push(self.chain.shadow(out));
        Some(if a >= 0.0 { [ends[0], out] } else { [out, ends[1]] })
    }

    /// Where the line between two shadows, one before the view-plane and one beyond it, comes through, at distance 1.
    fn clip(&self, [from, to]: [DVec3; 2]) -> DVec2 {
        let t = (self.distance - from.x) / (to.x - from.x);
        let at = from + (to - from) * t;
        DVec2::new(at.y, at.z) / self.distance
    }

    /// All ends. The edges of the section are no lines of the string; where they come through the view-plane they bound
    /// the figure like others, and so do no more than these the other lines between its corners.
    fn close(mut self) -> Vec<DVec2> {
        for (index, &from) in self.section.iter().enumerate() {
            for &to in &self.section[..index] {
                if LineType::of([from.x, to.x], true, self.distance) == LineType::Partial {
                    self.ends.push(self.clip([from, to]));
                }
            }
        }
        self.ends
    }
}

/// `X = D V'/U'`, `Y = D W'/U'` with D = 1.
fn project(shadow: DVec3) -> DVec2 {
    DVec2::new(shadow.y, shadow.z) / shadow.x
}

#[cfg(test)]
mod tests {
    use glam::{DVec2, DVec3};

    use landscape::Attitude;

    use super::{FigureView, LineType, project};
    use crate::Chain;

    #[test]
    fn check_values_of_the_clipping() {
        let (p, q, distance) = (DVec3::new(4.0, 1.0, 2.0), DVec3::new(-3.0, 2.0, 1.0), 0.5);
        let level = Attitude::default();
        let chain = Chain::of(&level, &level, 1.0, DVec3::Z);
        let view = FigureView { chain: &chain, distance, ends: Vec::new(), section: Vec::new() };
        assert_eq!(view.clip([q, p]) * distance, DVec2::new(1.5, 1.5));
        assert_eq!(view.clip([p, q]) * distance, DVec2::new(1.5, 1.5));
        assert_eq!(project(p) * distance, DVec2::new(0.125, 0.25));
    }

    #[test]
    fn the_test_is_distance_not_sign() {
        let of = |a, b| LineType::of([a, b], true, 0.5);
        assert_eq!(of(1.0, 2.0), LineType::Visible);
        assert_eq!(of(0.3, 2.0), LineType::Partial, "ahead of the eye, before the view-plane");
        assert_eq!(of(2.0, 0.5), LineType::Partial, "on the view-plane");
        assert_eq!(of(0.3, 0.2), LineType::Hidden);
        assert_eq!(of(-1.0, -2.0), LineType::Hidden);
        assert_eq!(LineType::of([1.0, 2.0], false, 0.5), LineType::Trace);
    }
}
