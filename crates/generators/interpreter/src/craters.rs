//! Craters in closed form (sections 9, 10), one after another, at unfolded sweep voltages.

use features::{Crater, Shape};

/// What all craters add at one place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Relief {
    /// Height above the terrain (m).
    pub height: f64,
    /// Slopes to the north and to the east.
    pub slopes: [f64; 2],
    /// Whether the place lies within any footprint.
    pub present: bool,
    /// Distance from the nearest circle on which a slope jumps, as a share of its radius.
    pub clear: f64,
}

/// A circle on which the slope jumps, where the sweep crosses it: ground range (m).
pub type Kink = f64;

/// A crater on a sweep.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Met {
    /// Crater of the list.
    pub crater: Crater,
    /// Ground range from which it is drawn (m); negative infinity if its words were in time.
    pub from: f64,
}

/// The sum over `craters` at a place relative to the eye's foot, (north, east) in metres, at a ground range (m); `foot` is that of the eye.
pub fn relief(craters: &[Met], foot: [f64; 2], place: [f64; 2], range: f64) -> Relief {
    let mut sum = Relief { height: 0.0, slopes: [0.0; 2], present: false, clear: f64::INFINITY };
    for Met { crater, from } in craters {
        if from.is_finite() {
            sum.clear = sum.clear.min((range - from).abs() / outermost(crater));
        }
        if range <= *from {
            continue;
        }
        let centre = crater.centre();
        let offset = [place[0] - (centre[0] - foot[0]), place[1] - (centre[1] - foot[1])];
        let rho = (offset[0] * offset[0] + offset[1] * offset[1]).sqrt();
        for circle in circles(crater) {
            sum.clear = sum.clear.min((rho - circle).abs() / circle);
        }
        let [height, outwards] = profile(crater, rho);
        sum.height += height;
        if rho > 0.0 {
            sum.slopes[0] += outwards * offset[0] / rho;
            sum.slopes[1] += outwards * offset[1] / rho;
        }
        sum.present |= rho < outermost(crater);
    }
    sum
}

/// Ground ranges beyond the foot at which a sweep crosses a circle of any crater, ascending.
pub fn kinks(craters: &[Met], foot: [f64; 2], direction: [f64; 2]) -> Vec<Kink> {
    let mut found = Vec::new();
    for Met { crater, from } in craters {
        let centre = crater.centre();
        let (north, east) = (centre[0] - foot[0], centre[1] - foot[1]);
        let along = north * direction[0] + east * direction[1];
        let beside = east * direction[0] - north * direction[1];
        for circle in circles(crater) {
            let half = circle * circle - beside * beside;
            if half > 0.0 {
                let both = [along - half.sqrt(), along + half.sqrt()];
                found.extend(both.into_iter().filter(|range| range >= from));
            }
        }
    }
    found.retain(|range| *range > 0.0);
    found.sort_by(f64::total_cmp);
    found
}

fn circles(crater: &Crater) -> Vec<f64> {
    match crater.shape() {
        Shape::Bowl { r1 } => vec![r1],
        Shape::RimmedBowl { r1, r2 } => vec![r1, r2],
        Shape::FlatFloor { r2, r3, .. } => vec![r2, r3],
    }
}

fn outermost(crater: &Crater) -> f64 {
    circles(crater).into_iter().fold(0.0, f64::max)
}

/// Height and its derivative outwards (section 9).
fn profile(crater: &Crater, rho: f64) -> [f64; 2] {
    let (a, delta) = (crater.depth(), crater.rim());
    let bowl = |rho: f64, radius: f64| {
        [a * (rho * rho / (radius * radius) - 1.0), 2.0 * a * rho / (radius * radius)]
    };
    let rim = |inner: f64, outer: f64| {
        let from_crest = 2.0 * rho - inner - outer;
        let width = outer - inner;
        [
            delta * (1.0 - (from_crest / width) * (from_crest / width)),
            -4.0 * delta * from_crest / (width * width),
        ]
    };
    match crater.shape() {
        Shape::Bowl { r1 } if rho < r1 => bowl(rho, r1),
        Shape::RimmedBowl { r1, .. } if rho < r1 => bowl(rho, r1),
        Shape::RimmedBowl { r1, r2 } if rho < r2 => rim(r1, r2),
        Shape::FlatFloor { r1, .. } if rho < r1 => [-a, 0.0],
        Shape::FlatFloor { r1, r2, .. } if rho < r2 => bowl(rho - r1, r2 - r1),
        Shape::FlatFloor { r2, r3, .. } if rho < r3 => rim(r2, r3),
        _ => [0.0; 2],
    }
}
