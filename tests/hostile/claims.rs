//! Headers that claim sixteen gigabytes, or more than can be counted, in files of some hundred bytes.

use crate::build::{Tiff, npy};
use crate::mutation::{resealed, resealed_state};
use crate::readers::reader;
use crate::seeds::seeds;

/// `reader` refuses `bytes`; most_memory of a small file is a few megabytes, which the reader checks.
fn refused(name: &str, bytes: &[u8]) {
    let folder = tempfile::tempdir().unwrap();
    let said = reader(name).read(folder.path(), bytes);
    assert!(said.is_err(), "{name}: a claim that cannot be is believed");
}

/// Every word of four and of eight bytes of a whole file in turn, at even places, says that there is much.
fn claims_everywhere(name: &str, head: usize, again: impl Fn(Vec<u8>) -> Vec<u8>) {
    let folder = tempfile::tempdir().unwrap();
    let mut refused = 0;
    for seed in seeds(name) {
        for at in (0..seed.len().min(head)).step_by(2) {
            for claim in [1_u64 << 34, u64::MAX, 0x4000_0000] {
                for (width, big) in [(4, false), (8, false), (4, true), (8, true)] {
                    let mut bytes = seed.clone();
                    let word = if big { claim.to_be_bytes() } else { claim.to_le_bytes() };
                    let word = if big { &word[8 - width..] } else { &word[..width] };
                    let Some(place) = bytes.get_mut(at..at + width) else { continue };
                    place.copy_from_slice(word);
                    refused += u32::from(reader(name).read(folder.path(), &again(bytes)).is_err());
                }
            }
        }
    }
    println!("{name}: {refused} claims refused");
    assert!(refused > 200, "{name}: {refused}");
}

#[test]
fn sizes_in_headers_are_held_against_the_file() {
    let tiff = |columns, lines| Tiff { columns, lines, heights: vec![0.0; 4], ..Tiff::plane() }.bytes();
    refused("geotiff", &tiff(65_536, 65_536));
    refused("geotiff", &tiff(u32::MAX, u32::MAX));
    for shape in [
        "(65536, 32768)",
        "(9223372036854775807, 9)",
        "(18446744073709551615, 2)",
        "(4294967296, 4294967296)",
    ] {
        refused("npy", &npy("<f8", shape, &[0; 64]));
    }
    let label = String::from_utf8_lossy(&seeds("pds")[0]).into_owned();
    for (lines, samples) in [("65536", "131072"), ("18446744073709551615", "3"), ("4294967296", "4294967296")]
    {
        let label = label.replace("LINES = 2", &format!("LINES = {lines}"));
        refused("pds", label.replace("LINE_SAMPLES = 3", &format!("LINE_SAMPLES = {samples}")).as_bytes());
    }
}

#[test]
fn every_word_of_a_bank_may_claim() {
    claims_everywhere("bank", 400, resealed);
}

#[test]
fn every_word_of_a_state_may_claim() {
    claims_everywhere("state", 400, resealed_state);
}

#[test]
fn every_word_of_a_geotiff_may_claim() {
    claims_everywhere("geotiff", 400, |bytes| bytes);
}

#[test]
fn every_word_of_a_picture_may_claim() {
    claims_everywhere("png", 60, |bytes| bytes);
}
