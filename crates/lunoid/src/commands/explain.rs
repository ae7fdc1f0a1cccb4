//! `lunoid explain`: from a pixel of a frame to the wires that made it.

use clap::Args;
use exact::Columns;
use explain::{Explanation, GroundPoint, Inquiry, InquiryError, Late};
use machine::Prepare;
use quantities::fixed;

use crate::commands::again::command;
use crate::frame::FrameArgs;
use crate::loading::of_models;
use crate::output::{print, print_json};
use crate::values::pixel;
use crate::{Failure, Verdict};

const AFTER: &str = "Examples:
  lunoid explain scenarios/first-light.toml --frame 60 --pixel 500,300
  lunoid explain scenarios/nominal-drive.toml --frame 45 --pixel 210,260 --json

The first lines say why, the table has every wire at the sample, the last lines are commands that go on from there: the sweep
on a page of the scope, the registers at the sample, the digital events of the sweep.";

/// Say which sweep and sample made a pixel, and what every block did there.
#[derive(Debug, Args)]
#[command(after_help = AFTER, mut_args(of_models))]
pub struct Explain {
    #[command(flatten)]
    chosen: FrameArgs,
    /// Pixel: column and line, from 0 at the top left.
    #[arg(long, value_name = "X,Y", value_parser = pixel, allow_hyphen_values = true)]
    pixel: [usize; 2],
    /// Leave the closed form out, and with it the error.
    #[arg(long)]
    no_exact: bool,
    /// Print as JSON.
    #[arg(long)]
    json: bool,
}

impl Explain {
    /// Explains.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let frame = self.chosen.frame;
        let rehearsal = self.chosen.rehearse(|_| Ok(()))?;
        let pose = rehearsal.poses(&[frame])?[0].pose;
        let session = rehearsal.stage.clone().prepare();
        let exact = (!self.no_exact).then(|| Columns::new(rehearsal.stage.stage()));
        let inquiry = Inquiry::new(&rehearsal.stage, session.as_ref(), &rehearsal.control, exact.as_ref());
        let told = rehearsal.pool.install(|| inquiry.explain(frame, &pose, self.pixel));
        let told = told.map_err(|error| match error {
            InquiryError::Pixel { .. } => Failure::usage(format!("--pixel: {error}")),
            InquiryError::Frame(error) => Failure::input(error),
        })?;
        if self.json {
            let mut document = serde_json::to_value(&told).map_err(Failure::input)?;
            document["schema"] = "lunoid.explain/1".into();
            print_json(&document)?;
        } else {
            print(&(text(&told) + "\n" + &self.next(&told)))?;
        }
        Ok(Verdict::Yes)
    }

    /// Commands that go on from the pixel: its wires on a page of the scope, its registers and what was loaded into them.
    fn next(&self, told: &Explanation) -> String {
        let (stage, frame, sweep) = (&self.chosen.stage, self.chosen.frame, told.place.sweep);
        let cursor = told.ground.as_ref().map(|ground| format!(" --cursor {:.4}", ground.range_m));
        let page = format!(
            "--sweep {sweep} --signals 'tg.reflectivity,mu.*,sc.gate,dpp.*,sm.video'{} --out sweep.png",
            cursor.unwrap_or_default()
        );
        // Polyhedra join along the line of the display, not along the sweep: a table, not a page.
        let body =
            told.body.map(|_| ("probe", format!("--sweep {sweep} --signals 'pg.*,sm.write' --out body.csv")));
        let registers =
            told.ground.as_ref().map(|ground| ("trace", format!("--at {sweep}:{}", ground.sample)));
        let commands = [("probe", page)]
            .into_iter()
            .chain(body)
            .chain(registers)
            .chain([("trace", format!("--sweep {sweep}"))]);
        commands.map(|(name, rest)| command(name, stage, frame, &rest) + "\n").collect()
    }
}

fn text(told: &Explanation) -> String {
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
    lines.push(row("sm.write", &format!("{:.4} in cell {} of sweep {}", told.left, place.cell, place.sweep)));
    lines.extend(told.body.map(|light| row("pg", &format!("present, reflectivity {light:.4}"))));
    lines.extend(told.ground.iter().flat_map(ground_rows));
    lines.extend(told.late.iter().map(late_row));
    let Some(exact) = &told.exact else { return lines.join("\n") + "\n" };
    let on_ground = |range| format!(" at {range:.2} m, {} m high, {}", fixed(exact.height_m, 3), exact.shade);
    let place = exact.range_m.map_or_else(String::new, on_ground);
    lines.push(row("exact", &format!("{:.4}: {}{place}", exact.intensity, exact.label)));
    lines.join("\n") + "\n"
}

fn row(name: &str, value: &str) -> String {
    format!("{name:<18} {value}")
}

fn ground_rows(ground: &GroundPoint) -> Vec<String> {
    let [north, east] = ground.place_m.map(|place| fixed(place, 2));
    let [x, y] = ground.ramps.map(|ramp| fixed(ramp, 4));
    let [u, v] = ground.terrain_slopes.map(|slope| fixed(slope, 4));
    let gate = |on: bool| if on { "on" } else { "off" };
    let mut rows = vec![
        row("sample", &format!("{}, {:.3} µs", ground.sample, ground.time_us)),
        row("sweep.range", &format!("{:.2} m: {north} m north, {east} m east", ground.range_m)),
        row(
            "sweep.x, sweep.y",
            &format!("{x}, {y}; s_x {:+}, s_y {:+}", ground.polarity[0], ground.polarity[1]),
        ),
        row("region", &format!("{}, {} of the {} level", ground.region[0], ground.region[1], ground.level)),
    ];
    rows.extend(ground.colours.iter().map(|colour| {
        let corner = |place: [i64; 2]| format!("{}, {}", place[0], place[1]);
        let held = colour.held.map_or_else(|| "nothing".to_owned(), corner);
        let share =
            colour.height_m.map_or_else(String::new, |height| format!(", adds {} m", fixed(height, 3)));
        let stale =
            if colour.stale { format!(" STALE: wants {}", corner(colour.wanted)) } else { String::new() };
        row(&format!("tg.{}.hold", colour.colour), &format!("corner {held}{share}{stale}"))
    }));
    rows.extend([
        row("tg.height", &format!("{} m", fixed(ground.terrain_height_m, 3))),
        row("tg.slope", &format!("{u} north, {v} east")),
        row("tg.reflectivity", &format!("{:.4}", ground.terrain_reflectivity)),
        row("fg.height", &format!("{} m{}", fixed(ground.feature_height_m, 3), craters(&ground.craters))),
        row("mu.vs1, sc.gate", &format!("{}, {}", gate(ground.features_shown), gate(ground.in_shadow))),
        row("txg.texture", &format!("{:.4}", ground.texture)),
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

fn craters(numbers: &[u32]) -> String {
    match numbers {
        [] => String::new(),
        _ => format!(": craters {}", numbers.iter().map(u32::to_string).collect::<Vec<_>>().join(", ")),
    }
}

fn late_row(late: &Late) -> String {
    let came = late.came.map_or_else(|| "never came".to_owned(), |came| format!("came at {came:.2}"));
    let force = if late.in_force { ", in force" } else { "" };
    row(
        "dpu.late",
        &format!(
            "crossing {}, {} {}: due at sample {:.2}, {came}, words {:#05x}, {}{force}",
            late.crossing, late.colour, late.register, late.due, late.words, late.cause
        ),
    )
}
