//! How fast frames are drawn, as a table or as JSON.

use std::io::Write;
use std::process::ExitCode;

use benchmarks::{FrameTimes, frame_times};
use clap::Parser;
use serde_json::json;

/// Draw frames again and again and tell the median time.
#[derive(Debug, Parser)]
struct Arguments {
    /// Rows whose names begin so; all if left out.
    names: Vec<String>,
    /// Times that each row is drawn, in turns; each turn begins with a frame that is not timed.
    #[arg(long, default_value_t = 9)]
    repetitions: usize,
    /// Numbers of threads that draw, separated by commas.
    #[arg(long, value_delimiter = ',', default_value = "1,2")]
    threads: Vec<usize>,
    /// Print the times as JSON.
    #[arg(long)]
    json: bool,
}

fn main() -> ExitCode {
    match tell(&Arguments::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}

fn tell(arguments: &Arguments) -> Result<(), String> {
    let lines = frame_times(&arguments.names, arguments.repetitions, &arguments.threads)?;
    let text = if arguments.json {
        let lines: Vec<_> = lines.iter().map(FrameTimes::document).collect();
        format!("{}\n", json!({ "schema": "lunoid.speed/1", "lines": lines }))
    } else {
        FrameTimes::table(&lines)
    };
    std::io::stdout().write_all(text.as_bytes()).map_err(|error| error.to_string())
}
