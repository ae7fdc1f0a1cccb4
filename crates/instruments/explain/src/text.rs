//! An explanation in words.

use quantities::fixed;

use crate::ground::GroundPoint;
use crate::{Explanation, Late, LateLoad};

impl Explanation {
    /// What is said of the pixel, for people: why it is so, then every wire at the sample.
    pub fn text(&self) -> String {
        let told = self;
        let place = &told.place;
        let [x, y] = told.pixel;
        let mut lines = vec![format!(
            "frame {} ({:.3} s), pixel {x},{y}: {} of full scale",
            told.frame,
            told.time_s,
            fixed(told.intensity, 4)
        )];
        lines.extend(told.because.iter().map(|reason| format!("  - {reason}")));
        lines.push(String::new());
        let [sweep, cell] = [place.between_sweeps, place.between_cells].map(|at| fixed(at, 3));
        lines.push(row("read beam", &format!("sweep {sweep}, cell {cell} of {}", place.cells)));
        lines.extend(told.between.map(|between| {
            let as_drawn = format!(
                "{:.4}; the picture is drawn straight between {} instants a step (docs/economy.md)",
                between.whole, between.instants
            );
            row("whole machine", &as_drawn)
        }));
        lines.push(row(
            "sm.write",
            &format!("{:.4} in cell {} of sweep {}", told.left, place.cell, place.sweep),
        ));
        let others = told.read.iter().filter(|read| read.sweep != place.sweep);
        lines.extend(others.map(|read| {
            row(
                "",
                &format!(
                    "{:.4} in the same cell of sweep {}, {:.0} % of what is read",
                    read.left,
                    read.sweep,
                    100.0 * read.weight
                ),
            )
        }));
        lines.extend(told.body.map(|light| row("pg", &format!("present, reflectivity {light:.4}"))));
        lines.extend(told.ground.iter().flat_map(ground_rows));
        lines.extend(told.late.iter().map(late_row));
        let Some(exact) = &told.exact else { return lines.join("\n") + "\n" };
        let on_ground =
            |range| format!(" at {range:.2} m, {} m high, {}", fixed(exact.height_m, 3), exact.shade);
        let place = exact.range_m.map_or_else(String::new, on_ground);
        lines.push(row("exact", &format!("{:.4}: {}{place}", exact.intensity, exact.label)));
        lines.join("\n") + "\n"
    }
}

fn row(name: &str, value: &str) -> String {
    format!("{name:<18} {value}")
}

fn ground_rows(ground: &GroundPoint) -> Vec<String> {
    let [north, east] = ground.place_m.map(|place| fixed(place, 2));
    let [x, y] = ground.ramps.map(|ramp| fixed(ramp, 4));
    let [u, v] = ground.terrain_slopes.map(|slope| fixed(slope, 4));
    let gate = |on: bool| if on { "on" } else { "off" };
    let level = if ground.level == "coarse" { "coarse." } else { "" };
    let mut rows = vec![
        row("sample", &format!("{}, {:.3} µs", ground.sample, ground.time_us)),
        row("sweep.range", &format!("{:.2} m: {north} m north, {east} m east", ground.range_m)),
        row(
            &format!("sweep.{level}x, sweep.{level}y"),
            &format!("{x}, {y}; s_x {:+}, s_y {:+}", ground.polarity[0], ground.polarity[1]),
        ),
        row("region", &format!("{}, {} of the {} level", ground.region[0], ground.region[1], ground.level)),
    ];
    rows.extend(ground.colours.iter().map(|colour| {
        let corner = |place: [i64; 2]| format!("{}, {}", place[0], place[1]);
        let held = colour.held.map_or_else(|| "nothing".to_owned(), corner);
        let share = format!(", adds {} m", fixed(colour.height_m, 3));
        let stale =
            if colour.stale { format!(" STALE: wants {}", corner(colour.wanted)) } else { String::new() };
        row(&format!("tg.{level}{}.hold", colour.colour), &format!("corner {held}{share}{stale}"))
    }));
    rows.extend([
        row("tg.height", &format!("{} m", fixed(ground.terrain_height_m, 3))),
        row("tg.slope", &format!("{u} north, {v} east")),
        row("tg.reflectivity", &format!("{:.4}", ground.terrain_reflectivity)),
        row("fg.height", &format!("{} m{}", fixed(ground.feature_height_m, 3), craters(&ground.craters))),
        row("mu.vs1, sc.gate", &format!("{}, {}", gate(ground.features_shown), gate(ground.in_shadow))),
        row("txg.texture", &format!("{:.4}{}", ground.texture, gain(ground.grain))),
        row(
            "mu",
            &format!("height {} m, reflectivity {:.4}", fixed(ground.height_m, 3), ground.reflectivity),
        ),
        row(
            "dpp",
            &format!(
                "elevation {}, hold {}, line {}",
                fixed(ground.elevation, 6),
                fixed(ground.hold, 6),
                fixed(ground.line, 3)
            ),
        ),
    ]);
    rows.extend(ground.elevation_change.map(|change| {
        let way = if change < 0.0 { "falls" } else { "does not fall" };
        row("dpp.derivative", &format!("{} a µs: the elevation {way}", fixed(change, 6)))
    }));
    rows.push(row("sm.video", &format!("{:.4}", ground.video)));
    rows.extend(
        ground
            .hides_m
            .map(|[near, far]| row("dpp.blank", &format!("hides the ground from {near:.1} to {far:.1} m"))),
    );
    rows
}

/// What craters make of the texture, if they change it.
fn gain(grain: f64) -> String {
    if grain == 0.0 {
        String::new()
    } else {
        format!(", craters have it {:.3} times", (1.0 + grain).max(0.0))
    }
}

fn craters(numbers: &[u32]) -> String {
    match numbers {
        [] => String::new(),
        _ => format!(": craters {}", numbers.iter().map(u32::to_string).collect::<Vec<_>>().join(", ")),
    }
}

/// When words came, for people.
fn came(at: Option<f64>) -> String {
    at.map_or_else(|| "never came".to_owned(), |came| format!("came at {came:.2}"))
}

/// Words of a crater or a shadow boundary, in a line.
pub(crate) fn late_load_row(load: &LateLoad) -> String {
    let LateLoad { part, range_m, due, words, cause, .. } = load;
    let came = came(load.came);
    row(part, &format!("at {range_m:.2} m: due at sample {due:.2}, {came}, words {words}, {cause}"))
}

pub(crate) fn late_row(late: &Late) -> String {
    let came = came(late.came);
    let force = if late.in_force { ", in force" } else { "" };
    row(
        "dpu.late",
        &format!(
            "{}, {} {}: due at sample {:.2}, {came}, words {:#05x}, {}{force}",
            late.place(),
            late.colour,
            late.register,
            late.due,
            late.words,
            late.cause
        ),
    )
}
