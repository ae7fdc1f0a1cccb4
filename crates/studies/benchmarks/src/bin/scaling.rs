//! How the cost of a frame grows with what is in it: a table of exponents, and a plot.

use machine::Prepare;
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Instant;

use benchmarks::{LADDERS, Ladder, Size, TimedScene};
use clap::Parser;
use plots::{PointSeries, TraceLook, ladder_picture};
use signal::Probe;

/// Time frames of scenes that grow in one thing.
#[derive(Debug, Parser)]
struct Arguments {
    /// Ladders whose names begin so; all if left out.
    names: Vec<String>,
    /// Times that each rung is drawn, after once to warm up.
    #[arg(long, default_value_t = 5)]
    repetitions: usize,
    /// Plot here (SVG or PNG).
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

fn main() -> ExitCode {
    match run(&Arguments::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}

fn run(arguments: &Arguments) -> Result<(), String> {
    let is_meant = |ladder: &&Ladder| {
        arguments.names.is_empty()
            || arguments.names.iter().any(|name| ladder.name.starts_with(name.as_str()))
    };
    let ladders: Vec<&Ladder> = LADDERS.iter().filter(is_meant).collect();
    if ladders.is_empty() {
        let names: Vec<&str> = LADDERS.iter().map(|ladder| ladder.name).collect();
        return Err(format!("no ladder begins with {:?}; ladders: {}", arguments.names, names.join(", ")));
    }
    let mut series = Vec::new();
    for ladder in ladders {
        let (none, points) = climb(ladder, arguments.repetitions)?;
        let (expected, why) = ladder.expected;
        let added: Vec<[f64; 2]> = points.iter().map(|&[value, time]| [value, time - none]).collect();
        println!("\n{}: order {:.2}, expected {expected} ({why})\n", ladder.name, order(&added));
        println!("| {} | ms |\n|---|---|", ladder.name);
        if ladder.without.is_some() {
            println!("| 0 | {none:.2} |");
        }
        points.iter().for_each(|[value, time]| println!("| {value} | {time:.2} |"));
        // Each on its own scale: times its first value and time.
        let [first, least] = points[0];
        series.push((ladder.name, points.iter().map(|[v, t]| [v / first, t / least]).collect::<Vec<_>>()));
    }
    let Some(out) = &arguments.out else { return Ok(()) };
    let series: Vec<PointSeries<'_>> = series
        .into_iter()
        .map(|(name, points)| PointSeries { name, points, labels: Vec::new(), joined: true })
        .collect();
    let look = TraceLook { height: 480, ..TraceLook::titled("Cost of a frame against what is in it") };
    let axes = ["times as much", "times as long"];
    let drawing = ladder_picture(axes, &series, &[], &[], &look).map_err(|error| error.to_string())?;
    drawing.write(out).map_err(|error| error.to_string())
}

/// The time without what grows (ms), 0 where it cannot be left out; how much there is and the time, rung by rung.
fn climb(ladder: &Ladder, repetitions: usize) -> Result<(f64, Vec<[f64; 2]>), String> {
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let scene = |size: Size| size.scene(folder.path()).map_err(|error| error.to_string());
    let none = ladder.without.map(|size| time(scene(size)?, size.threads, repetitions));
    let rung = |&value: &f64| {
        let size = (ladder.at)(value);
        let scene = scene(size)?;
        let much = ladder.count.map_or(value, |count| count(&scene));
        Ok([much, time(scene, size.threads, repetitions)?])
    };
    Ok((none.transpose()?.unwrap_or(0.0), ladder.values.iter().map(rung).collect::<Result<_, String>>()?))
}

/// Median time of all frames of a scene (ms), after once to warm up.
fn time(scene: TimedScene, threads: usize, repetitions: usize) -> Result<f64, String> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    let pool = pool.map_err(|error| error.to_string())?;
    let (mut planes, poses) = (scene.planes(), scene.poses());
    let session = scene.stage.prepare();
    let mut draw = || {
        let begin = Instant::now();
        for (frame, pose) in (0..).zip(&poses) {
            let drawn = pool.install(|| session.frame(frame, pose, &mut planes, &mut Probe::off()));
            drawn.map_err(|error| error.to_string())?;
        }
        Ok::<_, String>(begin.elapsed().as_secs_f64() * 1e3)
    };
    draw()?;
    let mut times = (0..repetitions.max(1)).map(|_| draw()).collect::<Result<Vec<f64>, String>>()?;
    times.sort_unstable_by(f64::total_cmp);
    Ok(times[times.len() / 2])
}

/// Power with which a time grows over the upper half of a ladder, by least squares of the logarithms.
fn order(points: &[[f64; 2]]) -> f64 {
    let upper = points[(points.len() - 1) / 2..].iter();
    // What adds nothing that can be measured has no logarithm.
    let logs: Vec<[f64; 2]> =
        upper.filter(|[_, time]| *time > 0.0).map(|point| point.map(libm::log)).collect();
    let mean = |axis: usize| logs.iter().map(|point| point[axis]).sum::<f64>() / logs.len() as f64;
    let middle = [mean(0), mean(1)];
    let product = |a: usize, b: usize| {
        logs.iter().map(|point| (point[a] - middle[a]) * (point[b] - middle[b])).sum::<f64>()
    };
    product(0, 1) / product(0, 0)
}
