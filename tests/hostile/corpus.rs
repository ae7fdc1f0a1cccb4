//! The kept files: hand-made by class, or found by a search. A file in `corpus/READER/` is refused by its reader.

use std::fs;
use std::path::Path;

use crate::readers::reader;

#[test]
fn every_kept_file_is_refused() {
    let corpus = Path::new(env!("CARGO_MANIFEST_DIR")).join("hostile/corpus");
    let folder = tempfile::tempdir().unwrap();
    let mut count = 0;
    for entry in fs::read_dir(corpus).unwrap() {
        let of_reader = entry.unwrap().path();
        let reader = reader(&of_reader.file_name().unwrap().to_string_lossy());
        for entry in fs::read_dir(&of_reader).unwrap() {
            let path = entry.unwrap().path();
            let said = reader.read(folder.path(), &fs::read(&path).unwrap());
            let said = said.expect_err(&path.display().to_string());
            let (lines, bytes) = (said.lines().count(), said.len());
            assert!(lines <= 200 && bytes < 50_000, "{}: {lines} lines, {bytes} bytes", path.display());
            count += 1;
        }
    }
    println!("{count} files");
    assert!(count >= 40, "{count} files");
}
