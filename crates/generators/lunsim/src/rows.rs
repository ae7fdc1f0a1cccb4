//! Rows of the grid as waveforms: what the program worked out of each point, block by block.

use generator::Stage;
use quantities::Timebase;
use scenario::View;
use signal::{Probe, Signal, Unit, Waveform, Wire};

use crate::film::Film;
use crate::projection::line;

/// Place of a row along the line of sight, and of a point across it.
pub(crate) const ALONG: &str = "lunsim.along";
pub(crate) const ACROSS: &str = "lunsim.across";

/// What can be looked at; a row of the grid stands for a sweep, its points for samples, from the nearest row and the
/// leftmost point on.
pub(crate) static SIGNALS: [Signal; 9] = [
    Signal::ground(ALONG, Unit::Metre, "place of the row along the line of sight", "appendix, block 10"),
    Signal::ground(ACROSS, Unit::Metre, "place of the point to the right of it", "appendix, block 10"),
    Signal::ground(
        "lunsim.height",
        Unit::Metre,
        "height, the drop of the lunoid taken off",
        "appendix, block 10",
    ),
    Signal::ground("lunsim.slope.along", Unit::Slope, "slope along the line of sight", "appendix, block 11"),
    Signal::ground("lunsim.slope.across", Unit::Slope, "slope across it", "appendix, block 12"),
    Signal::ground(
        "lunsim.reflectivity",
        Unit::Reflectivity,
        "light before remote shadow",
        "appendix, block 13",
    ),
    Signal::ground("lunsim.shadow", Unit::Gate, "high in shadow, local or remote", "appendix, block 13"),
    Signal::ground(
        "lunsim.line",
        Unit::Line,
        "line of plotting positions from the top; -1 above the picture or behind, their number below it",
        "appendix, block 14",
    ),
    Signal::ground("lunsim.code", Unit::Number, "intensity code of the recorder", "appendix, block 14"),
];

/// Clocks for as many rows and points as the grid has: the program had none, so the rows part a frame evenly.
pub(crate) fn timebase(view: &View, grid: u32) -> Option<Timebase> {
    Timebase::new(view.update, view.update, grid, grid, 0).ok()
}

/// The wires of a stage whose ground lies between the heights `low` and `high` (m). Numbers of a program have no voltage.
pub(crate) fn wires(stage: &Stage, codes: u32, [low, high]: [f64; 2]) -> Vec<Wire> {
    let wire = |signal: &Signal| {
        let [datum, full_scale] = match (signal.unit, signal.name) {
            (Unit::Metre, "lunsim.height") => [0.5 * (low + high), (0.5 * (high - low)).max(1.0)],
            (Unit::Metre, _) => [0.0, stage.view.ranges[1]],
            (Unit::Line, _) => [0.0, crate::POSITIONS as f64],
            (Unit::Number, _) => [0.0, f64::from(codes - 1)],
            _ => [0.0, 1.0],
        };
        Wire { signal: *signal, full_scale, volts: 0.0, datum }
    };
    SIGNALS.iter().map(wire).collect()
}

/// Records the rows of `film` that `probe` wants, of a grid of `size` x `size` points; without a film, as nothing is in
/// view, all is 0.
pub(crate) fn record(frame: u64, size: usize, film: Option<&Film<'_>>, probe: &mut Probe) {
    for row in 0..size {
        if !probe.wants_sweep(row as u32) {
            continue;
        }
        for signal in SIGNALS {
            if probe.wants(&signal) {
                let read = reading(signal.name);
                let value = |column: usize| film.map_or(0.0, |film| read(film, row, column));
                let values = (0..size).map(value).collect();
                probe.waveforms.push(Waveform {
                    signal,
                    frame,
                    sweep: row as u32,
                    times: Vec::new(),
                    values,
                });
            }
        }
    }
}

/// How the signal called `name` is read off a film, at a row and a column.
fn reading(name: &str) -> fn(&Film<'_>, usize, usize) -> f64 {
    match name {
        ALONG => |film, row, column| film.grid.place(row, column)[0],
        ACROSS => |film, row, column| film.grid.place(row, column)[1],
        "lunsim.height" => |film, row, column| film.grid.heights[row * film.grid.size + column],
        "lunsim.slope.along" => |film, row, column| film.grid.slopes(row, column)[0],
        "lunsim.slope.across" => |film, row, column| film.grid.slopes(row, column)[1],
        "lunsim.reflectivity" => |film, row, column| film.light[row * film.grid.size + column].reflectivity,
        "lunsim.shadow" => {
            |film, row, column| f64::from(u8::from(film.light[row * film.grid.size + column].is_dark()))
        }
        "lunsim.line" => line_of,
        "lunsim.code" => |film, row, column| f64::from(film.code(row * film.grid.size + column)),
        _ => unreachable!("{name} is none of LUNSIM's signals"),
    }
}

fn line_of(film: &Film<'_>, row: usize, column: usize) -> f64 {
    let Film { grid, observer, plot, .. } = film;
    let height = grid.heights[row * grid.size + column] - observer.eye[2];
    let place = observer.project(grid.place(row, column), height);
    place.map_or(-1.0, |[_, y]| f64::from(line(y, observer.half_field[1], plot.size[1])))
}
