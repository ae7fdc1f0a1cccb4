//! Instructions of the kernels, as a table or as JSON.

use std::env;
use std::io::Write;
use std::process::ExitCode;

use benchmarks::{CountError, KERNELS, Kernel, counted, instructions_of, kernel};
use clap::Parser;
use serde_json::json;

/// Count the instructions of the kernels by callgrind.
#[derive(Debug, Parser)]
struct Arguments {
    /// Kernels whose names begin so; all if left out.
    names: Vec<String>,
    /// Print them as JSON.
    #[arg(long)]
    json: bool,
    /// Names alone.
    #[arg(long)]
    list: bool,
    /// Run this kernel, twice, and count nothing: what is run under callgrind.
    #[arg(long, value_name = "NAME")]
    run: Option<String>,
}

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    let made = match &arguments.run {
        Some(name) => run(name),
        None => chosen(&arguments.names).and_then(|kernels| report(&kernels, &arguments)),
    };
    match made {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}

/// The first time fills buffers and caches; the second is counted.
fn run(name: &str) -> Result<(), String> {
    let kernel = kernel(name).ok_or_else(|| unknown(name))?;
    let mut work = (kernel.ready)();
    work();
    counted(&mut *work);
    Ok(())
}

fn chosen(names: &[String]) -> Result<Vec<&'static Kernel>, String> {
    let is_meant = |kernel: &Kernel, name: &String| kernel.name.starts_with(name.as_str());
    if let Some(name) = names.iter().find(|name| !KERNELS.iter().any(|kernel| is_meant(kernel, name))) {
        return Err(unknown(name));
    }
    let is_chosen = |kernel: &&Kernel| names.is_empty() || names.iter().any(|name| is_meant(kernel, name));
    Ok(KERNELS.iter().filter(is_chosen).collect())
}

fn unknown(name: &str) -> String {
    format!("{name}: no kernel of this name; `instructions --list` names them")
}

fn report(kernels: &[&Kernel], arguments: &Arguments) -> Result<(), String> {
    if arguments.list {
        return print(
            kernels.iter().map(|kernel| format!("{:<26}{}\n", kernel.name, kernel.about)).collect(),
        );
    }
    let program = env::current_exe().map_err(|error| error.to_string())?;
    let count = |kernel: &&Kernel| Ok((kernel.name, kernel.about, instructions_of(&program, kernel.name)?));
    let counts: Result<Vec<_>, CountError> = kernels.iter().map(count).collect();
    let counts = counts.map_err(|error| error.to_string())?;
    print(match arguments.json {
        true => {
            let line = |(name, about, count)| json!({ "name": name, "about": about, "instructions": count });
            let kernels: Vec<_> = counts.into_iter().map(line).collect();
            format!("{}\n", json!({ "schema": "lunoid.instructions/1", "kernels": kernels }))
        }
        false => {
            let line = |(name, about, count)| format!("{name:<26}{count:>16}  {about}\n");
            counts.into_iter().map(line).collect()
        }
    })
}

fn print(text: String) -> Result<(), String> {
    std::io::stdout().write_all(text.as_bytes()).map_err(|error| error.to_string())
}
