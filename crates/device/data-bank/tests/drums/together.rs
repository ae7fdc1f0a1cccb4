//! Several kinds of data on the same drums, and I/O processors that edit them.

use data_bank::{Contents, DataBank, Demand, DrumUnit, FrameSupply, Piece, StoreDesign};
use hardware_model::{Channels, Drum, DrumQueue};
use proptest::collection::vec;
use proptest::prelude::{Just, Strategy, any, prop_assert, prop_assert_eq, prop_oneof, proptest};
use quantities::Tick;

use crate::single;

/// A store of squares behind a buffer without limit.
fn squares(count: u32, record_words: u32, edit: f64) -> StoreDesign {
    StoreDesign { contents: Contents::Chains(count), record_words, buffer_words: None, edit }
}

/// Frames 0 and 1 of two stores: the first asks for nothing, so that the second begins with empty buffers.
fn second_frame(bank: &mut DataBank, wants: [Vec<Piece>; 2]) -> Vec<FrameSupply> {
    let frame = |frame, end, wants| Demand { frame, start: Tick(0), end: Tick(end), wants };
    bank.frame(&frame(0, 0, vec![vec![], vec![]]));
    bank.frame(&frame(1, 1_000_000, wants.into()))
}

fn one(items: &[u32]) -> Vec<Piece> {
    items.iter().map(|&item| Piece::one(item)).collect()
}

/// When the heads have turned to the record at `place` from `tick` on, and have read it.
fn read(unit: &DrumUnit, index: u32, tick: u64) -> u64 {
    unit.passes(unit.place(index), tick) + unit.transfer
}

#[test]
fn first_come_first_served_takes_the_kinds_in_turn() {
    let drum = single(1000, 2.0, DrumQueue::Fifo);
    let mut bank = DataBank::new(drum, Channels::default(), &[squares(50, 9, 0.0), squares(50, 30, 0.0)], 3);
    let units = [0, 1].map(|store| bank.drums(store).next().unwrap());
    assert_eq!(units[0].rotation, units[1].rotation);
    assert!(units[1].transfer > 3 * units[0].transfer);
    let supplies = second_frame(&mut bank, [one(&[7, 3]), one(&[20, 40])]);
    let mut tick = 0;
    let mut busy = [0; 2];
    for (store, record) in [(0, 7), (1, 20), (0, 3), (1, 40)] {
        let came = read(&units[store], record, tick);
        let missing = supplies[store].missing.iter().find(|missing| missing.item == record).unwrap();
        assert_eq!(missing.arrival, Some(Tick(came)), "{store} {record}");
        busy[store] += came - tick;
        tick = came;
    }
    // Each kind has its own share of the drum and of the channel.
    assert_eq!([supplies[0].busy[0], supplies[1].busy[0]], busy);
    assert_eq!([0, 1].map(|store: usize| supplies[store].carried[0]), units.map(|unit| 2 * unit.transfer));
}

#[test]
fn a_chain_is_there_with_its_last_record() {
    let drum = single(700, 1.0, DrumQueue::ShortestLatency);
    let mut bank = DataBank::new(drum, Channels::default(), &[squares(40, 20, 0.0), squares(40, 20, 0.0)], 5);
    let unit = bank.drums(0).next().unwrap();
    let chain = Piece { item: 11, records: 3 };
    let supplies = second_frame(&mut bank, [vec![chain], vec![]]);
    let missing = supplies[0].missing[0];
    assert_eq!((supplies[0].pieces, supplies[0].wanted, supplies[0].delivered), (1, 3, 3));
    // The three links lie 40 records apart; whichever comes under the heads first is read first.
    let mut left = vec![11, 51, 91];
    let mut tick = 0;
    while !left.is_empty() {
        let nearest = (0..left.len()).min_by_key(|&at| unit.passes(unit.place(left[at]), tick)).unwrap();
        tick = read(&unit, left.remove(nearest), tick);
    }
    assert_eq!((missing.item, missing.arrival), (11, Some(Tick(tick))));
}

#[test]
fn an_editor_takes_one_record_after_another_beside_the_drum() {
    let drum = single(500, 1.0, DrumQueue::Fifo);
    let edit = 40.0;
    let mut bank = DataBank::new(drum, Channels::default(), &[squares(9, 10, edit), squares(9, 10, 0.0)], 1);
    let unit = bank.drums(0).next().unwrap();
    let supplies = second_frame(&mut bank, [one(&[0, 1, 2, 3]), one(&[])]);
    let (mut tick, mut edited) = (0, 0);
    for record in 0..4 {
        tick = read(&unit, record, tick);
        edited = tick.max(edited) + 400;
        assert_eq!(supplies[0].missing[record as usize].arrival, Some(Tick(edited)));
        let spell = supplies[0].edits[record as usize];
        assert_eq!((spell.begun, spell.until), (edited - 400, edited));
    }
    // The processor is slower than the drum here: records wait for it.
    assert!(edited > tick + 800);
    assert_eq!(supplies[0].edited, 4 * 400);
}

