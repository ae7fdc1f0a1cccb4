//! The I/O processor between channel and storage buffer, which edits one record after another.

use std::collections::VecDeque;

use crate::EditSpell;
use crate::span::Span;

/// An I/O processor of one kind of data; master ticks.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Editor {
    /// Time of one record.
    ticks: u64,
    /// When the last record that it took is done.
    free_at: u64,
    /// Records that it has taken, with the tick at which each is done, ascending.
    work: VecDeque<(u32, u64)>,
}

impl Editor {
    /// An idle processor that takes `ticks` for a record.
    pub(crate) fn new(ticks: u64) -> Self {
        Self { ticks, free_at: 0, work: VecDeque::new() }
    }

    /// Takes records as the channels bring them: each with its tick, ascending.
    pub(crate) fn take(&mut self, arrived: &[(u32, u64)]) {
        for &(record, tick) in arrived {
            self.free_at = tick.max(self.free_at).saturating_add(self.ticks);
            self.work.push_back((record, self.free_at));
        }
    }

    /// Records that are done by `tick`, each with its tick.
    pub(crate) fn done_by(&mut self, tick: u64) -> Vec<(u32, u64)> {
        let count = self.work.partition_point(|&(_, done)| done <= tick);
        self.work.drain(..count).collect()
    }

    /// Whether a record is being edited, or waits for it.
    pub(crate) fn has(&self, record: u32) -> bool {
        self.work.iter().any(|&(taken, _)| taken == record)
    }

    /// Records taken and not done, each with the tick at which it will be.
    pub(crate) fn work(&self) -> impl Iterator<Item = (u32, u64)> {
        self.work.iter().copied()
    }

    /// When within `span` it edits the records that it has taken.
    pub(crate) fn spells(&self, span: Span) -> Vec<EditSpell> {
        let spell = |&(record, done): &(u32, u64)| {
            let [begun, until] = [done.saturating_sub(self.ticks), done].map(|tick| span.nearest(tick));
            EditSpell { record, begun, until }
        };
        self.work.iter().map(spell).filter(|spell| spell.begun < spell.until).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::Editor;
    use crate::span::Span;

    /// Record, begin and end of each spell.
    fn spells(editor: &Editor, start: u64, end: u64) -> Vec<(u32, u64, u64)> {
        let spells = editor.spells(Span { start, end });
        spells.iter().map(|spell| (spell.record, spell.begun, spell.until)).collect()
    }

    #[test]
    fn one_record_is_edited_after_another() {
        let mut editor = Editor::new(10);
        editor.take(&[(1, 100), (2, 103), (3, 150)]);
        assert_eq!(editor.work().collect::<Vec<_>>(), [(1, 110), (2, 120), (3, 160)]);
        assert_eq!(spells(&editor, 0, 155), [(1, 100, 110), (2, 110, 120), (3, 150, 155)]);
        assert!(editor.has(3) && !editor.has(4));
        assert_eq!(editor.done_by(120), [(1, 110), (2, 120)]);
        assert_eq!(spells(&editor, 155, 300), [(3, 155, 160)]);
        assert_eq!(editor.done_by(159), []);
    }

    #[test]
    fn one_that_takes_no_time_lets_records_through() {
        let mut editor = Editor::new(0);
        editor.take(&[(1, 5), (2, 5), (3, 9)]);
        assert_eq!(editor.done_by(9), [(1, 5), (2, 5), (3, 9)]);
        assert_eq!(spells(&editor, 0, 9), []);
    }
}
