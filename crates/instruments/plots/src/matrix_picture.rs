//! A matrix of outcomes: cases below one another, methods side by side, each cell in the colour of what came of it.

use crate::canvas::{Anchor, Area, Canvas};
use crate::colour::{Colour, INK, LATE, PAPER, SOFT};
use crate::frame::{Header, TEXT};
use crate::lettering::{self, Size};
use crate::{Drawing, PlotError};

/// Lettering of cases and cells.
const FINE: Size = 11.0;
/// From one case to the next, and height of the name of a group (pixels).
const PITCH: f32 = 16.0;
const NAME: f32 = 22.0;
/// Width of a cell with the gap beside it.
const CELL: f32 = 52.0;
/// Room around the matrix, between its columns, and between a case and its cells.
const MARGIN: f32 = 24.0;
const ASIDE: f32 = 8.0;
/// Columns in which blocks stand.
const COLUMNS: usize = 2;

/// What came of a case.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Tone {
    /// As it should be.
    Holds,
    /// As it should be, cut into pieces.
    Split,
    /// As it should be, but for what was clamped and counted.
    Clamped,
    /// Refused, as it should be.
    Refused,
    /// Less right than it should be, of a method that is there for comparison.
    Worse,
    /// Without bounds, of such a method.
    Breaks,
    /// Not as it should be.
    Fault,
}

impl Tone {
    fn colours(self) -> [Colour; 2] {
        match self {
            Self::Holds => [[203, 230, 214], INK],
            Self::Split => [[190, 214, 238], INK],
            Self::Clamped => [[250, 229, 153], INK],
            Self::Refused => [[218, 218, 218], INK],
            Self::Worse => [[251, 234, 224], INK],
            Self::Breaks => [[240, 170, 140], INK],
            Self::Fault => [LATE, PAPER],
        }
    }
}

/// What came of a case by a method.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MatrixCell {
    /// Tone that colours the cell.
    pub tone: Tone,
    /// What stands in it: a few signs.
    pub text: String,
}

/// Row of a case, with a cell for each method.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MatrixRow<'a> {
    /// Cases of one group have its name above them.
    pub group: &'a str,
    /// Name of the case.
    pub case: &'a str,
    /// A cell for each method of the block; `None` if it was not tried.
    pub cells: Vec<Option<MatrixCell>>,
}

/// Cases that the same methods were tried on.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MatrixBlock<'a> {
    /// Methods; the second says whether it is there for comparison only.
    pub methods: Vec<(&'a str, bool)>,
    /// Cases, group by group.
    pub rows: Vec<MatrixRow<'a>>,
}

impl MatrixBlock<'_> {
    /// Room for the names of the methods, which run upwards.
    fn head(&self) -> f32 {
        self.methods.iter().map(|(name, _)| lettering::width(name, FINE)).fold(0.0, f32::max) + ASIDE
    }

    fn height(&self) -> f32 {
        let groups = self.rows.chunk_by(|a, b| a.group == b.group).count();
        self.head() + self.rows.len() as f32 * PITCH + groups as f32 * NAME + MARGIN
    }

    fn label_width(&self) -> f32 {
        let names = self.rows.iter().map(|row| lettering::width(row.case, FINE));
        names.fold(0.0, f32::max) + ASIDE
    }
}

