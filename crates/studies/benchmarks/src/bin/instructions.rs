//! Instructions of the kernels, as a table or as JSON, alone or against those of an earlier build.

use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
use std::{env, fs};

use benchmarks::{Baseline, Circumstances, CountError, KERNELS, Kernel, counted, instructions_of, kernel};
use clap::Parser;
use fearless_simd::Level;
use rayon::prelude::*;
use serde_json::json;

/// Count the instructions of the kernels by callgrind.
#[derive(Debug, Parser)]
#[command(
    after_help = "Example: instructions --against crates/studies/benchmarks/instructions.json\n\nThe exit code is 1 if a kernel takes more instructions than the baseline and the tolerance allow."
)]
struct Arguments {
    /// Kernels whose names begin so; all if left out, or with --against all that the baseline has.
    names: Vec<String>,
    /// Print them as JSON.
    #[arg(long)]
    json: bool,
    /// Print only the names of the kernels.
    #[arg(long)]
    list: bool,
    /// Hold them against the counts of this file.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["list", "record"])]
    against: Option<PathBuf>,
    /// Per cent that a kernel may differ from the baseline.
    #[arg(long, value_name = "PERCENT", default_value_t = 1.0)]
    tolerance: f64,
    /// Write the counts to this file, for --against.
    #[arg(long, value_name = "FILE", conflicts_with = "list")]
    record: Option<PathBuf>,
    /// Run this kernel, twice, and count nothing: what is run under callgrind.
    #[arg(long, value_name = "NAME", hide = true)]
    run: Option<String>,
    /// With --run: keep shadow boundaries in this folder.
    #[arg(long, value_name = "FOLDER", requires = "run", hide = true)]
    shadows: Option<PathBuf>,
}

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    let made = match &arguments.run {
        Some(name) => run(name, arguments.shadows.as_deref()).map(|()| ExitCode::SUCCESS),
        None => tell(&arguments),
    };
    made.unwrap_or_else(|message| {
        eprintln!("error: {message}");
        ExitCode::FAILURE
    })
}

/// The first time fills buffers and caches; the second is counted. Tells what vectors the kernel chose, and whether it was compiled for
/// those alone: the program around it then uses them as well.
fn run(name: &str, shadows: Option<&Path>) -> Result<(), String> {
    let kernel = kernel(name).ok_or_else(|| unknown(name))?;
    let mut work = kernel.ready(shadows);
    (work.run)();
    counted(&mut *work.run);
    let level = format!("{:?}", Level::new());
    let alone = if cfg!(target_feature = "avx2") { " alone" } else { "" };
    print(&format!("{}{alone}", level.split('(').next().unwrap_or_default()))
}

fn tell(arguments: &Arguments) -> Result<ExitCode, String> {
    if arguments.list {
        let line = |kernel: &Kernel| format!("{:<34}{}\n", kernel.name, kernel.about);
        return print(&KERNELS.iter().map(line).collect::<String>()).map(|()| ExitCode::SUCCESS);
    }
    match &arguments.against {
        Some(path) => compare(path, arguments),
        None => report(arguments).map(|()| ExitCode::SUCCESS),
    }
}

fn report(arguments: &Arguments) -> Result<(), String> {
    let kernels = chosen(&arguments.names, |_| true)?;
    let counts = count(&kernels).map_err(|error| error.to_string())?;
    if let Some(path) = &arguments.record {
        counts.write(path).map_err(|error| error.to_string())?;
    }
    let rows = kernels.iter().map(|kernel| (kernel, counts.instructions[kernel.name]));
    print(&match arguments.json {
        true => {
            let line = |(kernel, count): (&&Kernel, u64)| json!({ "name": kernel.name, "about": kernel.about, "instructions": count });
            let circumstances = &counts.circumstances;
            let kernels: Vec<_> = rows.map(line).collect();
            let document = json!({ "schema": "lunoid.instructions/1", "circumstances": circumstances, "kernels": kernels });
            format!("{document}\n")
        }
        false => rows
            .map(|(kernel, count)| format!("{:<34}{count:>14}  {}\n", kernel.name, kernel.about))
            .collect(),
    })
}

