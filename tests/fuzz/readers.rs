//! One reader of files, that of the variable `LUNOID_READER`, fed by libFuzzer: it may refuse, and must neither panic nor ask
//! for more memory than a file of that size may. `tests/fuzz/run` builds and runs it.

#![no_main]

#[path = "../hostile/allocation.rs"]
mod allocation;
#[path = "../hostile/readers.rs"]
mod readers;

use std::path::PathBuf;
use std::sync::LazyLock;

use libfuzzer_sys::fuzz_target;
use readers::{Reader, reader};

/// The reader, and the folder of its file.
static ROOM: LazyLock<(Reader, PathBuf)> = LazyLock::new(|| {
    let name =
        std::env::var("LUNOID_READER").expect("LUNOID_READER: the name of a reader, as tests/fuzz/run gives it");
    let folder = std::env::temp_dir().join(format!("lunoid-fuzz-{name}"));
    std::fs::create_dir_all(&folder).expect("a folder for its file");
    (reader(&name), folder)
});

fuzz_target!(|bytes: &[u8]| {
    let (reader, folder) = &*ROOM;
    let _ = reader.read(folder, bytes);
});
