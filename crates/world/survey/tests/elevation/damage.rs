//! Damaged bytes of files that use all that is read: an error or ground, and never a panic.

use std::fs;

use proptest::prelude::{ProptestConfig, any, proptest};
use survey::{ReadOptions, read};

use crate::made::{Directory, Field, LABEL, SIDE, bytes, floats, heights, quarters, words};

/// A TIFF with keys, items, an alpha band, a mask of bits and a strip that is left out.
fn tiff() -> Vec<u8> {
    let side = SIDE as u16;
    let mut two = Directory::ground().with(277, Field::Shorts(vec![2])).with(338, Field::Shorts(vec![2]));
    let pixels: Vec<f64> = heights().iter().flat_map(|height| [*height, 255.0]).collect();
    two.blocks = pixels.chunks(8 * SIDE).map(floats).collect();
    two.blocks[3].clear();
    let two = two.with_items(&[("SCALE", "0.5"), ("UNITTYPE", "ft"), ("NODATA_VALUES", "1 2")]);
    let tags = [(254, 4), (256, side), (257, side), (258, 1), (259, 1), (262, 4), (277, 1), (278, side)];
    bytes(&[two, Directory::new(&tags, vec![vec![0xa5; 3 * SIDE]])])
}

/// A label with an image behind it, special values and a range of valid ones.
fn label() -> Vec<u8> {
    let special = "UNIT = METER\n  INVALID_CONSTANT = (1..3, 16#FFFF#)\n  VALID_MINIMUM = -90\n  SAMPLE_BIT_MASK = 16#FFFF#";
    let text = LABEL.replace("UNIT = METER", special).replace("\"made.img\"", "25");
    let mut all = text.into_bytes();
    all.resize(24 * 48, b' ');
    all.extend(words(&quarters()));
    all
}

fn survived(name: &str, mut whole: Vec<u8>, at: usize, to: u8) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    let at = at % whole.len();
    whole[at] = to;
    fs::write(&path, whole).unwrap();
    let said = match read(&path, &ReadOptions::default()) {
        Ok(read) => format!("{} {}", read.title, read.notes.join(" ")),
        Err(error) => {
            assert!(error.to_string().contains(name), "{error}");
            error.to_string()
        }
    };
    assert!(!said.contains(char::is_control), "{said:?}");
}

#[test]
fn the_whole_files_are_read() {
    let folder = tempfile::tempdir().unwrap();
    for (name, bytes, voids) in [("made.tif", tiff(), 4 * SIDE), ("made.lbl", label(), 0)] {
        let path = folder.path().join(name);
        fs::write(&path, bytes).unwrap();
        let read = read(&path, &ReadOptions::default()).unwrap();
        assert!(read.voids() >= voids && read.range().is_some(), "{name}: {} voids", read.voids());
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]
    #[test]
    fn a_damaged_byte_is_survived(at in any::<usize>(), to in any::<u8>()) {
        // The directories and their values stand at the end of the file, the statements of a label at its beginning.
        let (tiff, label) = (tiff(), label());
        let tail = tiff.len() - 1 - at % 900;
        survived("made.tif", tiff, tail, to);
        survived("made.lbl", label, at % (24 * 48), to);
    }
}
