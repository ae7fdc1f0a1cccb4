//! What stands around a panel: axes, colour bar, title and facts.

use crate::axis::{Ruler, Tick};
use crate::canvas::{Anchor, Area, Canvas};
use crate::colour::Colour;
use crate::lettering::{self, Size};

/// Title (pixels an em).
const TITLE: Size = 18.0;
/// Axis labels and facts.
pub(crate) const TEXT: Size = 13.0;
/// Size of tick labels (pixels an em).
pub(crate) const SMALL: Size = 12.0;
/// From one line of facts to the next (pixels).
const LEADING: f32 = 18.0;
/// Length of a tick (pixels).
const TICK: f32 = 5.0;
/// Pixels between labelled ticks, about.
const TICK_PITCH: f32 = 85.0;
/// Width of a colour bar (pixels).
pub(crate) const BAR: f32 = 16.0;
/// Room around a panel (pixels): tick labels and axis label.
pub(crate) const LEFT: f32 = 86.0;
/// Room below a panel for tick labels and axis label (pixels).
pub(crate) const BELOW: f32 = 58.0;
/// Room on the right for a colour bar with its labels.
pub(crate) const BAR_ROOM: f32 = 120.0;

/// A panel with a horizontal and a vertical ruler.
pub(crate) struct Frame {
    pub area: Area,
    pub x: Ruler,
    pub y: Ruler,
}

impl Frame {
    /// Pixel of a point.
    pub fn at(&self, x: f64, y: f64) -> (f32, f32) {
        let Area { left, top, width, height } = self.area;
        (left + self.x.share(x) as f32 * width, top + (1.0 - self.y.share(y)) as f32 * height)
    }

    /// Lines at the ticks, to be drawn before the content.
    pub fn grid(&self, canvas: &mut Canvas) {
        self.grid_across(canvas);
        self.grid_along(canvas);
    }

    /// Draws the level grid lines alone.
    pub fn grid_along(&self, canvas: &mut Canvas) {
        let Area { left, width, .. } = self.area;
        for tick in self.y_ticks() {
            let (_, y) = self.at(self.x.range[0], tick.value);
            canvas.fill(Area { left, top: y.floor(), width, height: 1.0 }, canvas.palette().faint);
        }
    }

    /// Draws the upright grid lines alone.
    pub fn grid_across(&self, canvas: &mut Canvas) {
        let Area { top, height, .. } = self.area;
        for tick in self.x_ticks() {
            let (x, _) = self.at(tick.value, self.y.range[0]);
            canvas.fill(Area { left: x.floor(), top, width: 1.0, height }, canvas.palette().faint);
        }
    }

    /// Border, ticks and labels; without `x_label` the horizontal axis is left to a panel below.
    pub fn axes(&self, canvas: &mut Canvas, x_label: Option<&str>, y_label: &str) {
        canvas.border(self.area, canvas.palette().soft);
        if let Some(label) = x_label {
            self.x_axis(canvas, label);
        }
        for tick in self.y_ticks() {
            let (_, y) = self.at(self.x.range[0], tick.value);
            let (right, length) = (self.area.left, tick_length(&tick));
            canvas.fill(
                Area { left: right - length, top: y.floor(), width: length, height: 1.0 },
                canvas.palette().soft,
            );
            canvas.text(
                &tick.label,
                (right - TICK - 4.0, y + 4.0),
                Anchor::Right,
                SMALL,
                canvas.palette().soft,
            );
        }
        let middle = self.area.top + self.area.height / 2.0;
        canvas.text_upwards(y_label, (self.area.left - LEFT + 18.0, middle), TEXT, canvas.palette().ink);
    }

    /// Ticks and labels below the panel.
    pub fn x_axis(&self, canvas: &mut Canvas, label: &str) {
        let bottom = self.area.bottom();
        for tick in self.x_ticks() {
            let (x, _) = self.at(tick.value, self.y.range[0]);
            canvas.fill(
                Area { left: x.floor(), top: bottom, width: 1.0, height: tick_length(&tick) },
                canvas.palette().soft,
            );
            canvas.text(&tick.label, (x, bottom + TICK + 14.0), Anchor::Middle, SMALL, canvas.palette().soft);
        }
        let middle = self.area.left + self.area.width / 2.0;
        canvas.text(label, (middle, bottom + 44.0), Anchor::Middle, TEXT, canvas.palette().ink);
    }

    fn x_ticks(&self) -> Vec<Tick> {
        within(&self.x, self.x.ticks(target(self.area.width, TICK_PITCH)))
    }

    fn y_ticks(&self) -> Vec<Tick> {
        within(&self.y, self.y.ticks(target(self.area.height, TICK_PITCH * 0.45)))
    }
}

