//! The data bank's books balance, whatever is demanded.

use data_bank::{Demand, FrameSupply, Piece};
use hardware_model::{Channels, Drum, DrumQueue};
use proptest::collection::vec;
use proptest::prelude::{Just, Strategy, any, prop_assert, prop_assert_eq, prop_oneof, proptest};
use proptest::test_runner::TestCaseError;
use quantities::Tick;

use crate::{OneStore, bank_of, demand};

const SIZE: [usize; 2] = [40, 30];

fn designs() -> impl Strategy<Value = Drum> {
    let queue = prop_oneof![Just(DrumQueue::Fifo), Just(DrumQueue::ShortestLatency)];
    (1..100_000_u64, 0.0..300.0, 1..5_u32, queue, 1..6_u32).prop_map(
        |(rotation, word, side, queue, count)| Drum {
            rotation,
            word,
            record_words: 9 * side * side,
            queue,
            count,
        },
    )
}

/// As many as drums or fewer, faster and slower than they.
fn channels() -> impl Strategy<Value = Channels> {
    (prop_oneof![Just(None), (1..5_u32).prop_map(Some)], prop_oneof![Just(0.0), 0.0..300.0])
        .prop_map(|(count, word)| Channels { count, word })
}

/// Rectangles that wander over the level, at frames of any length.
fn demands() -> impl Strategy<Value = Vec<Demand>> {
    let rectangle = (0..30_u32, 0..20_u32, 0..10_u32, 0..10_u32);
    vec((rectangle, 0..200_000_u64), 1..12).prop_map(|frames| {
        let mut start = 0;
        (0..)
            .zip(frames)
            .map(|(frame, ((m, n, rows, columns), length))| {
                let corners = (m..m + rows).flat_map(|m| (n..n + columns).map(move |n| m * 30 + n));
                let demand = demand(frame, start, start + length, corners);
                start += length;
                demand
            })
            .collect()
    })
}

fn check(
    supply: &FrameSupply,
    demand: &Demand,
    pending: u64,
    capacity: Option<u32>,
) -> Result<(), TestCaseError> {
    let ordered = pending - supply.cancelled + supply.requests;
    prop_assert_eq!(supply.wanted, supply.present + supply.no_room + ordered);
    prop_assert_eq!(ordered, supply.delivered + supply.pending);
    prop_assert!(capacity.is_none_or(|words| supply.words_held <= u64::from(words)));
    prop_assert!(capacity.is_some() || supply.no_room + supply.evicted == 0);
    let length = demand.end.0 - demand.start.0;
    prop_assert!(supply.busy.iter().all(|&busy| busy <= length));
    prop_assert!(supply.missing.is_sorted_by(|a, b| a.item < b.item));
    for missing in &supply.missing {
        prop_assert!(demand.wants[0].contains(&Piece::one(missing.item)));
        prop_assert!(missing.arrival.is_none_or(|at| demand.start <= at && at <= demand.end));
    }
    let all_came = supply.missing.iter().all(|missing| missing.arrival.is_some());
    prop_assert_eq!(all_came, supply.pending + supply.no_room == 0);
    prop_assert_eq!(supply.missing.is_empty(), supply.present == supply.wanted);
    Ok(())
}

proptest! {
    #[test]
    fn no_request_is_lost_and_the_buffer_never_overflows(
        design in designs(), channels in channels(), seed in any::<u64>(), words in prop_oneof![Just(None), (0..4000_u32).prop_map(Some)],
        demands in demands(),
    ) {
        let mut bank = bank_of(design, channels, words, SIZE, seed);
        let mut pending = 0;
        for demand in &demands {
            let supply = bank.one(demand);
            check(&supply, demand, pending, words)?;
            pending = supply.pending;
        }
    }

    #[test]
    fn a_clone_goes_on_like_the_original(design in designs(), channels in channels(), seed in any::<u64>(), demands in demands()) {
        let mut bank = bank_of(design, channels, Some(3000), SIZE, seed);
        let (before, after) = demands.split_at(demands.len() / 2);
        before.iter().for_each(|demand| { bank.one(demand); });
        let mut copy = bank.clone();
        let mut again = bank_of(design, channels, Some(3000), SIZE, seed);
        before.iter().for_each(|demand| { again.one(demand); });
        for demand in after {
            let supply = bank.one(demand);
            prop_assert_eq!(&supply, &copy.one(demand));
            prop_assert_eq!(&supply, &again.one(demand));
        }
    }

    #[test]
    fn what_stays_demanded_arrives(design in designs(), channels in channels(), seed in any::<u64>(), demands in demands()) {
        let mut bank = bank_of(design, channels, None, SIZE, seed);
        let mut start = Tick(0);
        for demand in &demands {
            bank.one(demand);
            start = demand.end;
        }
        // Each of at most 100 records takes at most a slow revolution and a slow transfer: while one waits, a channel is never
        // free for longer than a revolution.
        let transfer = f64::from(design.record_words) * design.word.max(channels.word);
        let longest = ((design.rotation as f64 + transfer) * 1.03) as u64 + 2;
        let last = Demand { start, end: Tick(start.0 + 100 * longest), ..demands.last().unwrap().clone() };
        prop_assert_eq!(bank.one(&last).pending, 0);
    }
}
