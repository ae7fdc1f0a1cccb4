//! What a drum must do on the average, or exactly (hardware section 8, number 10).

use data_bank::{DataBank, DrumUnit};
use hardware_model::{Channels, Drum, DrumQueue};
use quantities::{Tick, hash_words};

use crate::{OneStore, bank_of, demand, empty_bank, single};

/// Corners of the level of the tests below.
const CORNERS: u32 = 10_000;

/// All corners in a random order: records at places that do not follow from one another.
fn shuffled() -> Vec<u32> {
    let mut corners: Vec<u32> = (0..CORNERS).collect();
    corners.sort_by_key(|&corner| hash_words(1, &[u64::from(corner)]));
    corners
}

fn empty_row(drum: Drum) -> DataBank {
    empty_bank(drum, [1, CORNERS as usize])
}

#[test]
fn a_single_corner_waits_half_a_revolution_on_the_average() {
    let bank = empty_bank(single(700, 1.5, DrumQueue::Fifo), [1, 50]);
    let unit = bank.drums(0).next().unwrap();
    let sum: u64 = (0..unit.rotation)
        .map(|start| bank.clone().one(&demand(1, start, start + 2000, [17])))
        .map(|supply| {
            assert_eq!((supply.delivered, supply.busy[0]), (1, supply.latency_max));
            supply.latency_sum
        })
        .sum();
    // Every angle once: exact.
    assert_eq!(sum, unit.rotation * (unit.rotation - 1) / 2 + unit.rotation * unit.transfer);
}

#[test]
fn a_drum_is_near_its_design_and_a_slow_one_is_slow_in_both() {
    let design = Drum { count: 1000, ..single(1_000_000, 1000.0, DrumQueue::Fifo) };
    let bank = bank_of(design, Channels::default(), None, [10, 10], 5);
    let slowness: Vec<f64> = bank.drums(0).map(|unit| unit.rotation as f64 / 1e6 - 1.0).collect();
    let mean = slowness.iter().sum::<f64>() / 1000.0;
    let variance = slowness.iter().map(|slowness| slowness * slowness).sum::<f64>() / 1000.0;
    assert!(mean.abs() < 0.0006, "{mean}");
    assert!((variance.sqrt() - 0.005).abs() < 0.0004, "{variance}");
    for (unit, slowness) in bank.drums(0).zip(slowness) {
        assert!((unit.transfer as f64 - 9000.0 * (1.0 + slowness)).abs() <= 1.0);
        assert!(unit.start_angle < unit.rotation);
    }
}

#[test]
fn a_part_of_a_tick_takes_a_tick() {
    let transfer = |word| empty_row(single(100, word, DrumQueue::Fifo)).drums(0).next().unwrap().transfer;
    assert_eq!([0.0, 1e-9, 0.05, 0.15].map(transfer), [0, 1, 1, 2]);
}

/// Twenty new corners a frame, oldest first, each demanded for eight frames; utilisation asked for, and the fractions
/// of the time at work and of the requests that came to nothing.
fn stream(rotation: u64) -> [f64; 3] {
    let (frame_ticks, frames, each_frame) = (20_000, 400, 20);
    let corners = shuffled();
    let mut bank = empty_row(single(rotation, 10.0, DrumQueue::Fifo));
    let unit = bank.drums(0).next().unwrap();
    let [mut busy, mut requests, mut cancelled] = [0; 3];
    for frame in 0..frames {
        let wanted = &corners[frame as usize * each_frame..][..8 * each_frame];
        let times = [frame, frame + 1].map(|frame| frame * frame_ticks);
        let supply = bank.one(&demand(frame, times[0], times[1], wanted.iter().copied()));
        busy += supply.busy[0];
        requests += supply.requests;
        cancelled += supply.cancelled;
    }
    let mean = unit.rotation as f64 / 2.0 + unit.transfer as f64;
    [
        each_frame as f64 * mean / frame_ticks as f64,
        busy as f64 / (frames * frame_ticks) as f64,
        cancelled as f64 / requests as f64,
    ]
}

#[test]
fn utilisation_is_rate_times_latency_and_starvation_begins_at_one() {
    for rotation in [300, 600, 1000, 1500] {
        let [asked, busy, lost] = stream(rotation);
        assert!(asked < 0.9 && (busy / asked - 1.0).abs() < 0.03, "{rotation}: {asked} {busy}");
        assert_eq!(lost, 0.0, "{rotation}");
    }
    for rotation in [2500, 4000, 8000] {
        let [asked, busy, lost] = stream(rotation);
        assert!(asked > 1.1 && busy > 0.999, "{rotation}: {asked} {busy}");
        assert!((lost - (1.0 - 1.0 / asked)).abs() < 0.03, "{rotation}: {asked} {lost}");
    }
}

