//! Whole files, damaged, to every reader.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::time::{Duration, Instant};

use lunoid_tests::Dice;

use crate::mutation::{damaged, resealed, resealed_state};
use crate::readers::{READERS, Reader};
use crate::seeds::seeds;

/// Longest that a reader may think about a file of some kilobytes, on a busy computer.
const LONGEST: Duration = Duration::from_secs(20);

/// The file of a number.
fn file(reader: &Reader, seeds: &[Vec<u8>], number: u64) -> Vec<u8> {
    let mut dice = Dice::new(number);
    let seed = &seeds[dice.count(0, seeds.len() - 1)];
    let other = &seeds[dice.count(0, seeds.len() - 1)];
    let bytes = damaged(&mut dice, seed, other);
    match reader.name {
        "bank" if dice.count(0, 4) > 0 => resealed(bytes),
        "state" if dice.count(0, 4) > 0 => resealed_state(bytes),
        _ => bytes,
    }
}

/// Reads files `numbers` of `reader`; how many it refused. Whatever fails says how to make the file again.
fn search(reader: &Reader, numbers: std::ops::Range<u64>, folder: &Path) -> u64 {
    let (seeds, mut refused) = (seeds(reader.name), 0);
    for number in numbers {
        let bytes = file(reader, &seeds, number);
        let began = Instant::now();
        let read = catch_unwind(AssertUnwindSafe(|| reader.read(folder, &bytes)));
        let again = || {
            let path = std::env::temp_dir().join(format!("hostile-{}-{number}-{}", reader.name, reader.file));
            let kept = std::fs::write(&path, &bytes);
            format!("{} number {number}, kept as {} ({kept:?})", reader.name, path.display())
        };
        match read {
            Ok(result) => refused += u64::from(result.is_err()),
            Err(_) => panic!("{}", again()),
        }
        assert!(began.elapsed() < LONGEST, "{:?} for {}", began.elapsed(), again());
    }
    refused
}

/// The same of every reader.
pub fn search_all(numbers: std::ops::Range<u64>) {
    let folder = tempfile::tempdir().unwrap();
    for reader in READERS {
        for (index, seed) in seeds(reader.name).iter().enumerate() {
            let whole = reader.read(folder.path(), seed);
            assert_eq!(whole, Ok(()), "{} {index} is whole", reader.name);
        }
        let count = numbers.end - numbers.start;
        let refused = search(&reader, numbers.clone(), folder.path());
        println!("{}: {refused} of {count} refused", reader.name);
        // Damage that never does, and damage that always does, would search nothing.
        assert!(refused > count / 20 && refused < count, "{}: {refused} of {count}", reader.name);
    }
}

#[test]
fn no_damage_panics_or_asks_for_much() {
    search_all(0..400);
}
