//! The container: whatever is written is read, and whatever is damaged is refused by name.

mod written;

use proptest::prelude::*;
use state::{Fault, Gone, State};

use written::{example, reworded, sealed, state};

fn refusal(bytes: &[u8]) -> String {
    State::parse(bytes).expect_err("a damaged file").to_string()
}

fn gone() -> impl Strategy<Value = Gone> {
    prop_oneof![
        Just(Gone::Nothing),
        (1..u64::MAX).prop_map(Gone::Ticks),
        (1..u32::MAX).prop_map(Gone::Samples)
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn what_is_written_is_read(
        frame in 0..u64::MAX / 2, sweep in 0..9_u32, gone in gone(), stores in 0..4_u64,
        words in proptest::collection::vec(".{0,12}", 0..4),
    ) {
        let state = state(frame, sweep, gone, stores, words);
        let bytes = state.bytes();
        let read = State::parse(&bytes).unwrap();
        prop_assert_eq!(read.bytes(), bytes);
        prop_assert_eq!(read, state);
    }

    #[test]
    fn one_wrong_bit_is_refused(at in 0..1_usize << 20, bit in 0..8_u32) {
        let mut bytes = example().bytes();
        let at = at % bytes.len();
        bytes[at] ^= 1_u8 << bit;
        prop_assert!(State::parse(&bytes).is_err());
    }

    #[test]
    fn no_part_of_a_file_is_a_state(end in 0..1_usize << 20) {
        let bytes = example().bytes();
        let end = end % bytes.len();
        let found = State::parse(&bytes[..end]);
        let is_named = matches!(found, Err(Fault::Length { .. } | Fault::NotState { .. }));
        prop_assert!(is_named, "{:?}", found);
    }

    /// Whoever makes the checksum good gets another state or a refusal, and no panic.
    #[test]
    fn any_bytes_behind_a_good_checksum(changes in proptest::collection::vec((0..1_usize << 20, any::<u8>()), 1..20)) {
        let mut bytes = example().bytes();
        let length = bytes.len();
        changes.iter().for_each(|(at, byte)| bytes[at % length] = *byte);
        let bytes = sealed(bytes);
        if let Ok(state) = State::parse(&bytes) {
            prop_assert!(state.blocks.iter().all(|block| block.values.iter().all(|value| value.is_finite())));
        }
    }
}

#[test]
fn every_damage_has_its_name() {
    let bytes = example().bytes();
    let changed = |at: usize, byte: u8| {
        let mut bytes = bytes.clone();
        bytes[at] = byte;
        bytes
    };
    let value = bytes.len() - 4;
    let mut nan = bytes.clone();
    nan[value..].copy_from_slice(&f32::NAN.to_le_bytes());
    for (bytes, words) in [
        (b"PNG and more".to_vec(), &["byte 0: found `PNG and `", "expected `LUNOSTAT`"][..]),
        (bytes[..40].to_vec(), &["the file has 40 bytes, expected 64"]),
        (bytes[..value].to_vec(), &["bytes, expected", "take a whole copy"]),
        ([&bytes[..], b"more"].concat(), &["bytes, expected", "take a whole copy"]),
        (changed(8, 2), &["byte 8: found format 2, expected 1"]),
        (changed(70, b'x'), &["byte 32: found checksum"]),
        (sealed(changed(24, 1)), &["byte 24, reserved: found 1, expected 0"]),
        (sealed(changed(15, 0x7f)), &["header: found a length of 2130", "which are left in the file"]),
        (sealed(nan), &["picture of frame 4, row 3, value 2", "found NaN, expected a finite number"]),
        (
            reworded("lunoid.state/1", "lunoid.state/9"),
            &["found schema `lunoid.state/9`, expected `lunoid.state/1`"],
        ),
        (reworded("\"tick\":", "\"tock\":"), &["header, line", "unknown field `tock`"]),
        (
            reworded("\"kind\": \"rows\"", "\"kind\": \"store\""),
            &["header, blocks: found store 5, store 3", "expected rows, then stores"],
        ),
        (
            reworded("\"digital_bytes\": ", "\"digital_bytes\": 9"),
            &["digital side: found a length of 9", "which are left"],
        ),
        (
            reworded("\"rows\": 2,", "\"rows\": 18446744073709551615,"),
            &["rows of frame 5: found a length of 18446744073709551615 bytes"],
        ),
        (reworded("\"rows\": 2,", "\"rows\": 1,"), &["bytes behind the last block: found 12, expected 0"]),
    ] {
        let said = refusal(&bytes);
        assert!(words.iter().all(|words| said.contains(words)), "{words:?}: {said}");
    }
}
