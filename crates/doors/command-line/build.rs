//! The commit that is built, for `--version` and for the record of a run. Never the time of the build.

use std::process::Command;

fn main() {
    let describe = Command::new("git").args(["describe", "--always", "--dirty", "--abbrev=12"]).output();
    let commit = describe.ok().filter(|output| output.status.success());
    let commit = commit.and_then(|output| String::from_utf8(output.stdout).ok());
    println!("cargo:rustc-env=LUNOID_COMMIT={}", commit.as_deref().map_or("unknown", str::trim));
    // Sources decide whether the tree is dirty, the head which commit it is.
    println!("cargo:rerun-if-changed=..");
    for name in ["HEAD", "logs/HEAD"] {
        let path = Command::new("git").args(["rev-parse", "--git-path", name]).output();
        if let Some(path) = path.ok().and_then(|output| String::from_utf8(output.stdout).ok()) {
            println!("cargo:rerun-if-changed={}", path.trim());
        }
    }
}
