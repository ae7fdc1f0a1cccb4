//! GeoTIFF packed by Zstandard: files that tifffile wrote with the C library, read by the one in Rust.
//!
//! Each has 50 lines of 60 samples, `3 column - 7 line` times the scale of its row below; a second band is 1000 more.

use std::path::PathBuf;

use proptest::prelude::{ProptestConfig, any, proptest};
use survey::{ReadOptions, read};

/// File, scale of its samples, how many bands it has.
const FILES: [(&str, f64, usize); 5] = [
    ("strips-int16-predictor.tif", 1.0, 1),
    ("tiles-float32-predictor.tif", 0.25, 1),
    ("strips-float64-big-endian.tif", 0.5, 1),
    ("planes-int16.tif", 1.0, 2),
    ("pixels-int16.tif", 1.0, 2),
];

fn path(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/zstd").join(name)
}

fn of_band(band: usize) -> ReadOptions {
    ReadOptions { band: Some(band), ..ReadOptions::default() }
}

#[test]
fn strips_and_tiles_are_those_that_were_packed() {
    for (name, scale, bands) in FILES {
        for band in 0..bands {
            let found = read(path(name), &of_band(band + 1)).unwrap_or_else(|error| panic!("{error}"));
            assert_eq!((found.lines, found.columns), (50, 60), "{name}");
            for (line, column) in (0..50).flat_map(|line| (0..60).map(move |column| (line, column))) {
                let expected = (3.0 * column as f64 - 7.0 * line as f64) * scale + 1000.0 * band as f64;
                assert_eq!(
                    found.height(line, column),
                    Some(expected),
                    "{name}, band {band}, {line}, {column}"
                );
            }
        }
    }
}

#[test]
fn a_strip_that_is_cut_or_holds_too_little_names_itself() {
    let folder = tempfile::tempdir().unwrap();
    let bytes = std::fs::read(path("strips-int16-predictor.tif")).unwrap();
    // The frame of a strip begins with this number.
    let frames: Vec<usize> = bytes
        .windows(4)
        .enumerate()
        .filter(|(_, w)| *w == [0x28, 0xB5, 0x2F, 0xFD])
        .map(|(at, _)| at)
        .collect();
    assert_eq!(frames.len(), 4);
    let said = |change: &dyn Fn(&mut Vec<u8>)| {
        let (mut damaged, file) = (bytes.clone(), folder.path().join("ground.tif"));
        change(&mut damaged);
        std::fs::write(&file, damaged).unwrap();
        read(file, &of_band(1)).expect_err("it is damaged").to_string()
    };
    let no_frame = said(&|bytes| bytes[frames[1]] = 0);
    assert!(no_frame.contains("ground.tif, strip or tile 1: "), "{no_frame}");
    // A strip of the last two lines in place of sixteen.
    let short = said(&|bytes| bytes.copy_within(frames[3].., frames[2]));
    assert!(short.contains("strip or tile 2: Zstandard holds 240 bytes, expected 1920"), "{short}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]
    #[test]
    fn damage_is_survived(which in 0_usize..5, at in any::<usize>(), to in any::<u8>()) {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("ground.tif");
        let mut bytes = std::fs::read(path(FILES[which].0)).unwrap();
        let at = at % bytes.len();
        bytes[at] = to;
        std::fs::write(&file, bytes).unwrap();
        let _ = read(file, &of_band(1)).map_err(|error| error.to_string());
    }
}
