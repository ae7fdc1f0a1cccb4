//! Tests: every command line that help or a page shows is one of this program, or of this workspace.
//!
//! ```text
//! pages     where they stand: help of all commands, README, docs; blocks of code and words between backticks
//! shell     a block of code into commands: quotes, comments, pipes, redirections, loops
//! workspace what a line of cargo names: packages, targets, tests
//! options   options that are named alone, in messages and sentences
//! ```
//!
//! A block's command must be whole. Words between backticks may name a command without what it requires. There are no
//! other placeholders: where a page shows a value, it is one that the command takes.

mod options;
mod pages;
mod shell;
mod workspace;

use clap::Error;
use clap::error::{ContextKind, ContextValue, ErrorKind};

use crate::cli::command;

use pages::{Kind, Written, root};
use workspace::Workspace;

/// Commands of others that stand in blocks of a shell.
const OTHERS: [&str; 13] = [
    ".ci/doors",
    ".ci/logs",
    ".ci/site",
    "alias",
    "cp",
    "ffmpeg",
    "gtkwave",
    "ngspice",
    "octave-cli",
    "python3",
    "rustup",
    "tests/fuzz/run",
    "xdg-open",
];
/// Folders of the repository that commands name files in.
const FOLDERS: [&str; 5] = ["scenarios/", "hardware-models/", "tests/", "crates/", "docs/"];

/// Options that name a file or a folder to be written.
const OUTPUTS: [&str; 10] = [
    "--out",
    "-o",
    "--picture",
    "--waveforms",
    "--timing",
    "--junit",
    "--y4m",
    "--mcap",
    "--page",
    "--relief",
];
/// Where the commands of pages may write: what is not kept, the standard output, and what the repository keeps of what it makes.
const WRITABLE: [&str; 6] = ["runs/", "-", "docs/", "tests/", "crates/", "scenarios/real/"];

/// What is wrong with a written command, if anything.
fn fault(written: &Written, workspace: &Workspace) -> Result<(), String> {
    let words: Vec<&str> = written.words.iter().map(String::as_str).collect();
    match words[0] {
        "lunoid" => parsed(&words, written.kind)?,
        "cargo" => {
            if let Some(arguments) = workspace.cargo(&words[1..])? {
                let words: Vec<_> = ["lunoid"].into_iter().chain(arguments).collect();
                parsed(&words, written.kind)?;
            }
        }
        other if OTHERS.contains(&other) => {}
        other => return Err(format!("`{other}` is neither lunoid nor cargo; expected one of {OTHERS:?}")),
    }
    if written.kind == Kind::Line && written.place.contains(".md") {
        words.windows(2).try_for_each(|pair| expect_kept_apart(pair[0], pair[1]))?;
    }
    words.iter().try_for_each(|word| expect_file(word))
}

/// Commands of pages leave their files where nothing of the repository is.
fn expect_kept_apart(option: &str, path: &str) -> Result<(), String> {
    if !OUTPUTS.contains(&option) || WRITABLE.iter().any(|folder| path.starts_with(folder)) {
        return Ok(());
    }
    Err(format!("{option} {path}: expected a place below runs/"))
}

/// Whether the program takes the words.
fn parsed(words: &[&str], kind: Kind) -> Result<(), String> {
    match command().try_get_matches_from(words) {
        Ok(_) => Ok(()),
        Err(error) if is_answered(&error) || kind == Kind::Mention && only_lacks(&error) => Ok(()),
        Err(error) => Err(error.to_string()),
    }
}

/// `--help` and `--version` are done where the line is read.
fn is_answered(error: &Error) -> bool {
    matches!(error.kind(), ErrorKind::DisplayHelp | ErrorKind::DisplayVersion)
}