/// `blocks` in two columns below a legend of what each colour means.
///
/// # Errors
/// If there is no block, or a case has not as many cells as its block has methods.
pub fn matrix_picture(
    title: &str,
    facts: &[String],
    legend: &[(Tone, &str)],
    blocks: &[MatrixBlock<'_>],
) -> Result<Drawing, PlotError> {
    if blocks.is_empty() {
        return Err(PlotError::Empty { what: title.to_owned() });
    }
    blocks.iter().try_for_each(check_cells)?;
    let columns = halves(blocks);
    let widths: Vec<f32> = columns.iter().map(|column| column_width(column)).collect();
    let width = widths.iter().sum::<f32>() + MARGIN * (widths.len() - 1) as f32;
    let tall = |column: &&[MatrixBlock<'_>]| column.iter().map(MatrixBlock::height).sum::<f32>();
    let height = columns.iter().map(tall).fold(0.0, f32::max);
    let header = Header::new(title, facts, width);
    let entries = legend_rows(legend, width);
    let top = header.height() + entries.len() as f32 * NAME + ASIDE;
    let mut canvas = Canvas::new((width + 2.0 * MARGIN) as u32, (top + height) as u32);
    header.draw(&mut canvas, MARGIN);
    draw_legend(&mut canvas, &entries, (MARGIN, header.height()));
    let mut left = MARGIN;
    for (column, width) in columns.iter().zip(widths) {
        let mut at = (left, top);
        for block in *column {
            draw_block(&mut canvas, block, at, width);
            at.1 += block.height();
        }
        left += width + MARGIN;
    }
    Ok(canvas.finish())
}

fn check_cells(block: &MatrixBlock<'_>) -> Result<(), PlotError> {
    let expected = block.methods.len();
    match block.rows.iter().find(|row| row.cells.len() != expected) {
        Some(row) => Err(PlotError::Count { what: row.case.to_owned(), found: row.cells.len(), expected }),
        None => Ok(()),
    }
}

/// Blocks in their order, cut where the taller column is lowest.
fn halves<'a, 'b>(blocks: &'a [MatrixBlock<'b>]) -> Vec<&'a [MatrixBlock<'b>]> {
    let tall = |blocks: &[MatrixBlock<'_>]| blocks.iter().map(MatrixBlock::height).sum::<f32>();
    let taller = |cut: &usize| tall(&blocks[..*cut]).max(tall(&blocks[*cut..]));
    let cut = (0..=blocks.len()).min_by(|a, b| taller(a).total_cmp(&taller(b))).unwrap_or(0);
    let halves: [_; COLUMNS] = [&blocks[..cut], &blocks[cut..]];
    halves.into_iter().filter(|half| !half.is_empty()).collect()
}

fn column_width(column: &[MatrixBlock<'_>]) -> f32 {
    let label = column.iter().map(MatrixBlock::label_width).fold(0.0, f32::max);
    let methods = column.iter().map(|block| block.methods.len()).max().unwrap_or(0);
    label + methods as f32 * CELL
}

/// Cells stand at the right edge of the column, so that they line up from block to block.
fn draw_block(canvas: &mut Canvas, block: &MatrixBlock<'_>, (left, top): (f32, f32), width: f32) {
    let first = left + width - block.methods.len() as f32 * CELL;
    let mut y = top + block.head();
    for (index, (name, is_comparison)) in block.methods.iter().enumerate() {
        let at = (first + (index as f32 + 0.5) * CELL + 3.0, y - lettering::width(name, FINE) / 2.0);
        canvas.text_upwards(name, at, FINE, if *is_comparison { SOFT } else { INK });
    }
    for group in block.rows.chunk_by(|a, b| a.group == b.group) {
        canvas.text(group[0].group, (left, y + NAME - 7.0), Anchor::Left, TEXT, INK);
        y += NAME;
        for row in group {
            canvas.text(row.case, (left, y + PITCH - 4.5), Anchor::Left, FINE, SOFT);
            for (index, cell) in row.cells.iter().enumerate() {
                if let Some(cell) = cell {
                    draw_cell(canvas, cell, (first + index as f32 * CELL, y));
                }
            }
            y += PITCH;
        }
    }
}

fn draw_cell(canvas: &mut Canvas, cell: &MatrixCell, (left, top): (f32, f32)) {
    let [ground, ink] = cell.tone.colours();
    canvas.fill(Area { left: left + 1.0, top, width: CELL - 1.0, height: PITCH - 1.0 }, ground);
    canvas.text(&cell.text, (left + CELL / 2.0, top + PITCH - 4.5), Anchor::Middle, FINE, ink);
}

/// Entries in rows of at most `width` pixels, each with its place in the row.
fn legend_rows<'a>(legend: &[(Tone, &'a str)], width: f32) -> Vec<Vec<(f32, Tone, &'a str)>> {
    let mut rows = vec![vec![]];
    let mut left = 0.0;
    for &(tone, name) in legend {
        let wide = lettering::width(name, FINE) + PITCH + ASIDE + MARGIN;
        if left + wide > width && left > 0.0 {
            rows.push(vec![]);
            left = 0.0;
        }
        if let Some(row) = rows.last_mut() {
            row.push((left, tone, name));
        }
        left += wide;
    }
    rows
}