/// Counts the kernels of a baseline and tells how they differ; a failure if one takes more.
fn compare(path: &Path, arguments: &Arguments) -> Result<ExitCode, String> {
    let before = Baseline::read(path).map_err(|error| error.to_string())?;
    if let Some(gone) = before.instructions.keys().find(|name| kernel(name).is_none()) {
        return Err(format!("{}: {}; take it out, or record the file again", path.display(), unknown(gone)));
    }
    let kernels = chosen(&arguments.names, |kernel| before.instructions.contains_key(kernel.name))?;
    let now = match count(&kernels) {
        Err(error @ CountError::NoValgrind) => {
            eprintln!("SKIPPED: {error}");
            return Ok(ExitCode::SUCCESS);
        }
        counts => counts.map_err(|error| error.to_string())?,
    };
    if now.circumstances != before.circumstances {
        eprintln!(
            "SKIPPED: {} was counted by {}, this is {}; counts of one build say nothing of another: record them again",
            path.display(),
            before.circumstances,
            now.circumstances
        );
        return Ok(ExitCode::SUCCESS);
    }
    let tolerance = arguments.tolerance / 100.0;
    let differences = before.differences(&now.instructions);
    let more = differences.iter().filter(|one| one.beyond(tolerance).is_gt()).count();
    if arguments.json {
        let line = |one: &benchmarks::Difference<'_>| json!({ "name": one.name, "before": one.before, "now": one.now });
        let kernels: Vec<_> = differences.iter().map(line).collect();
        let document = json!({ "schema": "lunoid.instructions-compared/1", "tolerance": tolerance, "more": more, "kernels": kernels });
        print(&format!("{document}\n"))?;
    } else {
        let mut table = format!("{:<34}{:>14}{:>14}{:>9}\n", "kernel", "before", "now", "ratio");
        for one in &differences {
            let remark = match one.beyond(tolerance) {
                Ordering::Greater => "  more",
                Ordering::Less => "  fewer: record them again",
                Ordering::Equal => "",
            };
            table +=
                &format!("{:<34}{:>14}{:>14}{:>9.4}{remark}\n", one.name, one.before, one.now, one.ratio());
        }
        print(&table)?;
    }
    if more > 0 {
        return Err(format!(
            "{more} of {} kernels take over {} % more instructions than {} has: find out why, or, if that is what they \
             are worth, write it anew with --record",
            differences.len(),
            arguments.tolerance,
            path.display()
        ));
    }
    Ok(ExitCode::SUCCESS)
}

/// Kernels that are `meant` and whose names begin with one of `names`.
fn chosen(names: &[String], meant: impl Fn(&Kernel) -> bool) -> Result<Vec<&'static Kernel>, String> {
    let begins = |kernel: &Kernel, name: &String| kernel.name.starts_with(name.as_str());
    if let Some(name) = names.iter().find(|name| !KERNELS.iter().any(|kernel| begins(kernel, name))) {
        return Err(unknown(name));
    }
    let is_chosen = |kernel: &&Kernel| {
        meant(kernel) && (names.is_empty() || names.iter().any(|name| begins(kernel, name)))
    };
    Ok(KERNELS.iter().filter(is_chosen).collect())
}

fn unknown(name: &str) -> String {
    format!("{name}: no kernel of this name; `instructions --list` names them")
}

/// As many at a time as the computer has cores: nothing of a count depends on what else it does.
fn count(kernels: &[&'static Kernel]) -> Result<Baseline, CountError> {
    let failed = |error: io::Error| CountError::Failed { kernel: "all".into(), reason: error.to_string() };
    let program = env::current_exe().map_err(failed)?;
    let shadows = tempfile::tempdir().map_err(failed)?;
    let counts = kernels.par_iter().map(|kernel| {
        let folder = kernel.is_shadowed().then(|| shadows.path().join(kernel.name.replace('/', "-")));
        if let Some(folder) = &folder {
            find_shadows(&program, kernel.name, folder).map_err(failed)?;
        }
        let mut arguments = vec![OsStr::new("--run"), OsStr::new(kernel.name)];
        if let Some(folder) = &folder {
            arguments.extend([OsStr::new("--shadows"), folder.as_os_str()]);
        }
        Ok((kernel.name, instructions_of(&program, kernel.name, &arguments)?))
    });
    let counts = counts.collect::<Result<Vec<_>, CountError>>()?;
    let vectors = counts.first().map_or(String::new(), |(_, count)| count.told.clone());
    let circumstances = Circumstances { built_by: env!("BUILT_BY").to_owned(), vectors };
    let instructions: BTreeMap<_, _> =
        counts.into_iter().map(|(name, count)| (name.to_owned(), count.instructions)).collect();
    Ok(Baseline::new(circumstances, instructions))
}

/// Runs a kernel once by itself: callgrind would take fifty times as long to find its shadow boundaries.
fn find_shadows(program: &Path, kernel: &str, folder: &Path) -> io::Result<()> {
    fs::create_dir(folder)?;
    Command::new(program).args(["--run", kernel, "--shadows"]).arg(folder).output().map(drop)
}

fn print(text: &str) -> Result<(), String> {
    io::stdout().write_all(text.as_bytes()).map_err(|error| error.to_string())
}