/// Whether the words are right as far as they go: a command without what it requires, an option without its value.
fn only_lacks(error: &Error) -> bool {
    match error.kind() {
        ErrorKind::MissingRequiredArgument
        | ErrorKind::MissingSubcommand
        | ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand => true,
        ErrorKind::InvalidValue => {
            matches!(error.get(ContextKind::InvalidValue), Some(ContextValue::String(value)) if value.is_empty())
        }
        _ => false,
    }
}

/// A file of the repository that a command names is there; banks are made and not kept, and so is what a folder's own list leaves out.
fn expect_file(word: &str) -> Result<(), String> {
    let is_ours = FOLDERS.iter().any(|folder| word.starts_with(folder));
    if !is_ours
        || word.contains('*')
        || word.ends_with(".bank")
        || is_left_out(word)
        || root().join(word).exists()
    {
        return Ok(());
    }
    Err(format!("{word}: no such file in the repository"))
}

/// Whether the `.gitignore` beside a file names it.
fn is_left_out(word: &str) -> bool {
    let Some((folder, name)) = word.trim_end_matches('/').rsplit_once('/') else { return false };
    let list = std::fs::read_to_string(root().join(folder).join(".gitignore")).unwrap_or_default();
    list.lines().any(|line| line.trim_end_matches('/') == name)
}

#[test]
fn every_written_command_line_is_taken() {
    let workspace = Workspace::read();
    let (mut faults, mut lines, mut mentions) = (Vec::new(), 0, 0);
    for page in pages::all(&mut command()) {
        let written = page.written();
        faults.extend(written.as_ref().err().cloned());
        for written in written.unwrap_or_default() {
            match written.kind {
                Kind::Line => lines += 1,
                Kind::Mention => mentions += 1,
            }
            if let Err(fault) = fault(&written, &workspace) {
                faults.push(format!("{}: {}\n  {fault}", written.place, written.words.join(" ")));
            }
        }
    }
    assert!(faults.is_empty(), "{} of {} are stale:\n{}", faults.len(), lines + mentions, faults.join("\n"));
    // Far fewer would mean that they are no longer found.
    assert!(lines > 200 && mentions > 80, "{lines} lines, {mentions} mentions");
}

#[test]
fn stale_lines_are_noticed() {
    let workspace = Workspace::read();
    let refused = |kind: Kind, line: &str| {
        let written =
            Written { place: "here.md".into(), kind, words: line.split(' ').map(str::to_owned).collect() };
        fault(&written, &workspace).is_err()
    };
    for stale in [
        "lunoid",
        "lunoid replya scenarios/first-light.toml",
        "lunoid replay",
        "lunoid replay scenarios/first-light.toml --swepes 100",
        "lunoid replay scenarios/first-light.toml --out picture",
        "lunoid replay scenarios/first-night.toml",
        "lunoid lockstep scenarios/first-light.toml --random 3",
        "lunoit replay scenarios/first-light.toml",
        "cargo run --release -- replay scenarios/first-light.toml --swepes 100",
        "cargo run --profile slow -p benchmarks --bin speed",
        "cargo run --release --features solved-library -- list limits",
        "cargo run -p lunoid-tests --bin asleep",
        "cargo run -p lunoid-tests",
        "cargo test --test timing",
        "cargo test -p nobody",
        "cargo test --workspace --test nobody",
        "cargo test --workspace -p lunoid",
        "cargo test --workspace --test elevation -- as_nobody_reads_them",
        "cargo test -p lunoid --test bad_input a_test_of_nobody",
        "cargo test -p lunoid --test long_runs -- --nocapture long_ago",
        "cargo bench -p lunoid",
        "cargo tset",
    ] {
        assert!(refused(Kind::Line, stale), "{stale}");
    }
    for fresh in ["lunoid", "lunoid replay", "lunoid study", "lunoid compare --edges", "lunoid --version"] {
        assert!(!refused(Kind::Mention, fresh), "{fresh}");
    }
    for stale in ["lunoid replya", "lunoid replay --chekc", "lunoid compare --edges 3 --share x"] {
        assert!(refused(Kind::Mention, stale), "{stale}");
    }
}
