//! The hash of the ordered events.

use proptest::collection::vec;
use proptest::prelude::{any, prop_assert_eq, prop_assert_ne, proptest};
use timing::EventHash;

type Event = (u64, String, String, Vec<u64>);

fn hash_of(events: &[Event]) -> EventHash {
    let mut hash = EventHash::new();
    for (tick, unit, what, words) in events {
        hash.push(*tick, unit, what, words);
    }
    hash
}

fn joined(sweeps: &[Vec<Event>]) -> (u64, String) {
    EventHash::join(sweeps.iter().map(|events| hash_of(events).part()))
}

fn event(tick: u64, unit: &str, what: &str, words: &[u64]) -> Event {
    (tick, unit.into(), what.into(), words.into())
}

#[test]
fn no_two_lists_are_written_alike() {
    let lists = [
        vec![],
        vec![event(1, "ab", "c", &[])],
        vec![event(1, "a", "bc", &[])],
        vec![event(1, "a", "bc", &[0])],
        vec![event(1, "a", "bc", &[0, 0])],
        vec![event(1, "a", "bc", &[0, 0, 0])],
        vec![event(1, "a", "bc", &[]), event(0, "", "", &[])],
        vec![event(2, "a", "bc", &[])],
    ];
    for (index, list) in lists.iter().enumerate() {
        assert_eq!(hash_of(list).finish().0, list.len() as u64);
        for other in &lists[..index] {
            assert_ne!(hash_of(list).finish().1, hash_of(other).finish().1, "{list:?} {other:?}");
        }
    }
}

#[test]
fn sweeps_are_no_events_and_their_bounds_count() {
    let [a, b] = [event(1, "a", "b", &[1]), event(2, "a", "b", &[2])];
    let together = joined(&[vec![a.clone(), b.clone()]]);
    let apart = joined(&[vec![a.clone()], vec![b.clone()]]);
    let moved = joined(&[vec![], vec![a.clone(), b.clone()]]);
    assert_eq!([together.0, apart.0, moved.0], [2; 3]);
    assert!(together.1 != apart.1 && together.1 != moved.1 && apart.1 != moved.1);
    assert_ne!(hash_of(&[a, b]).finish().1, together.1);
    assert_ne!(joined(&[]).1, hash_of(&[]).finish().1);
}

/// Baselines under version control name these digits.
#[test]
fn hashes_never_change() {
    let hash = hash_of(&[event(40, "loader.red", "strobe", &[1, 2, 3])]);
    assert_eq!(hash.finish().1, "db6d03e614f519dbe0eaea8c29ac4931302ea0af81a79b529f9099db59c52f1a");
    assert_eq!(
        EventHash::join([hash.part()].into_iter()).1,
        "63eb5038095dbe4a84eb1da7f4d90a686e7185ff7dabf5a96e549e69ac3ae2ee"
    );
}

proptest! {
    #[test]
    fn order_counts(mut events in vec(any::<Event>(), 2..8), at in any::<(usize, usize)>()) {
        let (i, j) = (at.0 % events.len(), at.1 % events.len());
        let before = hash_of(&events).finish();
        let sweeps: Vec<_> = events.iter().map(|event| vec![event.clone()]).collect();
        let is_same = events[i] == events[j];
        events.swap(i, j);
        prop_assert_eq!(hash_of(&events).finish() == before, is_same);
        let mut swapped = sweeps.clone();
        swapped.swap(i, j);
        prop_assert_eq!(joined(&swapped) == joined(&sweeps), is_same);
    }

    #[test]
    fn every_word_counts(mut event in any::<Event>(), bit in 0u32..64) {
        let before = hash_of(&[event.clone()]).finish();
        event.0 ^= 1 << bit;
        prop_assert_ne!(hash_of(&[event]).finish(), before);
    }
}

/// A list longer than what is hashed at once: the hash is that of all its bytes in a row.
#[test]
fn long_lists_are_hashed_whole() {
    let (mut hash, mut bytes) = (EventHash::new(), Vec::new());
    for tick in 0..5000_u64 {
        hash.push(tick, "red", "x-first", &[7, tick]);
        let numbers =
            |numbers: &[u64]| numbers.iter().flat_map(|number| number.to_le_bytes()).collect::<Vec<_>>();
        bytes.extend(
            [&numbers(&[tick, 3])[..], b"red", &numbers(&[7]), b"x-first", &numbers(&[2, 7, tick])].concat(),
        );
    }
    let mut whole = blake3::Hasher::new_derive_key("lunoid timing, ordered digital events, format 1");
    assert_eq!(hash.finish(), (5000, whole.update(&bytes).finalize().to_hex().to_string()));
}
