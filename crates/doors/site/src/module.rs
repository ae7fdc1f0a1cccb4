//! The module, built by cargo.

use std::env;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::error::SiteError;

/// The target of the module.
const TARGET: &str = "wasm32-unknown-unknown";

/// The profile of the module.
const PROFILE: &str = "page";

/// The folder of the workspace.
pub fn workspace() -> Result<PathBuf, SiteError> {
    let manifest = said(cargo().args(["locate-project", "--workspace", "--message-format", "plain"]));
    let manifest = manifest.ok_or(SiteError::Cargo("find the workspace"))?;
    Ok(Path::new(manifest.trim()).parent().unwrap_or(Path::new(".")).to_owned())
}

/// Builds the module; where it lies.
pub fn build(workspace: &Path) -> Result<PathBuf, SiteError> {
    expect_target()?;
    let failed = SiteError::Cargo("build the module");
    let arguments = ["build", "--package", "browser", "--lib", "--target", TARGET, "--profile", PROFILE];
    let status = cargo().args(arguments).args(["--config", &without_paths()]).current_dir(workspace).status();
    if !status.is_ok_and(|status| status.success()) {
        return Err(failed);
    }
    let folder = env::var_os("CARGO_TARGET_DIR").map_or_else(|| workspace.join("target"), PathBuf::from);
    Ok(folder.join(TARGET).join(PROFILE).join("browser.wasm"))
}

/// Paths of this machine would stand in the messages of panics, and the same inputs would not give the same bytes elsewhere.
fn without_paths() -> String {
    let own = env::home_dir().unwrap_or_default().join(".cargo");
    let home = env::var_os("CARGO_HOME").map_or(own, PathBuf::from);
    format!("target.{TARGET}.rustflags = ['--remap-path-prefix={}=cargo']", home.display())
}

fn cargo() -> Command {
    let mut command = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.stderr(Stdio::inherit());
    command
}

/// What a command says, if it succeeds.
fn said(command: &mut Command) -> Option<String> {
    let output = command.output().ok().filter(|output| output.status.success())?;
    String::from_utf8(output.stdout).ok()
}

fn expect_target() -> Result<(), SiteError> {
    let rustc = env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let library = said(Command::new(rustc).args(["--print", "target-libdir", "--target", TARGET]));
    let is_there = library.is_some_and(|path| Path::new(path.trim()).is_dir());
    if is_there { Ok(()) } else { Err(SiteError::NoTarget(TARGET)) }
}
