//! A parked rover for two, seats empty.

use quantities::{radians, sin_cos};

use super::{Parts, boxed, drum, plate, strut};

const FRAME: f64 = 0.75;
const WHITE: f64 = 0.95;
const DARK: f64 = 0.25;

/// Half the wheelbase and half the track (m), and the wheels.
const AXLE: f64 = 1.15;
const TRACK: f64 = 0.915;
const RADIUS: f64 = 0.41;
const HALF_WIDTH: f64 = 0.115;

pub(super) fn parts() -> Parts {
    let mut parts = chassis()?;
    for (ahead, side) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
        parts.extend(wheel(ahead, side)?);
    }
    for side in [-0.4, 0.4] {
        parts.extend(seat(side)?);
    }
    parts.extend(console()?);
    parts.extend(antennas()?);
    parts.extend(stowage()?);
    Ok(parts)
}

fn chassis() -> Parts {
    Ok(vec![
        boxed([-0.75, -0.5, 0.5], [0.75, 0.5, 0.58], FRAME)?,
        boxed([0.75, -0.45, 0.5], [1.5, 0.45, 0.6], FRAME)?,
        boxed([-1.55, -0.45, 0.5], [-0.75, 0.45, 0.6], FRAME)?,
        // Batteries and electronics under their white covers.
        boxed([0.85, -0.42, 0.6], [1.32, 0.02, 0.8], WHITE)?,
        boxed([0.85, 0.06, 0.6], [1.32, 0.42, 0.76], WHITE)?,
        boxed([1.36, -0.22, 0.58], [1.55, 0.22, 0.95], WHITE)?,
        // Foot rests.
        boxed([0.4, -0.5, 0.58], [0.72, 0.5, 0.62], FRAME)?,
    ])
}

fn wheel(ahead: f64, side: f64) -> Parts {
    let (x, y) = (ahead * AXLE, side * TRACK);
    let rim = |off: f64| [x, y + off, RADIUS];
    let mut parts = vec![
        drum([rim(-HALF_WIDTH), rim(HALF_WIDTH)], [RADIUS; 2], 20, 0.5)?
            .painted(|normal| if normal.y.abs() > 0.5 { 0.6 } else { 0.4 })?,
        drum([rim(-HALF_WIDTH - 0.02), rim(HALF_WIDTH + 0.02)], [0.14; 2], 10, WHITE)?,
    ];
    let inboard = y - side * HALF_WIDTH;
    for up in [-0.06, 0.1] {
        parts.push(strut([0.8 * x, 0.45 * side, 0.53 + 0.3 * up], [x, inboard, RADIUS + up], 0.05, FRAME)?);
    }
    // A fender of four plates, from behind the top to the front.
    let over = |degrees: f64| {
        let (sin, cos) = sin_cos(radians(degrees));
        [x + ahead * 0.49 * cos, RADIUS + 0.49 * sin]
    };
    for plate_number in 0..4 {
        let start = 44.0 + 30.0 * f64::from(plate_number);
        let ([x0, z0], [x1, z1]) = (over(start), over(start + 30.0));
        let (left, right) = (y - 0.15, y + 0.15);
        parts.push(plate(&[[x0, left, z0], [x1, left, z1], [x1, right, z1], [x0, right, z0]], 0.012, 0.8)?);
    }
    Ok(parts)
}

fn seat(y: f64) -> Parts {
    let (left, right) = (y - 0.25, y + 0.25);
    let mut parts = vec![
        boxed([-0.4, left, 0.84], [0.1, right, 0.89], 0.65)?,
        plate(
            &[[-0.38, left, 0.92], [-0.55, left, 1.4], [-0.55, right, 1.4], [-0.38, right, 0.92]],
            0.04,
            0.65,
        )?,
    ];
    for x in [-0.36, 0.06] {
        for side in [left + 0.03, right - 0.03] {
            parts.push(strut([x, side, 0.57], [x, side, 0.85], 0.03, FRAME)?);
        }
    }
    Ok(parts)
}

fn console() -> Parts {
    Ok(vec![
        strut([0.38, 0.0, 0.57], [0.33, 0.0, 1.05], 0.06, FRAME)?,
        plate(&[[0.28, -0.18, 0.98], [0.4, -0.18, 1.26], [0.4, 0.18, 1.26], [0.28, 0.18, 0.98]], 0.1, DARK)?,
        boxed([-0.1, -0.09, 0.88], [0.2, 0.09, 0.95], 0.5)?,
        strut([0.12, 0.0, 0.93], [0.14, 0.0, 1.06], 0.03, DARK)?,
        strut([0.14, -0.07, 1.05], [0.14, 0.07, 1.05], 0.03, DARK)?,
    ])
}

fn antennas() -> Parts {
    // The dish looks at an Earth high in the sky, ahead and to port.
    let [x, y, z] = [1.05, -0.33, 1.95];
    let looks = |by: f64| [x + 0.35 * by, y - 0.3 * by, z + 0.89 * by];
    Ok(vec![
        strut([x, y, 0.6], [x, y, z], 0.045, FRAME)?,
        drum([looks(0.0), looks(0.16)], [0.08, 0.48], 14, 0.85)?,
        strut(looks(0.1), looks(0.42), 0.025, FRAME)?,
        drum([looks(0.38), looks(0.46)], [0.06, 0.06], 8, FRAME)?,
        // Low-gain antenna, aimed by hand.
        strut([0.62, 0.12, 0.6], [0.7, 0.12, 1.45], 0.03, FRAME)?,
        drum([[0.7, 0.12, 1.42], [0.78, 0.1, 1.68]], [0.05, 0.05], 8, WHITE)?,
        // Television camera.
        strut([1.45, 0.33, 0.6], [1.45, 0.33, 1.12], 0.04, FRAME)?,
        boxed([1.28, 0.25, 1.1], [1.55, 0.41, 1.24], WHITE)?,
        drum([[1.47, 0.33, 1.17], [1.55, 0.33, 1.17]], [0.05, 0.06], 8, DARK)?,
    ])
}

/// Rack for tools and bags behind the seats.
fn stowage() -> Parts {
    Ok(vec![
        strut([-1.42, -0.42, 0.6], [-1.42, -0.42, 1.25], 0.04, FRAME)?,
        strut([-1.42, 0.42, 0.6], [-1.42, 0.42, 1.25], 0.04, FRAME)?,
        strut([-1.42, -0.42, 1.24], [-1.42, 0.42, 1.24], 0.04, FRAME)?,
        boxed([-1.4, -0.38, 0.6], [-1.05, -0.02, 0.98], 0.8)?,
        boxed([-1.4, 0.04, 0.6], [-1.1, 0.36, 0.88], WHITE)?,
        boxed([-1.52, -0.36, 0.85], [-1.44, 0.36, 1.18], 0.7)?,
        boxed([-0.95, -0.45, 0.6], [-0.65, 0.45, 0.72], 0.6)?,
        // A scoop and tongs upright in the rack.
        strut([-1.43, 0.2, 0.8], [-1.46, 0.22, 1.6], 0.02, FRAME)?,
        strut([-1.43, -0.15, 0.8], [-1.46, -0.18, 1.5], 0.02, FRAME)?,
    ])
}