#[test]
fn shortest_latency_first_beats_first_come() {
    let corners = shuffled();
    let [fifo, shortest] = [DrumQueue::Fifo, DrumQueue::ShortestLatency].map(|queue| {
        let batches = corners.chunks(16).map(|batch| {
            let mut bank = empty_row(single(10_000, 10.0, queue));
            bank.one(&demand(1, 0, 1 << 30, batch.iter().copied())).busy[0]
        });
        batches.sum::<u64>() as f64 / f64::from(CORNERS)
    });
    // FIFO turns half a revolution to each of the 16; else two bring them all, for a few lie side by side.
    assert!((fifo / 5090.0 - 1.0).abs() < 0.03, "{fifo}");
    assert!(shortest < 2.0 * 10_000.0 / 16.0, "{shortest}");
}

#[test]
fn records_that_do_not_overlap_need_one_revolution() {
    let mut bank = empty_bank(single(10_000, 10.0, DrumQueue::ShortestLatency), [1, 100]);
    let unit = bank.drums(0).next().unwrap();
    let supply = bank.one(&demand(1, 777, 50_000, (0..100).rev()));
    assert_eq!(supply.delivered, 100);
    assert!(supply.latency_max < unit.rotation + unit.transfer);
    assert!(supply.busy[0] >= 100 * unit.transfer);
}

#[test]
fn drums_share_the_records() {
    let delivered = |count| {
        let drum = Drum { count, ..single(3000, 10.0, DrumQueue::Fifo) };
        empty_row(drum).one(&demand(1, 0, 1_000_000, shuffled())).delivered
    };
    let alone = delivered(1) as f64;
    for count in [2, 4, 8] {
        let gain = delivered(count) as f64 / alone;
        assert!((gain / f64::from(count) - 1.0).abs() < 0.05, "{count} drums: {gain}");
    }
}

/// Two drums with nothing in their buffer, and what the seed drew of them.
fn pair(channels: Channels) -> (DataBank, Vec<DrumUnit>) {
    let drum = Drum { count: 2, ..single(1000, 20.0, DrumQueue::Fifo) };
    let mut bank = bank_of(drum, channels, None, [1, 40], 1);
    bank.one(&demand(0, 0, 0, []));
    let units = bank.drums(0).collect();
    (bank, units)
}

/// Corners 0 and 1 are the first of drum 0 and of drum 1, both at place 0: each is under the heads when its drum has come
/// round from its start angle, and is read in 180 ticks.
#[test]
fn a_drum_that_finds_its_channel_taken_waits_for_the_next_turn() {
    let arrivals = |channels| {
        let (mut bank, units) = pair(channels);
        let supply = bank.one(&demand(1, 0, 10_000, [0, 1]));
        let arrivals = supply.missing.iter().map(|missing| missing.arrival.unwrap().0).collect::<Vec<_>>();
        (arrivals, supply, units)
    };
    let (own, supply, units) = arrivals(Channels::default());
    let passes =
        [0, 1].map(|drum: usize| (units[drum].rotation - units[drum].start_angle) % units[drum].rotation);
    assert_eq!(own, [0, 1].map(|drum| passes[drum] + units[drum].transfer));
    assert_eq!(supply.carried, [units[0].transfer, units[1].transfer]);
    // As the seed drew them, the passages overlap.
    let first = usize::from(passes[1] < passes[0]);
    let second = 1 - first;
    let word = 45.0;
    let transfer = 9 * 45;
    assert!(passes[second] - passes[first] < transfer && transfer < units[second].rotation);

    // One channel, and slower: both records are laid out longer, and the later drum needs another turn.
    let (shared, supply, _) = arrivals(Channels { count: Some(1), word });
    assert_eq!(shared[first], passes[first] + transfer);
    assert_eq!(shared[second], passes[second] + units[second].rotation + transfer);
    assert_eq!((supply.carried[0], supply.carried.len()), (2 * transfer, 1));
    // Both are at work until their record has come.
    assert_eq!(supply.busy, shared);
}

