//! The effect of late words, for people and as a document.

use picture::{ChangedPixel, ChangedPixels};
use serde_json::{Value, json};

use crate::effect::{FrameEffect, LateEffect};
use crate::late::LEVELS;
use crate::text::late_row;

impl LateEffect {
    /// What is said of the words, for people: the words, then each frame's changed pixels.
    pub fn text(&self) -> String {
        let level = if self.late.level == 0 { "" } else { " of the coarse level" };
        let mut lines = vec![format!(
            "frame {} ({:.3} s), sweep {}, crossing {}{level}: late words, and the pixels that they changed",
            self.late.frame, self.frames[0].time_s, self.late.sweep, self.late.crossing
        )];
        lines.extend(self.words.iter().map(late_row));
        lines.extend(self.frames.iter().map(FrameEffect::text));
        lines.push(self.later.clone());
        lines.join("\n") + "\n"
    }

    /// A document of schema `lunoid.explain.late/1`. Of each frame it has every changed pixel: column, line, levels of 255 by
    /// which the lateness made it brighter or darker, and the same in linear intensity.
    pub fn json(&self) -> Value {
        json!({
            "schema": "lunoid.explain.late/1",
            "frame": self.late.frame,
            "sweep": self.late.sweep,
            "level": LEVELS[self.late.level],
            "crossing": self.late.crossing,
            "words": self.words,
            "frames": self.frames.iter().map(FrameEffect::json).collect::<Vec<_>>(),
            "later": self.later,
        })
    }
}

impl FrameEffect {
    fn text(&self) -> String {
        let Self { frame, changed, .. } = self;
        let Some(largest) = changed.largest() else { return format!("frame {frame}: no pixel changed") };
        let ChangedPixel { column, line, levels, .. } = largest;
        format!(
            "frame {frame}: {} pixels changed, {} of them by a grey level or more; the largest by {levels:+} levels, at \
             {column},{line}\n  columns {}\n  lines {}",
            changed.pixels().len(),
            changed.seen(),
            stretches(&changed.columns()),
            stretches(&changed.lines())
        )
    }

    fn json(&self) -> Value {
        let changed = &self.changed;
        let pixel = |pixel: &ChangedPixel| json!([pixel.column, pixel.line, pixel.levels, pixel.by]);
        json!({
            "frame": self.frame,
            "time_s": self.time_s,
            "changed": changed.pixels().len(),
            "seen": changed.seen(),
            "box": bounds(changed),
            "columns": changed.columns(),
            "lines": changed.lines(),
            "largest": changed.largest().as_ref().map(pixel),
            "pixels": changed.pixels().iter().map(pixel).collect::<Vec<_>>(),
        })
    }
}

/// First and last column, first and last line with a changed pixel.
fn bounds(changed: &ChangedPixels) -> Option<[[usize; 2]; 2]> {
    let ends = |numbers: Vec<usize>| Some([*numbers.first()?, *numbers.last()?]);
    Some([ends(changed.columns())?, ends(changed.lines())?])
}

/// Rising numbers as stretches without a gap: `3, 7-9`.
fn stretches(numbers: &[usize]) -> String {
    let runs = numbers.chunk_by(|one, next| one + 1 == *next);
    let told = runs.map(|run| match run {
        [one] => one.to_string(),
        run => format!("{}-{}", run[0], run[run.len() - 1]),
    });
    told.collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::stretches;

    #[test]
    fn numbers_side_by_side_are_one_stretch() {
        assert_eq!(stretches(&[3, 7, 8, 9, 12, 13]), "3, 7-9, 12-13");
        assert_eq!(stretches(&[]), "");
    }
}
