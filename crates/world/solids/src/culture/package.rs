//! A package of instruments: central station with mast and panels, power source, seismometer, magnetometer.

use quantities::{radians, sin_cos};

use super::{Parts, boxed, drum, plate, strut};

pub(super) fn parts() -> Parts {
    let mut parts = station()?;
    parts.extend(power_source([-2.2, 1.3])?);
    parts.extend(seismometer([1.9, -1.3])?);
    parts.extend(magnetometer([1.7, 1.9])?);
    Ok(parts)
}

fn station() -> Parts {
    let mut parts = vec![
        boxed([-0.34, -0.3, 0.02], [0.34, 0.3, 0.3], 0.85)?,
        boxed([-0.38, -0.34, 0.52], [0.38, 0.34, 0.55], 0.95)?,
        strut([0.2, 0.0, 0.5], [0.2, 0.0, 1.55], 0.035, 0.8)?,
        drum([[0.2, 0.0, 1.5], [0.38, -0.12, 2.0]], [0.06, 0.05], 8, 0.9)?,
        drum([[0.17, 0.02, 1.46], [0.2, 0.0, 1.52]], [0.14, 0.14], 10, 0.7)?,
    ];
    for (x, y) in [(-0.33, -0.29), (-0.33, 0.29), (0.33, -0.29), (0.33, 0.29)] {
        parts.push(strut([x, y, 0.28], [x, y, 0.53], 0.025, 0.7)?);
    }
    for side in [-1.0, 1.0] {
        let (near, far) = (0.45 * side, 1.05 * side);
        let corners = [[-0.6, near, 0.95], [0.6, near, 0.95], [0.6, far, 0.2], [-0.6, far, 0.2]];
        parts.push(plate(&corners, 0.03, 0.3)?);
        for x in [-0.5, 0.5] {
            parts.push(strut([x, near, 0.93], [x, near, -0.02], 0.025, 0.7)?);
            parts.push(strut([x, far, 0.2], [x, far, -0.02], 0.025, 0.7)?);
        }
    }
    Ok(parts)
}

/// A cask with radial fins.
fn power_source([x, y]: [f64; 2]) -> Parts {
    let mut parts = vec![
        boxed([x - 0.33, y - 0.33, -0.02], [x + 0.33, y + 0.33, 0.05], 0.6)?,
        drum([[x, y, 0.05], [x, y, 0.5]], [0.15, 0.15], 12, 0.35)?,
    ];
    for fin in 0..8 {
        let (sin, cos) = sin_cos(radians(45.0 * f64::from(fin)));
        let place = |out: f64, z: f64| [x + out * cos, y + out * sin, z];
        parts.push(plate(
            &[place(0.12, 0.08), place(0.27, 0.08), place(0.27, 0.48), place(0.12, 0.48)],
            0.012,
            0.4,
        )?);
    }
    Ok(parts)
}

/// A drum on a round skirt of foil.
fn seismometer([x, y]: [f64; 2]) -> Parts {
    Ok(vec![
        drum([[x, y, -0.01], [x, y, 0.05]], [0.75, 0.7], 16, 0.95)?,
        drum([[x, y, 0.05], [x, y, 0.36]], [0.16, 0.14], 12, 0.85)?,
    ])
}

/// Three booms with a sensor each, on legs.
fn magnetometer([x, y]: [f64; 2]) -> Parts {
    let mut parts = vec![boxed([x - 0.12, y - 0.12, 0.42], [x + 0.12, y + 0.12, 0.68], 0.9)?];
    for boom in 0..3 {
        let (sin, cos) = sin_cos(radians(20.0 + 120.0 * f64::from(boom)));
        let place = |out: f64, z: f64| [x + out * cos, y + out * sin, z];
        parts.push(strut(place(0.05, 0.6), place(0.85, 0.8), 0.03, 0.8)?);
        parts.push(strut(place(0.05, 0.45), place(0.4, -0.02), 0.03, 0.7)?);
        let [east, north, up] = place(0.9, 0.8);
        let half = 0.07;
        parts.push(boxed(
            [east - half, north - half, up - half],
            [east + half, north + half, up + half],
            0.9,
        )?);
    }
    Ok(parts)
}
