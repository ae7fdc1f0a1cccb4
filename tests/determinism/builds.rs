//! The command, built in several ways.

use std::path::{Path, PathBuf};
use std::process::Command;

/// One build of the command.
pub struct Build {
    /// Name of the build, in words.
    pub name: String,
    /// Path of the built program.
    pub program: PathBuf,
}

/// Vectors of x86 wider than those that every such processor has.
const WIDE: [&str; 3] = ["avx", "avx2", "avx512f"];

/// The command of the workspace at `root`, for debugging, for release, and for release with all vectors of this processor.
pub fn builds(root: &Path) -> Result<[Build; 3], String> {
    let target = std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root.join("target"), PathBuf::from);
    let native = "-C target-cpu=native";
    let vectors = wide_vectors()?;
    let wide = if vectors.is_empty() { "no wider vectors".into() } else { vectors.join(", ") };
    Ok([
        build("debug".into(), root, &target, &[], "")?,
        build("release".into(), root, &target, &["--release"], "")?,
        build(
            format!("release with {native} ({wide})"),
            root,
            &target.join("native"),
            &["--release"],
            native,
        )?,
    ])
}

fn build(name: String, root: &Path, target: &Path, options: &[&str], flags: &str) -> Result<Build, String> {
    eprintln!("{name}: cargo build");
    let mut cargo = Command::new("cargo");
    cargo.args(["build", "--quiet", "--locked", "-p", "lunoid"]).args(options);
    cargo.current_dir(root).env("CARGO_TARGET_DIR", target).env("RUSTFLAGS", flags);
    let ended = cargo.status().map_err(|error| format!("cargo: {error}"))?;
    if !ended.success() {
        return Err(format!("{name}: cargo build {}: {ended}", options.join(" ")));
    }
    let folder = if options.is_empty() { "debug" } else { "release" };
    Ok(Build { name, program: target.join(folder).join("lunoid") })
}

/// Those of [`WIDE`] that this processor has.
fn wide_vectors() -> Result<Vec<&'static str>, String> {
    let told = Command::new("rustc").args(["--print", "cfg", "-C", "target-cpu=native"]).output();
    let told = told.map_err(|error| format!("rustc: {error}"))?;
    let told = String::from_utf8_lossy(&told.stdout);
    let has = |vector: &&str| told.lines().any(|line| line == format!("target_feature=\"{vector}\""));
    Ok(WIDE.into_iter().filter(has).collect())
}
