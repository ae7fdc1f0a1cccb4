//! The I/O processor between channel and storage buffer, which edits one record after another.

use std::collections::VecDeque;

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

    /// Ticks of `span` in which the records that it has taken are edited.
    pub(crate) fn busy(&self, span: Span) -> u64 {
        self.work.iter().map(|&(_, done)| span.part(done.saturating_sub(self.ticks), done)).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::Editor;
    use crate::span::Span;

    #[test]
    fn one_record_is_edited_after_another() {
        let mut editor = Editor::new(10);
        editor.take(&[(1, 100), (2, 103), (3, 150)]);
        assert_eq!(editor.work().collect::<Vec<_>>(), [(1, 110), (2, 120), (3, 160)]);
        assert_eq!(editor.busy(Span { start: 0, end: 155 }), 25);
        assert!(editor.has(3) && !editor.has(4));
        assert_eq!(editor.done_by(120), [(1, 110), (2, 120)]);
        assert_eq!(editor.busy(Span { start: 155, end: 300 }), 5);
        assert_eq!(editor.done_by(159), []);
    }

    #[test]
    fn one_that_takes_no_time_lets_records_through() {
        let mut editor = Editor::new(0);
        editor.take(&[(1, 5), (2, 5), (3, 9)]);
        assert_eq!(editor.done_by(9), [(1, 5), (2, 5), (3, 9)]);
        assert_eq!(editor.busy(Span { start: 0, end: 9 }), 0);
    }
}
