//! Whole files of every reader, in a folder for each: what a fuzzer begins with.
//!
//! `cargo run -p lunoid-tests --example seeds -- FOLDER`; `tests/fuzz/run` does.

#[allow(dead_code, reason = "other tests need the rest")]
mod allocation;
#[path = "../../crates/doors/lunoid/tests/bad_input/build.rs"]
#[allow(dead_code, reason = "other tests need the rest")]
mod build;
#[allow(dead_code, reason = "nothing is read here")]
mod readers;
mod seeds;

use std::path::PathBuf;
use std::{env, fs, io};

fn main() -> io::Result<()> {
    let folder = env::args_os().nth(1).map(PathBuf::from);
    let folder = folder.ok_or_else(|| io::Error::other("expected a folder to write into"))?;
    for reader in readers::READERS {
        let folder = folder.join(reader.name);
        fs::create_dir_all(&folder)?;
        for (number, bytes) in seeds::seeds(reader.name).iter().enumerate() {
            fs::write(folder.join(format!("whole-{number}")), bytes)?;
        }
    }
    Ok(())
}
