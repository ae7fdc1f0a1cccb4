//! Plots of a study: error against time, and error against step with the slope that theory says.

use std::path::Path;

use plots::{PointSeries, SlopeGuide, TraceLook, ladder_picture};

use super::folder::{ReportError, save};
use crate::advice::total_error;
use crate::front;
use crate::ladder::{EXACT, LadderOutcome, OrderOutcome, RungOutcome};

const WIDTH: u32 = 860;
const HEIGHT: u32 = 460;
const TIME: &str = "time (ms a frame, median)";

/// `all.svg` and `all.png` of the ladders of frames, and a plot of each ladder under its own name.
pub fn write_plots(folder: &Path, facts: &str, ladders: &[LadderOutcome]) -> Result<(), ReportError> {
    let is_of_frames = |ladder: &&LadderOutcome| ladder.unit_of_work == "frame" && ladder.against == EXACT;
    let of_frames: Vec<&LadderOutcome> = ladders.iter().filter(is_of_frames).collect();
    draw_front(folder, "all", "Error against run time", facts, &of_frames)?;
    for ladder in ladders {
        draw_front(folder, ladder.name, ladder.what, facts, &[ladder])?;
        for (number, order) in ladder.orders.iter().enumerate() {
            let name = format!("{}-order-{}", ladder.name, number + 1);
            draw_order(folder, &name, facts, ladder, order)?;
        }
    }
    Ok(())
}

fn look(title: &str, facts: &str) -> TraceLook {
    TraceLook { title: title.to_owned(), facts: vec![facts.to_owned()], width: WIDTH, height: HEIGHT }
}

/// Time and total error of a rung that has both above 0.
fn point(rung: &RungOutcome) -> Option<[f64; 2]> {
    let point = [1e3 * rung.time_s?[0], total_error(rung)?];
    point.iter().all(|value| *value > 0.0).then_some(point)
}

fn draw_front(
    folder: &Path,
    name: &str,
    title: &str,
    facts: &str,
    ladders: &[&LadderOutcome],
) -> Result<(), ReportError> {
    let series: Vec<PointSeries<'_>> = ladders
        .iter()
        .map(|ladder| {
            let drawn: Vec<(&RungOutcome, [f64; 2])> =
                ladder.rungs.iter().filter_map(|rung| Some((rung, point(rung)?))).collect();
            PointSeries {
                name: ladder.name,
                points: drawn.iter().map(|(_, point)| *point).collect(),
                labels: drawn.iter().map(|(rung, _)| rung.label.as_str()).collect(),
                joined: ladder.rungs.iter().all(|rung| rung.step.is_some()),
            }
        })
        .collect();
    let all: Vec<[f64; 2]> = series.iter().flat_map(|series| series.points.clone()).collect();
    if all.is_empty() {
        return Ok(());
    }
    let picture = format!("RMSE of the picture against {} (1 = white)", ladders[0].against);
    let best: Vec<[f64; 2]> = front(&all).into_iter().map(|index| all[index]).collect();
    save(folder, name, ladder_picture([TIME, &picture], &series, &best, &[], &look(title, facts)))
}

fn draw_order(
    folder: &Path,
    name: &str,
    facts: &str,
    ladder: &LadderOutcome,
    order: &OrderOutcome,
) -> Result<(), ReportError> {
    let expected = &order.expected;
    let drawn: Vec<(&RungOutcome, [f64; 2])> = ladder
        .rungs
        .iter()
        .filter_map(|rung| Some((rung, [rung.step?, rung.error(expected.error)?])))
        .filter(|(_, point)| point.iter().all(|value| *value > 0.0))
        .collect();
    let Some((_, middle)) = drawn.get(drawn.len() / 2) else { return Ok(()) };
    let steps: Vec<f64> = drawn.iter().map(|(_, point)| point[0]).collect();
    let ends =
        [steps.iter().copied().fold(f64::INFINITY, f64::min), steps.iter().copied().fold(0.0, f64::max)];
    let guide = SlopeGuide {
        name: format!("order {}", expected.order),
        order: expected.order,
        through: *middle,
        over: ends,
    };
    let series = PointSeries {
        name: expected.error,
        points: drawn.iter().map(|(_, point)| *point).collect(),
        labels: drawn.iter().map(|(rung, _)| rung.label.as_str()).collect(),
        joined: true,
    };
    let measured = order.measured.map_or_else(
        || "no straight part".to_owned(),
        |found| format!("measured order {:.2} over {} rungs", found.slope, found.rungs),
    );
    let mut look = look(&format!("{}: {}", ladder.what, expected.error), facts);
    look.facts.push(format!("{measured}; theory says {}: {}", expected.order, expected.why));
    save(folder, name, ladder_picture(["step", expected.error], &[series], &[], &[guide], &look))
}
