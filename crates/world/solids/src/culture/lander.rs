//! A two-stage lander on four legs.

use quantities::{radians, sin_cos};

use super::{Parts, at, boxed, drum, plate, strut};
use crate::{Solid, SolidError};

/// Foil, bare metal, and blackened panels.
const FOIL: f64 = 0.75;
const METAL: f64 = 0.85;
const BLACK: f64 = 0.3;

/// Bottom and top of the descent stage (m).
const KEEL: f64 = 1.55;
const DECK: f64 = 3.15;

pub(super) fn parts() -> Parts {
    let mut parts = descent_stage()?;
    for turn in 0..4 {
        parts.extend(leg(turn)?);
    }
    parts.extend(ladder()?);
    parts.extend(ascent_stage()?);
    parts.extend(windows()?);
    for (x, y) in [(1.4, 1.75), (1.4, -1.75), (-1.5, 1.75), (-1.5, -1.75)] {
        parts.extend(thrusters(x, y)?);
    }
    parts.extend(antennas()?);
    Ok(parts)
}

fn descent_stage() -> Parts {
    let rim = [
        (2.1, 0.9),
        (0.9, 2.1),
        (-0.9, 2.1),
        (-2.1, 0.9),
        (-2.1, -0.9),
        (-0.9, -2.1),
        (0.9, -2.1),
        (2.1, -0.9),
    ];
    let octagon = |low: f64, high: f64, scale: f64, albedo: f64| {
        let points: Vec<_> = rim
            .iter()
            .flat_map(|&(x, y)| [at(x * scale, y * scale, low), at(x * scale, y * scale, high)])
            .collect();
        Solid::hull(&points, albedo)
    };
    let stage = octagon(KEEL, DECK - 0.12, 1.0, FOIL)?.painted(|normal| {
        let diagonal = normal.x.abs() > 0.3 && normal.y.abs() > 0.3;
        if diagonal {
            0.5
        } else if normal.z < -0.5 {
            BLACK
        } else {
            FOIL
        }
    })?;
    Ok(vec![
        stage,
        octagon(DECK - 0.12, DECK, 1.02, 0.35)?,
        octagon(KEEL - 0.1, KEEL, 0.9, BLACK)?,
        drum([[0.0, 0.0, KEEL], [0.0, 0.0, 0.5]], [0.4, 0.76], 14, 0.35)?,
        stowage(1.0, 0.55)?,
        stowage(-1.0, 0.75)?,
    ])
}

/// An upright box on the diagonal face forward to starboard, or on the one opposite.
fn stowage(end: f64, half_width: f64) -> Result<Solid, SolidError> {
    let place = |out: f64, side: f64, up: f64| at(end * (out + side), end * (out - side), up);
    let corner = |&[out, up]: &[f64; 2]| [place(out, -half_width, up), place(out, half_width, up)];
    let section = [[1.4, 1.75], [1.72, 1.75], [1.4, 2.85], [1.72, 2.6]];
    Solid::hull(&section.iter().flat_map(corner).collect::<Vec<_>>(), 0.65)
}

/// A tank that lies along the ship, with rounded ends.
fn tank(y: f64) -> Result<Solid, SolidError> {
    let rings = [(-1.0, 0.45), (-0.75, 0.74), (0.7, 0.74), (0.95, 0.45)];
    let ring = |&(x, radius): &(f64, f64)| {
        (0..8).map(move |side| {
            let (sin, cos) = sin_cos(radians(22.5 + 45.0 * f64::from(side)));
            at(x, y + radius * sin, 4.0 + radius * cos)
        })
    };
    Solid::hull(&rings.iter().flat_map(ring).collect::<Vec<_>>(), 0.72)
}

/// A leg `turn` quarter turns clockwise from forward.
fn leg(turn: usize) -> Parts {
    // `out` from the middle along the leg, `side` square to it.
    let place = |out: f64, side: f64, up: f64| {
        let (x, y) = [(out, side), (-side, out), (-out, -side), (side, -out)][turn];
        [x, y, up]
    };
    let knee = place(3.45, 0.0, 1.22);
    let shoulder = place(2.32, 0.0, 2.72);
    let mut parts = vec![
        strut(shoulder, knee, 0.19, METAL)?,
        strut(knee, place(4.22, 0.0, 0.2), 0.13, 0.95)?,
        drum([place(4.22, 0.0, -0.03), place(4.22, 0.0, 0.14)], [0.34, 0.48], 12, FOIL)?,
        drum([place(4.22, 0.0, 0.14), place(4.22, 0.0, 0.2)], [0.48, 0.2], 12, FOIL)?,
    ];
    for side in [-0.88, 0.88] {
        parts.push(strut(place(2.02, side, DECK - 0.2), shoulder, 0.11, FOIL)?);
        parts.push(strut(place(2.02, side, KEEL + 0.1), shoulder, 0.08, FOIL)?);
        parts.push(strut(place(2.02, side, KEEL + 0.1), knee, 0.1, FOIL)?);
    }
    Ok(parts)
}

/// Porch, rails and rungs on the forward leg.
fn ladder() -> Parts {
    let mut parts = vec![boxed([2.05, -0.42, DECK - 0.02], [2.95, 0.42, DECK + 0.03], METAL)?];
    let rail = |share: f64| [2.75 + 1.12 * share, DECK - 2.1 * share];
    for side in [-0.24, 0.24] {
        let ([x0, z0], [x1, z1]) = (rail(0.0), rail(1.0));
        parts.push(strut([x0, side, z0], [x1, side, z1], 0.05, METAL)?);
        parts.push(strut([2.1, 1.6 * side, DECK + 0.75], [2.85, 1.6 * side, DECK + 0.6], 0.035, METAL)?);
        parts.push(strut([2.85, 1.6 * side, DECK], [2.85, 1.6 * side, DECK + 0.6], 0.035, METAL)?);
    }
    for rung in 1..=9 {
        let [x, z] = rail(f64::from(rung) / 9.5);
        parts.push(strut([x, -0.24, z], [x, 0.24, z], 0.04, METAL)?);
    }
    Ok(parts)
}

