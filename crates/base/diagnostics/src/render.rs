//! Problems drawn by the renderer of rustc and cargo.

use std::ops::Range;

use annotate_snippets::{AnnotationKind, Group, Level, Origin, Renderer, Snippet, Title};
use text::{visible, visible_line};

use crate::place::{Cursor, Place};
use crate::problem::{Problem, positions};

/// Bytes of a line that are shown before and behind the begin of a fault. A file may be one line.
const AROUND: usize = 400;

/// All problems, one empty line between two.
pub(crate) fn render(problems: &[Problem], colour: bool) -> String {
    let renderer = if colour { Renderer::styled() } else { Renderer::plain() };
    let reports = problems.iter().zip(positions(problems)).map(|(problem, at)| report(problem, at));
    reports.map(|report| renderer.render(&[report]) + "\n").collect::<Vec<_>>().join("\n")
}

fn report<'a>(problem: &'a Problem, at: Option<Cursor<'a>>) -> Group<'a> {
    let title = Level::ERROR.primary_title(visible(&problem.title));
    let expected = problem.expected.as_deref().map(|expected| format!("expected {}", visible(expected)));
    let group = match (&problem.place, at) {
        (Some(place), Some(at)) => placed(title, place, at, expected),
        _ => {
            let group = title.element(Origin::path(visible_line(&problem.file)));
            expected.into_iter().fold(group, |group, text| group.element(Level::NOTE.message(text)))
        }
    };
    match &problem.help {
        Some(help) => group.element(Level::HELP.message(visible(help))),
        None => group,
    }
}

/// The line in which the place begins, as far as it is shown, and the place in it.
fn placed<'a>(title: Title<'a>, place: &'a Place, at: Cursor<'_>, expected: Option<String>) -> Group<'a> {
    let (line, span) = excerpt(place, at);
    let text = &place.source.text;
    let parts = [line.start..span.start, span.clone(), span.end..line.end].map(|part| visible(&text[part]));
    let start = parts[0].len();
    let annotation = AnnotationKind::Primary.span(start..start + parts[1].len()).label(expected);
    let shown = parts.concat();
    let name = visible_line(&place.source.name);
    let is_whole = line.start == at.line_start && shown == text[line];
    let snippet = Snippet::source(shown).line_start(at.line).annotation(annotation);
    if is_whole {
        return title.element(snippet.path(name));
    }
    // The renderer would count columns in what is shown.
    title.element(Origin::path(name).line(at.line).char_column(at.column)).element(snippet)
}

/// Bytes of the text that are shown, and those of them that are to blame.
fn excerpt(place: &Place, at: Cursor<'_>) -> (Range<usize>, Range<usize>) {
    let source = &place.source;
    let start = source.floor_boundary(at.at.saturating_sub(AROUND)).max(at.line_start);
    let most = source.floor_boundary(at.at + AROUND);
    let end = source.text[at.at..most].find('\n').map_or(most, |newline| at.at + newline);
    let stop = source.floor_boundary(place.span.end).clamp(at.at, end);
    (start..end, at.at..stop)
}