/// What fills the buffer before the mission is what a bank with nothing in its buffer brings.
#[test]
fn the_first_load_is_that_of_an_empty_bank() {
    for (count, word) in [(None, 0.0), (Some(1), 0.0), (Some(2), 30.0)] {
        let channels = Channels { count, word };
        let drum = Drum { count: 3, ..single(3000, 10.0, DrumQueue::ShortestLatency) };
        let fresh = bank_of(drum, channels, Some(9 * 30), [1, 40], 1);
        let found = fresh.first_load(&demand(0, 0, 1000, 0..35)).remove(0);
        let mut empty = bank_of(drum, channels, Some(9 * 30), [1, 40], 1);
        empty.one(&demand(0, 0, 0, []));
        let brought = empty.one(&demand(1, 0, 1 << 40, 0..35));
        assert_eq!((found.delivered, found.no_room, found.pending), (30, 5, 0));
        assert_eq!((found.latency_max, &found.busy), (brought.latency_max, &brought.busy));
        // The bank has not begun yet, and finds its buffer full.
        assert_eq!(fresh.clone().one(&demand(0, 0, 1000, 0..35)).present, 30);
    }
}

/// A channel that is no slower than its drums, and of which each has one, changes nothing.
#[test]
fn one_channel_a_drum_is_no_limit() {
    for count in [1, 3] {
        let drum = Drum { count, ..single(3000, 10.0, DrumQueue::ShortestLatency) };
        let supplies = [Channels::default(), Channels { count: Some(count), word: 9.8 }].map(|channels| {
            let mut bank = bank_of(drum, channels, Some(9 * 50), [1, CORNERS as usize], 1);
            let corners = shuffled();
            let frame = |frame: u64| {
                let wanted = corners[frame as usize * 7..][..40].iter().copied();
                bank.one(&demand(frame, frame * 4000, frame * 4000 + 4000, wanted))
            };
            (0..50).map(frame).collect::<Vec<_>>()
        });
        assert_eq!(supplies[0], supplies[1]);
        assert!(supplies[0].iter().any(|supply| supply.delivered > 0));
    }
}

#[test]
fn degenerate_drums_and_demands() {
    let instant = single(1, 0.0, DrumQueue::ShortestLatency);
    let supply = empty_bank(instant, [4, 4]).one(&demand(1, 5, 6, 0..16));
    assert!(supply.missing.iter().all(|missing| missing.arrival == Some(Tick(5))));
    assert_eq!((supply.delivered, supply.busy[0]), (16, 0));

    let long = Drum { record_words: 9 * 64, count: 7, ..single(100, 1.0, DrumQueue::Fifo) };
    let mut bank = empty_bank(long, [3, 5]);
    let supply = bank.one(&demand(1, 0, 10_000, 0..15));
    assert_eq!((supply.wanted, supply.requests, supply.delivered), (1, 1, 1));
    assert_eq!(supply.busy.len(), 7);
    assert!(supply.latency_max >= bank.drums(0).next().unwrap().transfer);

    let none = Drum { count: 0, record_words: 0, ..single(0, f64::NAN, DrumQueue::Fifo) };
    assert_eq!(empty_bank(none, [0, 0]).one(&demand(1, 0, 1, [3])).delivered, 1);
    let never = single(u64::MAX, f64::INFINITY, DrumQueue::ShortestLatency);
    let supply = empty_bank(never, [4, 4]).one(&demand(1, u64::MAX - 1, u64::MAX - 1, [3, 3]));
    assert_eq!((supply.pending, supply.missing.len()), (1, 1));
}

#[test]
fn the_mission_begins_with_a_full_buffer_and_the_nearest_stay() {
    let drum = single(100, 1.0, DrumQueue::Fifo);
    let mut bank = bank_of(drum, Channels::default(), Some(9 * 4 + 8), [1, 20], 1);
    let supply = bank.one(&demand(0, 0, 1000, [7, 6, 8, 5, 9, 4]));
    let missing: Vec<_> = supply.missing.iter().map(|missing| (missing.item, missing.arrival)).collect();
    assert_eq!(missing, [(4, None), (9, None)]);
    assert_eq!((supply.requests, supply.no_room, supply.words_held), (0, 2, 36));
    // One step on: 4 has moved up, 5 has become the farthest that the buffer held.
    let supply = bank.one(&demand(1, 1000, 2000, [6, 7, 4, 8, 5]));
    assert_eq!((supply.requests, supply.delivered, supply.evicted, supply.no_room), (1, 1, 1, 1));
    assert_eq!(supply.missing.iter().map(|missing| missing.item).collect::<Vec<_>>(), [4, 5]);

    let supply = bank_of(drum, Channels::default(), Some(8), [1, 20], 1).one(&demand(0, 0, 1000, [3]));
    assert_eq!((supply.requests, supply.no_room, supply.words_held, supply.missing.len()), (0, 1, 0, 1));
}
