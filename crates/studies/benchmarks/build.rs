//! The compiler and the optimisation of this build: counts of instructions are theirs.

use std::env;
use std::process::Command;

fn main() {
    let compiler = env::var_os("RUSTC").expect("cargo tells build scripts which compiler it runs");
    let version = Command::new(compiler).arg("--version").output().expect("the compiler tells its version");
    let version = String::from_utf8_lossy(&version.stdout);
    let level = env::var("OPT_LEVEL").expect("cargo tells build scripts how far it optimises");
    println!("cargo:rustc-env=BUILT_BY={}, opt-level {level}", version.trim());
    println!("cargo:rerun-if-changed=build.rs");
}
