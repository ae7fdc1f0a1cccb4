//! Sources that follow a list of points, and lags.

use std::fmt::Write;

use crate::{EDGE, PULSE};

/// Points of a line ahead are written in rows of so many.
const ROW: usize = 6;

/// A voltage source that goes straight from point to point (s, full scales).
pub fn straight(name: &str, points: &[[f64; 2]]) -> String {
    let mut text = format!("V{name} {name} 0 PWL(");
    for (number, [time, value]) in points.iter().enumerate() {
        if number > 0 && number % ROW == 0 {
            text += "\n+";
        }
        let _ = write!(text, " {time:.15e} {value:.15e}");
    }
    text += ")\n";
    text
}

/// A level that a source takes at an instant, and the area of a pulse that comes with it.
#[derive(Debug, Clone, Copy)]
pub struct Level {
    /// Instant of the jump (s).
    pub at: f64,
    /// Level from then on (full scales).
    pub level: f64,
    /// Area of the pulse (full scales times seconds).
    pub pulse: f64,
}

/// A voltage source that jumps from level to level; the first is there from the beginning.
pub fn stairs(name: &str, levels: &[Level]) -> String {
    let mut points: Vec<[f64; 2]> = Vec::new();
    let mut put = |time: f64, value: f64| {
        let after = points.last().map_or(0.0, |[last, _]| last + EDGE);
        points.push([if points.is_empty() { 0.0 } else { time.max(after) }, value]);
    };
    let mut before = None;
    for &Level { at, level, pulse } in levels {
        match before {
            None => put(0.0, level),
            Some(before) if pulse != 0.0 => {
                put(at, before);
                put(at + EDGE, level + pulse / PULSE);
                put(at + PULSE, level + pulse / PULSE);
                put(at + PULSE + EDGE, level);
            }
            Some(before) if before != level => {
                put(at, before);
                put(at + EDGE, level);
            }
            Some(_) => {}
        }
        before = Some(level);
    }
    straight(name, &points)
}

/// A lag from node `from` to node `to`: one pole, or a wire.
pub fn lag(from: &str, to: &str, tau: f64, text: &mut String) {
    let _ = match tau {
        0.0 => writeln!(text, "R{to} {from} {to} 1e-6"),
        tau => writeln!(text, "R{to} {from} {to} 1\nC{to} {to} 0 {tau:.15e}"),
    };
}
