//! Rows of whole numbers without loss in few bytes: differences, then the code of Rice.
//!
//! A row is predicted from the one or two rows before it, and the differences are taken along the row once or twice. Of the four ways
//! a row takes the shortest. All sums wrap, so any number comes back.

use crate::rice::{Reader, Writer, bits};

/// Orders of the differences to the rows before and along the row.
const WAYS: [[usize; 2]; 4] = [[1, 1], [1, 2], [2, 1], [2, 2]];
/// Bits with which a row begins: its way, and its parameter.
const HEAD: [u32; 2] = [2, 6];

/// Rows of equal width as bytes.
pub(crate) fn encoded(rows: impl Iterator<Item = Vec<i64>>) -> Vec<u8> {
    let mut writer = Writer::default();
    let mut before = [Vec::new(), Vec::new()];
    for (number, row) in rows.enumerate() {
        let rows = before.each_ref().map(Vec::as_slice);
        let ways = WAYS.map(|way| differences(&row, rows, [way[0].min(number), way[1]]));
        let best = (0..WAYS.len()).map(|way| (shortest(&ways[way]), way)).min();
        let ((_, k), way) = best.unwrap_or_default();
        writer.put(way as u64, HEAD[0]);
        writer.put(k.into(), HEAD[1]);
        ways[way].iter().for_each(|value| writer.rice(*value, k));
        let [last, _] = before;
        before = [row, last];
    }
    writer.finish()
}

/// Differences of a row: of order `down` to the rows before it, then of order `along`; without signs.
fn differences(row: &[i64], before: [&[i64]; 2], [down, along]: [usize; 2]) -> Vec<u64> {
    let mut values: Vec<i64> =
        (0..row.len()).map(|at| row[at].wrapping_sub(predicted(before, down, at))).collect();
    for _ in 0..along {
        (1..values.len()).rev().for_each(|at| values[at] = values[at].wrapping_sub(values[at - 1]));
    }
    values.into_iter().map(|value| ((value << 1) ^ (value >> 63)) as u64).collect()
}

/// Value that the rows before a row let expect.
fn predicted([last, older]: [&[i64]; 2], down: usize, at: usize) -> i64 {
    match down {
        0 => 0,
        1 => last[at],
        _ => last[at].wrapping_mul(2).wrapping_sub(older[at]),
    }
}

/// Fewest bits of a row, and the parameter that takes them. The best parameter lies near the logarithm of the mean. The first value is
/// left out of it: it is no difference along the row, and often far larger.
fn shortest(values: &[u64]) -> (u64, u32) {
    let total: u128 = values.iter().skip(1).map(|value| u128::from(*value)).sum();
    let mean = (total / values.len().max(1) as u128) as u64;
    let middle = 63 - (mean | 1).leading_zeros();
    let near = middle.saturating_sub(2)..=(middle + 1).min(63);
    let length = |k: u32| values.iter().map(|value| bits(*value, k)).sum();
    near.map(|k| (length(k), k)).min().unwrap_or_default()
}

/// Reads rows and hands each to `take` with its number; `None` if the bytes are no such rows.
pub(crate) fn decode(
    bytes: &[u8],
    [width, height]: [usize; 2],
    mut take: impl FnMut(usize, &[i64]),
) -> Option<()> {
    let mut reader = Reader::new(bytes);
    let [mut row, mut last, mut older] = [const { Vec::new() }; 3].map(|_: Vec<i64>| vec![0; width]);
    for number in 0..height {
        let way = WAYS[reader.take(HEAD[0])? as usize];
        let k = reader.take(HEAD[1])? as u32;
        for value in &mut row {
            let code = reader.rice(k)?;
            *value = (code >> 1) as i64 ^ -((code & 1) as i64);
        }
        restore(&mut row, [&last, &older], [way[0].min(number), way[1]]);
        take(number, &row);
        std::mem::swap(&mut last, &mut older);
        std::mem::swap(&mut row, &mut last);
    }
    reader.is_finished().then_some(())
}

/// Turns differences back into a row.
fn restore(row: &mut [i64], before: [&[i64]; 2], [down, along]: [usize; 2]) {
    for _ in 0..along {
        (1..row.len()).for_each(|at| row[at] = row[at].wrapping_add(row[at - 1]));
    }
    if down > 0 {
        (0..row.len()).for_each(|at| row[at] = row[at].wrapping_add(predicted(before, down, at)));
    }
}
