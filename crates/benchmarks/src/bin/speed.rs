//! How fast frames are drawn, as a table or as JSON.

use std::io::Write;
use std::process::ExitCode;
use std::time::Instant;

use benchmarks::{REAL_TIME, ROWS, Row, Scene};
use clap::Parser;
use generator::{Generator, Planes, Session};
use machine::HybridMachine;
use rayon::ThreadPool;
use scenario::Pose;
use serde_json::json;
use signal::Probe;

/// Draw frames again and again and tell the median time.
#[derive(Debug, Parser)]
struct Arguments {
    /// Rows whose names begin so; all if left out.
    names: Vec<String>,
    /// Times that each row is drawn, after once to warm up; rows take turns.
    #[arg(long, default_value_t = 9)]
    repetitions: usize,
    /// Numbers of threads.
    #[arg(long, value_delimiter = ',', default_value = "1,2")]
    threads: Vec<usize>,
    /// Print as JSON.
    #[arg(long)]
    json: bool,
}

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    match measured(&arguments).and_then(|lines| print(&lines, arguments.json)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}

/// One row on one number of threads.
struct Line {
    row: &'static Row,
    threads: usize,
    samples: u64,
    /// Seconds a frame, in order of size.
    times: Vec<f64>,
}

/// A row made ready.
struct Drawn {
    row: &'static Row,
    session: Box<dyn Session>,
    planes: Planes,
    pose: Pose,
    samples: u64,
}

impl Drawn {
    fn new(row: &'static Row) -> Self {
        let scene = Scene::shipped(row.scenario, &row.choice);
        let (planes, pose, samples) = (scene.planes(), scene.pose, scene.samples());
        let session = HybridMachine.prepare(scene.stage).expect("the machine draws what is shipped");
        Self { row, session, planes, pose, samples }
    }

    fn draw(&mut self, pool: &ThreadPool) -> f64 {
        let begin = Instant::now();
        let counts = pool.install(|| self.session.frame(0, &self.pose, &mut self.planes, &mut Probe::off()));
        let time = begin.elapsed().as_secs_f64();
        assert!(counts.expect("drawn by the tests").samples > 0);
        time
    }
}

fn measured(arguments: &Arguments) -> Result<Vec<Line>, String> {
    let is_meant = |row: &&Row| {
        arguments.names.is_empty() || arguments.names.iter().any(|name| row.name.starts_with(name.as_str()))
    };
    let mut rows: Vec<Drawn> = ROWS.iter().filter(is_meant).map(Drawn::new).collect();
    if rows.is_empty() {
        let names: Vec<&str> = ROWS.iter().map(|row| row.name).collect();
        return Err(format!("no row begins with {:?}; rows: {}", arguments.names, names.join("; ")));
    }
    let pools = arguments.threads.iter().map(|&threads| {
        rayon::ThreadPoolBuilder::new().num_threads(threads).build().map_err(|error| error.to_string())
    });
    let pools = pools.collect::<Result<Vec<ThreadPool>, String>>()?;
    let mut times = vec![Vec::new(); rows.len() * pools.len()];
    for repetition in 0..=arguments.repetitions.max(1) {
        for (index, times) in times.iter_mut().enumerate() {
            let time = rows[index / pools.len()].draw(&pools[index % pools.len()]);
            // The first time fills buffers and caches.
            if repetition > 0 {
                times.push(time);
            }
        }
    }
    Ok(times
        .into_iter()
        .enumerate()
        .map(|(index, mut times)| {
            times.sort_unstable_by(f64::total_cmp);
            let Drawn { row, samples, .. } = rows[index / pools.len()];
            Line { row, threads: arguments.threads[index % pools.len()], samples, times }
        })
        .collect())
}

impl Line {
    fn median(&self) -> f64 {
        self.times[self.times.len() / 2]
    }

    fn rate(&self) -> f64 {
        self.samples as f64 / self.median()
    }
}

fn print(lines: &[Line], as_json: bool) -> Result<(), String> {
    let text = if as_json {
        let line = |line: &Line| {
            json!({
                "row": line.row.name, "threads": line.threads, "samples": line.samples, "seconds": line.times,
                "samples_per_s": line.rate(), "real_time": line.rate() / REAL_TIME,
            })
        };
        let lines: Vec<_> = lines.iter().map(line).collect();
        format!("{}\n", json!({ "schema": "lunoid.speed/1", "lines": lines }))
    } else {
        let head = "| frame | threads | ms | least | most | ns a sample | million samples/s | x real time |\n|---|---|---|---|---|---|---|---|\n";
        let line = |line: &Line| {
            let (least, most) = (line.times[0], line.times[line.times.len() - 1]);
            format!(
                "| {} | {} | {:.2} | {:.2} | {:.2} | {:.2} | {:.1} | {:.2} |\n",
                line.row.name,
                line.threads,
                line.median() * 1e3,
                least * 1e3,
                most * 1e3,
                1e9 / line.rate(),
                line.rate() / 1e6,
                line.rate() / REAL_TIME
            )
        };
        head.to_owned() + &lines.iter().map(line).collect::<String>()
    };
    std::io::stdout().write_all(text.as_bytes()).map_err(|error| error.to_string())
}
