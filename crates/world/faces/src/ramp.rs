//! Brightness along one scan line of a face: linear along its edges, then linear between them.

use crate::shade::in_space;

/// A corner of a face on the screen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ScreenCorner {
    /// Place on the screen: x to the right, y downwards; any unit.
    pub at: [f64; 2],
    /// Depth from the eye (m), above 0.
    pub depth: f64,
    /// Brightness, 0 to 1.
    pub brightness: f64,
}

/// Direction of scan lines.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scan {
    /// Lines of constant x (reported).
    Vertical,
    /// Lines of constant y.
    Horizontal,
}

/// Where brightness runs linearly.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Interpolation {
    /// On the screen (reported).
    Screen,
    /// In space, as true perspective asks.
    Perspective,
}

/// Where a scan line enters or leaves a face.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct End {
    /// Place along the line, in the unit of the screen.
    pub at: f64,
    /// Depth from the eye there (m).
    pub depth: f64,
    /// Brightness there, 0 to 1.
    pub brightness: f64,
}

/// Brightness of a face along one scan line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ramp {
    /// Where the line enters, at the lower place, and where it leaves.
    pub ends: [End; 2],
    interpolation: Interpolation,
}

impl Ramp {
    /// The ramp of a convex face along the line at `line`; `None` where the line misses the face.
    pub fn of(corners: &[ScreenCorner], scan: Scan, line: f64, interpolation: Interpolation) -> Option<Self> {
        let next = corners.iter().cycle().skip(1);
        let edges = corners.iter().zip(next);
        let ends = edges.flat_map(|(&from, &to)| crossings([from, to], scan, line, interpolation));
        let (mut first, mut last): (Option<End>, Option<End>) = (None, None);
        for end in ends {
            first = first.filter(|first| first.at <= end.at).or(Some(end));
            last = last.filter(|last| last.at >= end.at).or(Some(end));
        }
        Some(Self { ends: [first?, last?], interpolation })
    }

    /// Brightness at a place of the line between its ends; that of the nearer end outside.
    pub fn at(&self, place: f64) -> f64 {
        let [from, to] = self.ends;
        let length = to.at - from.at;
        if length <= 0.0 {
            return from.brightness;
        }
        let share = ((place - from.at) / length).clamp(0.0, 1.0);
        mixed(from.brightness, to.brightness, share_of(share, from.depth, to.depth, self.interpolation))
    }

    /// Change of brightness for each unit of the screen, where it is linear on the screen; 0 for a ramp without length.
    pub fn slope(&self) -> f64 {
        let [from, to] = self.ends;
        let length = to.at - from.at;
        if length > 0.0 { (to.brightness - from.brightness) / length } else { 0.0 }
    }
}

/// Where an edge meets a line: nowhere, once, or with both corners where it lies in the line.
fn crossings(edge: [ScreenCorner; 2], scan: Scan, line: f64, interpolation: Interpolation) -> Vec<End> {
    let (across, along) = match scan {
        Scan::Vertical => (0, 1),
        Scan::Horizontal => (1, 0),
    };
    let end = |corner: ScreenCorner| End {
        at: corner.at[along],
        depth: corner.depth,
        brightness: corner.brightness,
    };
    // From the lower to the upper corner, so that both faces of an edge have the same bits.
    let [low, high] = if edge[0].at[across] <= edge[1].at[across] { edge } else { [edge[1], edge[0]] };
    let [from, to] = [low, high].map(|corner| corner.at[across]);
    if line < from || line > to {
        return Vec::new();
    }
    if from == to {
        return vec![end(low), end(high)];
    }
    let share = (line - from) / (to - from);
    let in_depth = share_of(share, low.depth, high.depth, interpolation);
    vec![End {
        at: mixed(low.at[along], high.at[along], share),
        depth: 1.0 / mixed(1.0 / low.depth, 1.0 / high.depth, share),
        brightness: mixed(low.brightness, high.brightness, in_depth),
    }]
}

fn share_of(share: f64, from: f64, to: f64, interpolation: Interpolation) -> f64 {
    match interpolation {
        Interpolation::Screen => share,
        Interpolation::Perspective => in_space(share, [from, to]),
    }
}

fn mixed(from: f64, to: f64, share: f64) -> f64 {
    from * (1.0 - share) + to * share
}
