//! How the cost of a frame grows with what is in it: a table of exponents, and a plot.

use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Instant;

use benchmarks::{LADDERS, Ladder};
use clap::Parser;
use generator::Generator;
use machine::HybridMachine;
use plots::{PointSeries, TraceLook, ladder_picture};
use signal::Probe;

/// Time frames of scenes that grow in one thing.
#[derive(Debug, Parser)]
struct Arguments {
    /// Ladders whose names begin so; all if left out.
    names: Vec<String>,
    /// Times that each frame is drawn, after once to warm up.
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
        let points = climb(ladder, arguments.repetitions)?;
        let (expected, why) = ladder.expected;
        println!("\n{}: order {:.2}, expected {expected} ({why})\n", ladder.name, order(&points));
        println!("| {} | ms a frame |\n|---|---|", ladder.name);
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

/// Value and time (ms) of each rung.
fn climb(ladder: &Ladder, repetitions: usize) -> Result<Vec<[f64; 2]>, String> {
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let time = |&value: &f64| {
        let size = (ladder.at)(value);
        let scene = size.scene(folder.path()).map_err(|error| error.to_string())?;
        let pool = rayon::ThreadPoolBuilder::new().num_threads(size.threads).build();
        let pool = pool.map_err(|error| error.to_string())?;
        let (mut planes, pose) = (scene.planes(), scene.pose);
        let session = HybridMachine.prepare(scene.stage).map_err(|error| error.to_string())?;
        let mut draw = || {
            let begin = Instant::now();
            let counts = pool.install(|| session.frame(0, &pose, &mut planes, &mut Probe::off()));
            counts.map(|_| begin.elapsed().as_secs_f64() * 1e3).map_err(|error| error.to_string())
        };
        draw()?;
        let mut times = (0..repetitions.max(1)).map(|_| draw()).collect::<Result<Vec<f64>, String>>()?;
        times.sort_unstable_by(f64::total_cmp);
        Ok([value, times[times.len() / 2]])
    };
    ladder.values.iter().map(time).collect()
}

/// Power with which the time grows over the upper half of a ladder, by least squares of the logarithms.
fn order(points: &[[f64; 2]]) -> f64 {
    let upper = &points[(points.len() - 1) / 2..];
    let logs: Vec<[f64; 2]> = upper.iter().map(|point| point.map(libm::log)).collect();
    let mean = |axis: usize| logs.iter().map(|point| point[axis]).sum::<f64>() / logs.len() as f64;
    let middle = [mean(0), mean(1)];
    let product = |a: usize, b: usize| {
        logs.iter().map(|point| (point[a] - middle[a]) * (point[b] - middle[b])).sum::<f64>()
    };
    product(0, 1) / product(0, 0)
}