fn ascent_stage() -> Parts {
    let shaded = |normal: glam::DVec3| 0.62 + 0.18 * (normal.x * normal.y).abs() + 0.1 * normal.z.max(0.0);
    Ok(vec![
        // Cabin: a drum along the forward axis, and a face in front of it.
        drum([[0.5, 0.0, 4.55], [1.85, 0.0, 4.55]], [1.22, 1.22], 12, METAL)?.painted(shaded)?,
        face()?.painted(shaded)?,
        // Midsection, equipment bay, tanks to both sides (the lighter fuel stands farther out).
        midsection()?.painted(|normal| if normal.y.abs() > 0.5 { 0.5 } else { 0.75 })?,
        boxed([-2.05, -1.1, 3.4], [-1.35, 1.1, 5.1], 0.55)?,
        tank(-1.72)?,
        tank(1.55)?,
        boxed([-0.7, -1.72, 3.2], [0.6, 1.6, 3.9], 0.45)?,
        drum([[0.0, 0.0, 5.7], [0.0, 0.0, 6.2]], [0.46, 0.42], 12, METAL)?,
        boxed([-1.2, -0.75, 5.7], [-0.5, 0.75, 5.95], 0.65)?,
    ])
}

fn face() -> Result<Solid, SolidError> {
    let points = [
        at(2.2, -0.72, 3.5),
        at(2.2, 0.72, 3.5),
        at(2.25, -0.8, 4.75),
        at(2.25, 0.8, 4.75),
        at(1.95, -0.45, 5.6),
        at(1.95, 0.45, 5.6),
        at(1.8, -1.15, 4.2),
        at(1.8, 1.15, 4.2),
        at(1.8, -1.1, 5.0),
        at(1.8, 1.1, 5.0),
        at(1.8, -0.45, 5.68),
        at(1.8, 0.45, 5.68),
        at(1.8, -0.6, 3.5),
        at(1.8, 0.6, 3.5),
    ];
    Solid::hull(&points, METAL)
}

/// Wider below than above.
fn midsection() -> Result<Solid, SolidError> {
    let section = [(1.2, DECK), (1.2, 5.0), (0.8, 5.75)];
    let ends = [-1.35, 0.55];
    let points: Vec<_> = ends
        .iter()
        .flat_map(|&x| section.iter().flat_map(move |&(y, z)| [at(x, y, z), at(x, -y, z)]))
        .collect();
    Solid::hull(&points, METAL)
}

/// Two triangular windows and the hatch below them, a little proud of the face.
fn windows() -> Parts {
    let mut parts =
        vec![plate(&[[2.23, -0.4, 3.6], [2.23, 0.4, 3.6], [2.26, 0.4, 4.4], [2.26, -0.4, 4.4]], 0.05, 0.5)?];
    for side in [-1.0, 1.0] {
        let corners = [[2.075, 0.16 * side, 5.28], [2.1, 0.55 * side, 5.2], [2.235, 0.36 * side, 4.82]];
        parts.push(plate(&corners, 0.05, 0.05)?);
    }
    Ok(parts)
}

/// A cluster of thrusters on an outrigger.
fn thrusters(x: f64, y: f64) -> Parts {
    let z = 4.65;
    let outwards = y.signum();
    let mut parts = vec![
        boxed([x - 0.13, y - 0.13, z - 0.13], [x + 0.13, y + 0.13, z + 0.13], METAL)?,
        strut([x * 0.75, y * 0.6, z - 0.25], [x, y, z], 0.07, METAL)?,
        strut([x * 0.75, y * 0.6, z + 0.25], [x, y, z], 0.07, METAL)?,
    ];
    for nozzle in
        [[0.0, 0.0, 0.36], [0.0, 0.0, -0.36], [0.0, 0.36 * outwards, 0.0], [0.36 * x.signum(), 0.0, 0.0]]
    {
        let [dx, dy, dz] = nozzle;
        let inner = [x + 0.3 * dx, y + 0.3 * dy, z + 0.3 * dz];
        parts.push(drum([inner, [x + dx, y + dy, z + dz]], [0.04, 0.1], 8, 0.4)?);
    }
    Ok(parts)
}

fn antennas() -> Parts {
    Ok(vec![
        // Rendezvous radar above the face.
        strut([1.3, 0.0, 5.6], [1.6, 0.0, 6.15], 0.12, METAL)?,
        drum([[1.62, 0.0, 6.15], [1.78, 0.0, 6.2]], [0.12, 0.36], 12, 0.9)?,
        // Steerable dish to starboard, looking up.
        strut([0.9, 0.9, 5.4], [1.0, 1.4, 6.3], 0.07, METAL)?,
        drum([[1.0, 1.4, 6.3], [1.08, 1.47, 6.46]], [0.08, 0.36], 12, 0.9)?,
        strut([-0.9, 0.7, 5.7], [-0.9, 0.7, 7.0], 0.03, METAL)?,
        strut([-0.9, -0.7, 5.7], [-0.9, -0.7, 6.7], 0.03, METAL)?,
    ])
}
