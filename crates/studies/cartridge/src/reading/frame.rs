//! Frames of a scenario: pixels, sums of pixels, counters, and the distance of level ground.

use serde::Deserialize;

use super::Deviation;
use crate::formula::distance::to_level_ground;
use crate::scene::scenario::{Frame, ScenarioCase};

/// A part of the picture.
#[derive(Debug, Clone, Copy, Default, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Part {
    /// First and last column, from 0 on the left; both are included. All if it is missing.
    pub columns: Option<[usize; 2]>,
    /// First and last line, from 0 at the top; both are included. All if it is missing.
    pub lines: Option<[usize; 2]>,
}

/// A plane on a part of the picture, frame by frame.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct PlaneReading {
    /// Name of the plane: `intensity`, `red`, `distance`, or another that the engine draws.
    pub plane: String,
    /// Pixels that are read.
    #[serde(default)]
    pub part: Part,
    /// What is expected of each frame that is drawn, or one number for all.
    pub values: Vec<f64>,
}

/// A number that the generator counts.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct CounterReading {
    /// Name of the counter, as the record of a run has it.
    pub counter: String,
    /// The count of each frame that is drawn, or one for all.
    pub values: Vec<f64>,
}

/// The distance of level ground, without curvature, on all pixels of a part of the picture.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct GroundDistanceReading {
    /// Pixels that are read; all of them show ground.
    #[serde(default)]
    pub part: Part,
    /// Height of the ground (m).
    pub height_m: f64,
}

impl Part {
    /// Columns and lines, if the picture has them.
    fn within(self, [columns, lines]: [usize; 2]) -> Result<[std::ops::RangeInclusive<usize>; 2], String> {
        let range =
            |what: &str, asked: Option<[usize; 2]>, count: usize| match asked.unwrap_or([0, count - 1]) {
                [first, last] if first <= last && last < count => Ok(first..=last),
                [first, last] => Err(format!(
                    "{what} {first} to {last} are not in the picture: expected two of 0 to {}, in order",
                    count - 1
                )),
            };
        Ok([range("columns", self.columns, columns)?, range("lines", self.lines, lines)?])
    }

    /// Values of the plane called `name`, line by line.
    fn of(self, name: &str, of: &ScenarioCase, frame: &Frame) -> Result<Vec<f64>, String> {
        let [columns, lines] = self.within(of.size())?;
        let known = || frame.planes.keys().copied().collect::<Vec<_>>().join(", ");
        let plane = frame.planes.get(name);
        let plane = plane.ok_or_else(|| format!("no plane `{name}` is drawn; drawn: {}", known()))?;
        let [width, _] = of.size();
        let line = |line: usize| columns.clone().map(move |column| f64::from(plane[line * width + column]));
        Ok(lines.flat_map(line).collect())
    }
}

/// The worst of all frames, each with its own value.
fn of_frames(
    values: &[f64],
    meant: &ScenarioCase,
    seen: &[Frame],
    deviation: impl Fn(&Frame, f64) -> Result<Deviation, String>,
) -> Result<Deviation, String> {
    let value = |index: usize| match values {
        [one] => *one,
        many => many[index],
    };
    if values.len() != 1 && values.len() != seen.len() {
        let one_each =
            if seen.len() > 1 { format!(", or {}, one a frame", seen.len()) } else { String::new() };
        return Err(format!("values: {} numbers: expected one for all frames{one_each}", values.len()));
    }
    let all = meant.poses.iter().zip(seen).enumerate().map(|(index, ((number, _), frame))| {
        let found = deviation(frame, value(index))?;
        Ok(Deviation { what: format!("{}, frame {number}", found.what), ..found })
    });
    let all = all.collect::<Result<Vec<Deviation>, String>>()?;
    all.into_iter().reduce(Deviation::worse).ok_or("no frame was drawn".into())
}

impl PlaneReading {
    /// The pixel that is farthest from the value.
    pub(super) fn of_pixels(&self, meant: &ScenarioCase, seen: &[Frame]) -> Result<Deviation, String> {
        of_frames(&self.values, meant, seen, |frame, value| {
            let found = self.part.of(&self.plane, meant, frame)?;
            let expected = vec![value; found.len()];
            Ok(Deviation::between(&format!("pixel of {}", self.plane), &found, &expected, 1.0))
        })
    }

    /// The sum of all pixels against the value.
    pub(super) fn of_sum(&self, meant: &ScenarioCase, seen: &[Frame]) -> Result<Deviation, String> {
        of_frames(&self.values, meant, seen, |frame, value| {
            let found = self.part.of(&self.plane, meant, frame)?;
            Ok(Deviation::of(format!("sum of {}", self.plane), found.iter().sum(), value, 1.0))
        })
    }
}

impl CounterReading {
    pub(super) fn deviation(&self, meant: &ScenarioCase, seen: &[Frame]) -> Result<Deviation, String> {
        of_frames(&self.values, meant, seen, |frame, value| {
            let known = || frame.counts.named().map(|(name, _)| name).collect::<Vec<_>>().join(", ");
            let count = frame.counts.get(&self.counter);
            let count =
                count.ok_or_else(|| format!("no counter `{}`; counted: {}", self.counter, known()))?;
            Ok(Deviation::of(&self.counter, count as f64, value, 1.0))
        })
    }
}

impl GroundDistanceReading {
    pub(super) fn deviation(&self, meant: &ScenarioCase, seen: &[Frame]) -> Result<Deviation, String> {
        let [columns, lines] = self.part.within(meant.size())?;
        let (size, tangents) = (meant.size(), meant.tangents());
        let on_screen =
            |axis: usize, pixel: usize| tangents[axis] * ((2 * pixel + 1) as f64 / size[axis] as f64 - 1.0);
        let all = meant.poses.iter().zip(seen).map(|((number, pose), frame)| {
            let line =
                |line: usize| columns.clone().map(move |column| [on_screen(0, column), on_screen(1, line)]);
            let pixels = lines.clone().flat_map(line);
            let expected: Vec<f64> = pixels.map(|at| to_level_ground(pose, self.height_m, at)).collect();
            if !expected.iter().all(|distance| distance.is_finite() && *distance > 0.0) {
                return Err("not all of the part shows ground: expected lines below the horizon, and an eye above `height_m`".into());
            }
            let found = self.part.of("distance", meant, frame)?;
            let what = format!("distance in frame {number}");
            // Relative: distances of one picture reach from metres to kilometres.
            let [found, one] = [
                found.iter().zip(&expected).map(|(found, right)| found / right).collect::<Vec<_>>(),
                vec![1.0; expected.len()],
            ];
            Ok(Deviation::between(&what, &found, &one, 1.0))
        });
        let all = all.collect::<Result<Vec<Deviation>, String>>()?;
        all.into_iter().reduce(Deviation::worse).ok_or("no frame was drawn".into())
    }
}