fn draw_legend(canvas: &mut Canvas, rows: &[Vec<(f32, Tone, &str)>], (left, top): (f32, f32)) {
    for (number, row) in rows.iter().enumerate() {
        let top = top + number as f32 * NAME;
        for &(aside, tone, name) in row {
            let area = Area { left: left + aside, top, width: PITCH, height: PITCH - 1.0 };
            canvas.fill(area, tone.colours()[0]);
            canvas.text(name, (area.right() + ASIDE, top + PITCH - 4.5), Anchor::Left, FINE, INK);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{CELL, MatrixBlock, MatrixCell, MatrixRow, PITCH, Tone, matrix_picture};
    use crate::PlotError;

    fn block<'a>(methods: &[(&'a str, bool)], cases: &[(&'a str, &[Tone])]) -> MatrixBlock<'a> {
        let cell = |tone: &Tone| Some(MatrixCell { tone: *tone, text: "1e-9".into() });
        let row = |(case, tones): &(&'a str, &[Tone])| MatrixRow {
            group: "lags",
            case,
            cells: tones.iter().map(cell).collect(),
        };
        MatrixBlock { methods: methods.to_vec(), rows: cases.iter().map(row).collect() }
    }

    const LEGEND: [(Tone, &str); 2] = [(Tone::Holds, "holds"), (Tone::Fault, "does not hold")];

    /// Fills of the size of a cell in the colour of a tone.
    fn cells(svg: &str, tone: Tone) -> usize {
        let [r, g, b] = tone.colours()[0];
        let colour = format!("#{r:02x}{g:02x}{b:02x}");
        let is_cell = |line: &&str| {
            let sides = line.split_once("d=\"M").and_then(|(_, path)| {
                let (left, path) = path.split_once(' ')?;
                let (top, path) = path.split_once('H')?;
                let (right, path) = path.split_once('V')?;
                let (bottom, _) = path.split_once('H')?;
                let side = |a: &str, b: &str| Some(b.parse::<f32>().ok()? - a.parse::<f32>().ok()?);
                Some([side(left, right)?, side(top, bottom)?])
            });
            let is_size = |[width, height]: [f32; 2]| {
                (width - CELL + 1.0).abs() < 0.02 && (height - PITCH + 1.0).abs() < 0.02
            };
            line.contains(&colour) && sides.is_some_and(is_size)
        };
        svg.lines().filter(is_cell).count()
    }

    #[test]
    fn every_cell_has_the_colour_of_what_came_of_it() {
        use Tone::{Breaks, Clamped, Fault, Holds, Refused, Split, Worse};
        let first = block(
            &[("parts", false), ("Euler", true)],
            &[("slow", &[Holds, Breaks]), ("fast", &[Split, Worse]), ("none", &[Fault, Holds])],
        );
        let second = block(&[("parts", false)], &[("clipped", &[Clamped]), ("no number", &[Refused])]);
        let drawing = matrix_picture("Stability", &[], &LEGEND, &[first, second]).unwrap();
        let svg = drawing.svg();
        let counts = [Holds, Split, Clamped, Refused, Worse, Breaks, Fault].map(|tone| cells(&svg, tone));
        assert_eq!(counts, [2, 1, 1, 1, 1, 1, 1]);
        for text in ["parts", "Euler", "lags", "slow", "no number", "does not hold", "1e-9"] {
            assert!(svg.contains(&format!("aria-label=\"{text}\"")), "{text}");
        }
        assert!(drawing.png().starts_with(b"\x89PNG"));
    }

    #[test]
    fn what_does_not_go_together_is_refused() {
        let short = block(&[("a", false), ("b", false)], &[("slow", &[Tone::Holds])]);
        let refused = matrix_picture("Stability", &[], &LEGEND, &[short]);
        assert!(matches!(refused, Err(PlotError::Count { found: 1, expected: 2, .. })), "{refused:?}");
        assert!(matrix_picture("Stability", &[], &LEGEND, &[]).is_err());
    }
}
