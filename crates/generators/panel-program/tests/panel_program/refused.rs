//! What the listing has no room for, and what no program can draw.

use glam::DVec3;
use panel_program::{Fill, Posts, Program, ProgramError, Restrictions, Settings};

use crate::block::{block, lie, observer, place, posts, usual};

fn settings(restrictions: Restrictions) -> Settings {
    Settings { restrictions, fill: Fill::EdgeBuffer, outside: 0.0, marks_voids: false, blends_borders: false }
}

/// So many rows and columns of flat posts from row 67 and column 162.
fn flat(rows: usize, columns: usize) -> Posts {
    let all = (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column)));
    let post = |(row, column): (usize, usize)| {
        let [north, east] = place(67.0 + row as f64, 162.0 + column as f64);
        DVec3::new(north, east, 3.0)
    };
    Posts { size: [rows, columns], places: all.map(post).collect() }
}

fn refusal(posts: &Posts, restrictions: Restrictions) -> Option<String> {
    let found = Program::new(posts, lie(), usual(), settings(restrictions));
    found.err().map(|error: ProgramError| error.to_string())
}

#[test]
fn limits_of_the_listing_are_refused_by_name() {
    let limits = Restrictions { limits: true, ..Restrictions::default() };
    assert_eq!(refusal(&flat(17, 17), limits), None, "512 panels in one frame");
    let panels = refusal(&flat(17, 18), limits).unwrap();
    assert_eq!(panels, "panels: 544; the program as listed holds 512");
    assert_eq!(refusal(&flat(17, 18), Restrictions::default()), None);
    let rows = refusal(&flat(51, 2), limits).unwrap();
    assert!(rows.contains("rows of posts: 51") && rows.contains("holds 50"), "{rows}");
    let beside = refusal(&posts(20.0, |_, _| 3.0), limits).unwrap();
    assert!(beside.contains("posts lie beside the photograph"), "{beside}");
    let program = Program::new(&block(0.0), lie(), usual(), settings(limits)).unwrap();
    let mut view = observer(1);
    view.size = [640, 480];
    let screen = program.draw(&view).unwrap_err().to_string();
    assert!(screen.contains("columns of the screen: 640"), "{screen}");
}

#[test]
fn voids_and_fills_are_refused() {
    let void = Posts { places: vec![DVec3::new(0.0, 0.0, f64::NAN); 4], size: [2, 2] };
    for restrictions in [Restrictions::default(), Restrictions::only("mean_void").unwrap()] {
        assert!(refusal(&void, restrictions).unwrap().contains("all 4 posts are void"));
    }
    let span = Settings { fill: Fill::Span, ..settings(Restrictions::as_written()) };
    let error = Program::new(&block(0.0), lie(), usual(), span).unwrap_err();
    assert_eq!(error, ProgramError::WrittenFill);
    assert!(Restrictions::only("quadrants").is_none());
}
