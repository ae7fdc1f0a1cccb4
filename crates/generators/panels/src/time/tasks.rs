//! Work in pieces into tasks with their times, routine by routine.

use panel_program::{FillPieces, SIDE, Work, WrittenFill};
use timing::Task;

use super::Hardware;

/// The unit that does everything.
pub(super) const COMPUTER: &str = "cpu";

/// Bytes that a record moves, whatever it holds: all files of the listing have RECORDSIZE=128, in words of four bytes.
const RECORD: u64 = SIDE as u64;

/// Operations of one piece.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
struct Operations {
    /// Numbers read or written by format.
    numbers: u64,
    /// Bytes that records move.
    bytes: u64,
    multiplications: u64,
    divisions: u64,
    roots: u64,
    /// Sines and cosines that are taken.
    trigs: u64,
    /// Elements of arrays that are read or written.
    cells: u64,
    /// Additions, comparisons, branches, counts of loops.
    others: u64,
}

impl Operations {
    const NONE: Self = Self {
        numbers: 0,
        bytes: 0,
        multiplications: 0,
        divisions: 0,
        roots: 0,
        trigs: 0,
        cells: 0,
        others: 0,
    };

    /// The time of these operations (ns).
    fn time(&self, hardware: &Hardware) -> u64 {
        self.numbers * hardware.formatted_number
            + self.bytes * hardware.record_byte
            + self.multiplications * hardware.multiply
            + self.divisions * hardware.divide
            + self.roots * hardware.root
            + self.trigs * hardware.trig
            + self.cells * hardware.cell
            + self.others * hardware.instruction
    }
}

/// Operations of a piece of each task, by the listing's statements.
mod piece {
    use super::{Operations, RECORD};

    const NONE: Operations = Operations::NONE;
    pub const NUMBER: Operations = Operations { numbers: 1, ..NONE };
    pub const BYTE: Operations = Operations { bytes: 1, ..NONE };
    /// A comparison with -32767; a sum and a count on the first visit.
    pub const VISIT: Operations = Operations { cells: 1, others: 4, ..NONE };
    pub const RECORD_WRITTEN: Operations = Operations { bytes: RECORD, ..NONE };
    /// DMS2XYZ, and a line of three numbers written.
    pub const PLACE: Operations = Operations {
        numbers: 3,
        multiplications: 10,
        divisions: 6,
        roots: 1,
        trigs: 7,
        cells: 1,
        others: 30,
        ..NONE
    };
    /// PROJECT and XY2IJ, after a line of three numbers: nine products with the axes, two with the focal length, six of the affine.
    pub const REFERENCE: Operations =
        Operations { numbers: 3, multiplications: 17, divisions: 4, trigs: 12, cells: 2, others: 30, ..NONE };
    /// A grey added and counted.
    pub const PIXEL_AVERAGED: Operations = Operations { cells: 1, others: 5, ..NONE };
    /// A mean, and the record with posts and grey.
    pub const PANEL_RECORDED: Operations =
        Operations { bytes: RECORD, multiplications: 1, divisions: 2, cells: 4, others: 20, ..NONE };
    pub const AFFINE: Operations = Operations { divisions: 2, others: 10, ..NONE };
    /// The same projection without its angles; the line is read twice, once for the axes.
    pub const PROJECTION: Operations =
        Operations { numbers: 6, multiplications: 17, divisions: 4, cells: 2, others: 30, ..NONE };
    /// A line of three numbers, three squares, a root.
    pub const DISTANCE: Operations =
        Operations { numbers: 3, multiplications: 3, roots: 1, cells: 1, others: 15, ..NONE };
    pub const CELL_CLEARED: Operations = Operations { cells: 1, others: 2, ..NONE };
    /// Its record read, nine cofactors, a determinant, three coefficients, the box.
    pub const PANEL: Operations =
        Operations { bytes: RECORD, multiplications: 21, divisions: 3, cells: 9, others: 60, ..NONE };
    /// A cell of a box: cleared, and later looked at.
    pub const CELL_BOXED: Operations = Operations { cells: 2, others: 5, ..NONE };
    /// A mark; then the depth there, held against the buffer.
    pub const CELL_MARKED: Operations =
        Operations { multiplications: 2, divisions: 1, cells: 3, others: 8, ..NONE };
    /// Depth and grey of a pixel stored.
    pub const PIXEL_WRITTEN: Operations = Operations { cells: 2, others: 2, ..NONE };
}

/// Time (ns) of a record that is written.
pub(super) fn record_time(hardware: &Hardware) -> u64 {
    piece::RECORD_WRITTEN.time(hardware)
}

/// The tasks of `work` that had something to do, in the order of the listing, timed in ticks of a nanosecond. A routine with several kinds of
/// pieces has a task a kind, whose name begins with the routine's.
pub fn tasks(work: &Work, hardware: &Hardware) -> Vec<Task> {
    let FillPieces { cells, panels, written, pixels, records } = work.fill;
    let WrittenFill { buckets, boxed, marked } = written;
    [
        ("ter-crop", work.numbers, piece::NUMBER),
        ("read-image", work.bytes, piece::BYTE),
        ("ter-intrp", work.visits, piece::VISIT),
        ("real-el", work.rows, piece::RECORD_WRITTEN),
        ("ter-dms", work.placed, piece::PLACE),
        ("im-refij", work.referenced, piece::REFERENCE),
        ("im-refavg.pixels", work.averaged, piece::PIXEL_AVERAGED),
        ("im-refavg.records", work.panels, piece::PANEL_RECORDED),
        ("affin", work.affine, piece::AFFINE),
        ("new-ij", work.projected, piece::PROJECTION),
        ("node-depth", work.measured, piece::DISTANCE),
        ("fill.cells", cells, piece::CELL_CLEARED),
        ("fill.panels", panels, piece::PANEL),
        ("fill.buckets", buckets, piece::CELL_CLEARED),
        ("fill.boxed", boxed, piece::CELL_BOXED),
        ("fill.marked", marked, piece::CELL_MARKED),
        ("fill.pixels", pixels, piece::PIXEL_WRITTEN),
        ("fill.records", records, piece::RECORD_WRITTEN),
    ]
    .into_iter()
    .filter(|(_, pieces, _)| *pieces > 0)
    .map(|(task, pieces, each)| Task {
        unit: COMPUTER.into(),
        task: task.into(),
        pieces,
        ticks: pieces * each.time(hardware),
    })
    .collect()
}
