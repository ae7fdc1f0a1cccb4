//! Problems drawn by the renderer of rustc and cargo.

use std::ops::Range;

use annotate_snippets::{AnnotationKind, Group, Level, Origin, Renderer, Snippet};

use crate::place::{Place, Source};
use crate::problem::Problem;

/// All problems, one empty line between two.
pub(crate) fn render(problems: &[Problem], colour: bool) -> String {
    let renderer = if colour { Renderer::styled() } else { Renderer::plain() };
    problems.iter().map(|problem| renderer.render(&[report(problem)]) + "\n").collect::<Vec<_>>().join("\n")
}

fn report(problem: &Problem) -> Group<'_> {
    let title = Level::ERROR.primary_title(&*problem.title);
    let group = match &problem.place {
        Some(place) => title.element(snippet(place, problem.expected.as_deref())),
        None => {
            let group = title.element(Origin::path(&*problem.file));
            let expected = problem.expected.iter().map(|expected| format!("expected {expected}"));
            expected.fold(group, |group, text| group.element(Level::NOTE.message(text)))
        }
    };
    match &problem.help {
        Some(help) => group.element(Level::HELP.message(&**help)),
        None => group,
    }
}

fn snippet<'a>(place: &'a Place, expected: Option<&str>) -> Snippet<'a, annotate_snippets::Annotation<'a>> {
    let (line, span) = first_line(&place.source, &place.span);
    let label = expected.map(|expected| format!("expected {expected}"));
    Snippet::source(&place.source.text[line.clone()])
        .path(&*place.source.name)
        .line_start(place.source.line_and_column(line.start).0)
        .annotation(AnnotationKind::Primary.span(span).label(label))
}

/// The line in which the span begins, and the span cut to that line and counted from its start.
/// The renderer is given that line only: its cost then does not grow with the file.
fn first_line(source: &Source, span: &Range<usize>) -> (Range<usize>, Range<usize>) {
    let begin = source.floor_boundary(span.start);
    let start = source.text[..begin].rfind('\n').map_or(0, |newline| newline + 1);
    let end = source.text[begin..].find('\n').map_or(source.text.len(), |newline| begin + newline);
    let stop = source.floor_boundary(span.end).clamp(begin, end);
    (start..end, begin - start..stop - start)
}