/// What is edited as a frame ends goes on in the next one, and is read no second time.
#[test]
fn editing_goes_on_over_the_end_of_a_frame() {
    let drum = single(100, 1.0, DrumQueue::Fifo);
    let mut bank = DataBank::new(drum, Channels::default(), &[squares(9, 10, 100.0)], 1);
    let frame = |frame: u64, start, end, wants| Demand { frame, start: Tick(start), end: Tick(end), wants };
    bank.frame(&frame(0, 0, 0, vec![vec![]]));
    let first = bank.frame(&frame(1, 0, 500, vec![one(&[4])])).remove(0);
    assert_eq!((first.missing[0].arrival, first.pending, first.delivered), (None, 1, 0));
    assert_eq!(bank.state().stores[0].editing.len(), 1);
    let second = bank.frame(&frame(2, 500, 2000, vec![one(&[4])])).remove(0);
    assert_eq!((second.requests, second.delivered, second.busy[0]), (0, 1, 0));
    assert_eq!(second.missing[0].arrival, Some(Tick(first.busy[0] + 1000)));
    assert_eq!(first.edited + second.edited, 1000);
    // A record that nobody wants any more when it is done is not taken in.
    bank.frame(&frame(3, 2000, 2500, vec![one(&[5])]));
    bank.frame(&frame(4, 2500, 9000, vec![one(&[])]));
    assert!(bank.state().stores[0].held.iter().all(|held| held.record != 5));
}

fn designs() -> impl Strategy<Value = (Drum, Channels)> {
    let queue = prop_oneof![Just(DrumQueue::Fifo), Just(DrumQueue::ShortestLatency)];
    let channels = prop_oneof![Just(None), (1..3_u32).prop_map(Some)];
    (1..2000_u64, 0.0..20.0, queue, 1..4_u32, channels).prop_map(
        |(rotation, word, queue, count, channels)| {
            let drum = Drum { rotation, word, record_words: 9, queue, count };
            (drum, Channels { count: channels, word: 0.0 })
        },
    )
}

proptest! {
    /// Whatever is asked: no more than the whole time of a drum or of a channel is shared out, every piece is missing or there,
    /// and each buffer keeps to its own size.
    #[test]
    fn shares_add_up(
        (drum, channels) in designs(),
        stores in vec((9..60_u32, prop_oneof![Just(None), (9..400_u32).prop_map(Some)], 0.0..3.0), 1..5),
        frames in vec((1..4000_u64, vec((0..5_usize, 0..30_u32, 1..4_u32), 0..40)), 1..10),
        seed in any::<u64>(),
    ) {
        let design = |&(record_words, buffer_words, edit): &(u32, Option<u32>, f64)| StoreDesign {
            contents: Contents::Chains(30), record_words, buffer_words, edit,
        };
        let designs: Vec<StoreDesign> = stores.iter().map(design).collect();
        let mut bank = DataBank::new(drum, channels, &designs, seed);
        let mut start = 0;
        for (frame, (length, asked)) in (0..).zip(frames) {
            let mut wants = vec![vec![]; designs.len()];
            for (store, item, records) in asked {
                wants[store % designs.len()].push(Piece { item, records });
            }
            let end = start + length;
            let supplies = bank.frame(&Demand { frame, start: Tick(start), end: Tick(end), wants });
            for number in 0..supplies[0].busy.len() {
                prop_assert!(supplies.iter().map(|supply| supply.busy[number]).sum::<u64>() <= length);
            }
            for number in 0..supplies[0].carried.len() {
                prop_assert!(supplies.iter().map(|supply| supply.carried[number]).sum::<u64>() <= length);
            }
            for (supply, design) in supplies.iter().zip(&designs) {
                prop_assert!(supply.edited <= length);
                prop_assert!(supply.missing.len() as u64 <= supply.pieces);
                prop_assert!(design.buffer_words.is_none_or(|words| supply.words_held <= u64::from(words)));
                let arrivals = supply.missing.iter().filter_map(|missing| missing.arrival);
                prop_assert!(arrivals.into_iter().all(|tick| start <= tick.0 && tick.0 <= end));
            }
            start = end;
        }
    }

    /// A kind that nobody asks for leaves the others as they would be alone.
    #[test]
    fn a_kind_that_asks_for_nothing_changes_nothing(
        (drum, channels) in designs(),
        frames in vec((1..4000_u64, vec(0..30_u32, 0..20)), 1..10),
        seed in any::<u64>(),
    ) {
        let design = squares(30, 20, 0.5);
        let mut alone = DataBank::new(drum, channels, &[design], seed);
        let mut beside = DataBank::new(drum, channels, &[design, squares(30, 44, 2.0)], seed);
        let mut start = 0;
        for (frame, (length, asked)) in (0..).zip(frames) {
            let wants = vec![one(&asked)];
            let demand = Demand { frame, start: Tick(start), end: Tick(start + length), wants };
            let with_other = Demand { wants: vec![one(&asked), vec![]], ..demand.clone() };
            prop_assert_eq!(&alone.frame(&demand)[0], &beside.frame(&with_other)[0]);
            start += length;
        }
    }
}
