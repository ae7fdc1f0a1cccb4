//! Frames of the machine, drawn again and again.

use machine::Prepare;
use std::time::Instant;

use generator::{Planes, Session};
use rayon::{ThreadPool, ThreadPoolBuilder};
use scenario::Pose;
use serde_json::{Value, json};
use signal::Probe;

use crate::{REAL_TIME, ROWS, Row, TimedScene};

/// Times of one row on one number of threads.
#[derive(Debug, Clone)]
pub struct FrameTimes {
    /// Row of the table that was drawn.
    pub row: &'static Row,
    /// Threads that drew it.
    pub threads: usize,
    /// Samples of a frame.
    pub samples: u64,
    /// Seconds a frame, in order of size; at least one.
    pub times: Vec<f64>,
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
        let scene = TimedScene::shipped(row.scenario, &row.choice);
        let (planes, pose, samples) = (scene.planes(), scene.pose, scene.samples());
        let session = scene.stage.prepare();
        Self { row, session, planes, pose, samples }
    }

    /// Draws a frame; how long that took (s).
    fn draw(&mut self, pool: &ThreadPool) -> f64 {
        let begin = Instant::now();
        let counts = pool.install(|| self.session.frame(0, &self.pose, &mut self.planes, &mut Probe::off()));
        let time = begin.elapsed().as_secs_f64();
        assert!(counts.expect("drawn by the tests")["samples"] > 0);
        time
    }
}

/// Draws the rows whose names begin with one of `names`, all if there is none, `repetitions` times on each number of
/// threads; rows take turns, and each turn begins with a frame that is not timed. In a mission a frame follows another of
/// the same scene, whose caches it finds as that has left them; after another row they would be that row's.
///
/// # Errors
/// If no row begins so, or threads cannot be started.
pub fn frame_times(
    names: &[String],
    repetitions: usize,
    threads: &[usize],
) -> Result<Vec<FrameTimes>, String> {
    let is_meant =
        |row: &&Row| names.is_empty() || names.iter().any(|name| row.name.starts_with(name.as_str()));
    let mut rows: Vec<Drawn> = ROWS.iter().filter(is_meant).map(Drawn::new).collect();
    if rows.is_empty() {
        let all: Vec<&str> = ROWS.iter().map(|row| row.name).collect();
        return Err(format!("no row begins with {names:?}; rows: {}", all.join("; ")));
    }
    let pools = threads.iter().map(|&threads| {
        ThreadPoolBuilder::new().num_threads(threads).build().map_err(|error| error.to_string())
    });
    let pools = pools.collect::<Result<Vec<ThreadPool>, String>>()?;
    let mut times = vec![Vec::new(); rows.len() * pools.len()];
    for _ in 0..repetitions.max(1) {
        for (index, times) in times.iter_mut().enumerate() {
            let (drawn, pool) = (&mut rows[index / pools.len()], &pools[index % pools.len()]);
            drawn.draw(pool);
            times.push(drawn.draw(pool));
        }
    }
    let told = times.into_iter().enumerate().map(|(index, mut times)| {
        times.sort_unstable_by(f64::total_cmp);
        let Drawn { row, samples, .. } = rows[index / pools.len()];
        FrameTimes { row, threads: threads[index % pools.len()], samples, times }
    });
    Ok(told.collect())
}

impl FrameTimes {
    fn median(&self) -> f64 {
        self.times[self.times.len() / 2]
    }

    /// Returns the rate at the median time (samples per second).
    fn rate(&self) -> f64 {
        self.samples as f64 / self.median()
    }

    /// The same as an object.
    pub fn document(&self) -> Value {
        json!({
            "row": self.row.name, "threads": self.threads, "samples": self.samples, "seconds": self.times,
            "samples_per_s": self.rate(), "real_time": self.rate() / REAL_TIME,
        })
    }

    /// All of `lines` as a table in Markdown.
    pub fn table(lines: &[Self]) -> String {
        let head = "| frame | threads | ms | least | most | ns a sample | million samples/s | x real time |\n|---|---|---|---|---|---|---|---|\n";
        let line = |line: &Self| {
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
    }
}
