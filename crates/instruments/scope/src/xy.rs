//! Two signals of a sweep, one over the other.

use plots::{Drawing, Place, TraceLook, Xy, xy_picture};
use signal::{Kind, Waveform};

use crate::page::{Page, find, runs_along};
use crate::{Recorded, ScopeError, ScopeWishes};

/// Width and height of the panel by itself (pixels).
const SIZE: [u32; 2] = [720, 720];

/// Draws the signal `pair[1]` over `pair[0]`, sample by sample.
///
/// # Errors
/// If one of them is no analog signal along the sweep, a place lies beyond the sweep, or the picture cannot be drawn as asked.
pub(crate) fn draw(
    recorded: &Recorded<'_>,
    page: &Page<'_>,
    pair: &[String; 2],
    wishes: &ScopeWishes,
) -> Result<Drawing, ScopeError> {
    let clock = page.scope().clock;
    wishes.expect_places(&clock)?;
    let sample = |place: Place| match place {
        Place::Range(range) => clock.ranges.partition_point(|known| *known < range),
        Place::Time(time) => (time / clock.period).round() as usize,
    };
    let last = clock.ranges.len() - 1;
    let sample = |place: Place| sample(place).min(last);
    let (from, to) = (wishes.from.map_or(0, sample), wishes.to.map_or(last, sample));
    let [across, up] = [signal(recorded, &pair[0])?, signal(recorded, &pair[1])?];
    let at = |sample: usize| [across.values[sample], up.values[sample]];
    let names = ["A", "B"].into_iter().zip(&wishes.cursors);
    let labels = [across, up].map(label);
    let xy = Xy {
        labels: [&labels[0], &labels[1]],
        points: (from..=to.max(from)).map(at).collect(),
        marks: names.map(|(name, place)| (name.to_owned(), at(sample(*place)))).collect(),
        even: across.signal.unit == up.signal.unit,
    };
    let [width, height] = [wishes.width.unwrap_or(SIZE[0]), wishes.height.unwrap_or(SIZE[1])];
    let look = TraceLook { title: recorded.title.to_owned(), facts: page.facts(), width, height };
    xy_picture(&xy, wishes.theme, &look).map_err(ScopeError::Look)
}

/// The analog signal `name` along the sweep.
fn signal<'r>(recorded: &'r Recorded<'_>, name: &str) -> Result<&'r Waveform, ScopeError> {
    let found = find(recorded, name)
        .filter(|found| found.signal.kind == Kind::Analog && runs_along(&found.signal, &recorded.scan));
    found.ok_or_else(|| {
        ScopeError::NoPair(format!("{name} is no analog signal along a {}", recorded.scan.line))
    })
}

/// What an axis shows: the signal, and its unit where it has one.
fn label(waveform: &Waveform) -> String {
    let (name, symbol) = (waveform.signal.name, waveform.signal.unit.symbol());
    if symbol == "1" { name.to_owned() } else { format!("{name} ({symbol})") }
}