fn target(length: f32, pitch: f32) -> usize {
    (length / pitch).clamp(1.0, 12.0) as usize
}

fn within(ruler: &Ruler, ticks: Vec<Tick>) -> Vec<Tick> {
    ticks.into_iter().filter(|tick| (0.0..=1.0).contains(&ruler.share(tick.value))).collect()
}

fn tick_length(tick: &Tick) -> f32 {
    if tick.label.is_empty() { TICK * 0.6 } else { TICK }
}

/// A colour bar to the right of `beside`, of the same height.
pub(crate) fn colour_bar(
    canvas: &mut Canvas,
    beside: Area,
    ruler: Ruler,
    label: &str,
    colour_of: impl Fn(f64) -> Colour,
) {
    let area = Area { left: (beside.right() + 18.0).floor(), width: BAR, ..beside };
    let frame = Frame { area, x: Ruler::linear([0.0, 1.0]), y: ruler };
    canvas.image(area, |_, line| colour_of(1.0 - (f64::from(line) + 0.5) / f64::from(area.height)));
    canvas.border(area, canvas.palette().soft);
    for tick in frame.y_ticks() {
        let (right, y) = frame.at(1.0, tick.value);
        canvas.fill(Area { left: right, top: y.floor(), width: TICK, height: 1.0 }, canvas.palette().soft);
        canvas.text(&tick.label, (right + TICK + 4.0, y + 4.0), Anchor::Left, SMALL, canvas.palette().soft);
    }
    let middle = area.top + area.height / 2.0;
    canvas.text_upwards(label, (beside.right() + BAR_ROOM - 8.0, middle), TEXT, canvas.palette().ink);
}

/// Title and facts, broken into lines of a given width.
pub(crate) struct Header {
    title: Vec<String>,
    facts: Vec<String>,
}

impl Header {
    pub fn new(title: &str, facts: &[String], width: f32) -> Self {
        let facts = facts.iter().flat_map(|fact| broken(fact, TEXT, width)).collect();
        Self { title: broken(title, TITLE, width), facts }
    }

    /// Pixels that it takes, with room below.
    pub fn height(&self) -> f32 {
        let title = self.title.len() as f32 * (TITLE + 7.0);
        (18.0 + title + self.facts.len() as f32 * LEADING + 14.0).floor()
    }

    pub fn draw(&self, canvas: &mut Canvas, left: f32) {
        canvas.name(&self.title.join(" "));
        let mut base = 14.0;
        for line in &self.title {
            base += TITLE + 7.0;
            canvas.text(line, (left, base), Anchor::Left, TITLE, canvas.palette().ink);
        }
        base += 4.0;
        for line in &self.facts {
            base += LEADING;
            canvas.text(line, (left, base), Anchor::Left, TEXT, canvas.palette().soft);
        }
    }
}

/// `text` in lines of at most `width` pixels, broken at spaces where it has any.
fn broken(text: &str, size: Size, width: f32) -> Vec<String> {
    let mut lines: Vec<String> = vec![];
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if lettering::width(&format!("{line} {word}"), size) <= width => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// Width and height (pixels) of a map of `extent` (m north, east), the longer side `longest`.
///
/// A strip keeps at least a sixth of the longer side, as a thinner one shows nothing.
pub(crate) fn map_size([north, east]: [f64; 2], longest: u32) -> (f32, f32) {
    let longest = f64::from(longest);
    let scale = longest / north.max(east);
    let side = |length: f64| (length * scale).clamp(longest / 6.0, longest).floor() as f32;
    (side(east), side(north))
}

/// Frame of a map in `area` over `[south, west, north, east]` (m), and the unit of its axes.
pub(crate) fn map_frame(area: Area, [south, west, north, east]: [f64; 4]) -> (Frame, &'static str) {
    let (unit, metres) = if (north - south).max(east - west) >= 4000.0 { ("km", 1000.0) } else { ("m", 1.0) };
    let ruler = |low: f64, high: f64| Ruler::linear([low / metres, high / metres]);
    (Frame { area, x: ruler(west, east), y: ruler(south, north) }, unit)
}

#[cfg(test)]
mod tests {
    use super::{broken, map_size};
    use crate::lettering;

    #[test]
    fn lines_keep_their_width() {
        let lines = broken("rms 0.12 m over 10 000 samples of the area", 13.0, 150.0);
        assert!(lines.len() > 2);
        assert!(lines.iter().all(|line| lettering::width(line, 13.0) <= 150.0));
        assert_eq!(lines.join(" "), "rms 0.12 m over 10 000 samples of the area");
    }

    #[test]
    fn maps_keep_their_shape() {
        assert_eq!(map_size([100.0, 400.0], 800), (800.0, 200.0));
        assert_eq!(map_size([1.0, 1000.0], 600), (600.0, 100.0));
    }
}
