//! Files that are read piece by piece.

use std::fs;

use files::{FileError, FilePieces, Pieces};

#[test]
fn a_piece_is_the_bytes_from_its_offset_on() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("numbers");
    let bytes: Vec<u8> = (0..=255).collect();
    fs::write(&path, &bytes).expect("written");
    let mut file = FilePieces::open(&path, 256).expect("it just fits");
    assert_eq!(file.length(), 256);
    for (offset, length) in [(250, 6), (0, 256), (17, 100), (256, 0)] {
        let piece = file.take(offset as u64, length).expect("inside");
        assert_eq!(piece, bytes[offset..][..length]);
        assert_eq!(Ok(piece), bytes.as_slice().take(offset as u64, length));
    }
    assert!(matches!(FilePieces::open(&path, 255), Err(FileError::TooLarge { bytes: 256, .. })));
    assert!(matches!(FilePieces::open(folder.path(), 255), Err(FileError::IsFolder { .. })));
    assert!(matches!(FilePieces::open(folder.path().join("none"), 255), Err(FileError::Missing { .. })));
}

#[test]
fn a_file_that_becomes_shorter_is_an_error() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("numbers");
    fs::write(&path, [7; 100]).expect("written");
    let mut file = FilePieces::open(&path, 100).expect("ours");
    fs::write(&path, [7; 50]).expect("written");
    assert_eq!(file.take(0, 50).expect("still there"), [7; 50]);
    let error = file.take(40, 20).expect_err("gone");
    assert_eq!(error.path(), path);
}

/// A pipe has no places to go to, and does not tell how long it is.
#[cfg(target_os = "linux")]
#[test]
fn a_pipe_is_read_whole() {
    use std::io::Write;
    use std::os::fd::AsRawFd;

    let (end, mut start) = std::io::pipe().expect("a pipe");
    start.write_all(b"0123456789").expect("room for ten");
    drop(start);
    let mut pieces = FilePieces::open(format!("/proc/self/fd/{}", end.as_raw_fd()), 10).expect("ten fit");
    assert_eq!(pieces.length(), 10);
    assert_eq!(pieces.take(3, 4).expect("inside"), b"3456");
}
