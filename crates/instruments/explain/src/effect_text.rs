//! The effect of late words, for people and as a document.

use control_plane::{LateOf, LateWords};
use picture::{ChangedPixel, ChangedPixels};
use serde_json::{Value, json};

use crate::effect::{FrameEffect, LateEffect, Missed};
use crate::late::LEVELS;
use crate::text::{late_load_row, late_row};

impl LateEffect {
    /// What is said of the words, for people: the words, then each frame's changed pixels.
    pub fn text(&self) -> String {
        let LateWords { frame, sweep, of } = self.late;
        let of = match of {
            LateOf::Crossing { level: 0, crossing } => format!("crossing {crossing}"),
            LateOf::Crossing { crossing, .. } => format!("crossing {crossing} of the coarse level"),
            LateOf::Crater(number) => format!("crater {number}"),
            LateOf::Boundary(number) => format!("shadow boundary {number}"),
        };
        let mut lines = vec![format!(
            "frame {frame} ({:.3} s), sweep {sweep}, {of}: late words, and the pixels that they changed",
            self.frames[0].time_s
        )];
        match &self.missed {
            Missed::Words(words) => lines.extend(words.iter().map(late_row)),
            Missed::Load([load]) => lines.push(late_load_row(load)),
        }
        lines.extend(self.frames.iter().map(FrameEffect::text));
        lines.push(self.later.clone());
        lines.join("\n") + "\n"
    }

    /// A document of schema `lunoid.explain.late/1`. Of each frame it has every changed pixel: column, line, levels of 255 by
    /// which the lateness made it brighter or darker, and the same in linear intensity. What waited for the words is a crossing
    /// with its level, a crater or a boundary; the keys of the other two are null.
    pub fn json(&self) -> Value {
        let [level, crossing, crater, boundary] = match self.late.of {
            LateOf::Crossing { level, crossing } => {
                [json!(LEVELS[level]), json!(crossing), Value::Null, Value::Null]
            }
            LateOf::Crater(number) => [Value::Null, Value::Null, json!(number), Value::Null],
            LateOf::Boundary(number) => [Value::Null, Value::Null, Value::Null, json!(number)],
        };
        json!({
            "schema": "lunoid.explain.late/1",
            "frame": self.late.frame,
            "sweep": self.late.sweep,
            "level": level,
            "crossing": crossing,
            "crater": crater,
            "boundary": boundary,
            "words": self.missed,
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
