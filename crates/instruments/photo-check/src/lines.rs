//! The elevation grid as a line drawing over the photograph, its heights magnified.

use std::fmt::Write;

use photograph::Photograph;

use crate::Ground;

/// Most lines along each axis (chosen).
const MOST_LINES: usize = 80;
/// Most points of a line (chosen).
const MOST_POINTS: usize = 400;

/// A drawing in SVG of rows and columns of `ground` in the pixels of `photo`. Heights above and below the mean are `magnify` times
/// as large. Lines through former voids are amber.
pub fn drawing(ground: &Ground, photo: &Photograph, magnify: f64) -> String {
    let [columns, lines] = [photo.picture().columns(), photo.picture().lines()];
    let known = || ground.filling.heights.iter().copied().filter(|height| !height.is_nan());
    let mean = known().sum::<f64>() / known().count().max(1) as f64;
    let pen = Pen { ground, photo, magnify, mean };
    let mut paths = [String::new(), String::new()];
    for axis in [0, 1] {
        let [across, along] = [ground.size()[axis], ground.size()[1 - axis]];
        for fixed in posts(across, MOST_LINES) {
            pen.draw(
                &mut paths,
                posts(along, MOST_POINTS).map(|at| if axis == 0 { [fixed, at] } else { [at, fixed] }),
            );
        }
    }
    let [plain, void] = paths;
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {columns} {lines}\" width=\"{columns}\" height=\"{lines}\">\n\
         <title>Elevation grid in the pixels of the photograph, heights times {magnify}</title>\n\
         <rect width=\"{columns}\" height=\"{lines}\" fill=\"#fbfaf7\"/>\n\
         <path d=\"{plain}\" fill=\"none\" stroke=\"#1d2533\" stroke-width=\"1\" vector-effect=\"non-scaling-stroke\"/>\n\
         <path d=\"{void}\" fill=\"none\" stroke=\"#c2700a\" stroke-width=\"1\" vector-effect=\"non-scaling-stroke\"/>\n\
         </svg>\n"
    )
}

/// At most `most` of `count` posts, evenly, the first and the last among them.
fn posts(count: usize, most: usize) -> impl Iterator<Item = usize> {
    let drawn = count.min(most).max(2);
    (0..drawn).map(move |at| at * (count - 1) / (drawn - 1))
}

/// What draws a line.
struct Pen<'a> {
    ground: &'a Ground,
    photo: &'a Photograph,
    magnify: f64,
    /// Mean height (m), which stays where it is.
    mean: f64,
}

impl Pen<'_> {
    /// Draws from post to post, each piece into the path of plain ground or of former voids.
    fn draw(&self, paths: &mut [String; 2], posts: impl Iterator<Item = [usize; 2]>) {
        let mut before: Option<([f64; 2], bool)> = None;
        let mut pen_at = [None, None];
        for post in posts {
            let here = self.pixel(post).map(|pixel| (pixel, self.ground.was_void(post)));
            if let (Some((from, was_void)), Some((to, is_void))) = (before, here) {
                let path = usize::from(was_void || is_void);
                piece(&mut paths[path], &mut pen_at[path], from, to);
            }
            before = here;
        }
    }

    /// Pixel of a post; none of a void, behind the camera, or more than a picture away.
    fn pixel(&self, post: [usize; 2]) -> Option<[f64; 2]> {
        let height = self.mean + self.magnify * (self.ground.height(post)? - self.mean);
        let pixel = self.photo.pixel(self.ground.point(post.map(|at| at as f64), height)?)?;
        let size = [self.photo.picture().columns(), self.photo.picture().lines()].map(|count| count as f64);
        (0..2).all(|axis| (-size[axis]..2.0 * size[axis]).contains(&pixel[axis])).then_some(pixel)
    }
}

/// Adds a straight piece; one that goes on where the last ended needs no move.
fn piece(path: &mut String, at: &mut Option<[f64; 2]>, from: [f64; 2], to: [f64; 2]) {
    if *at != Some(from) {
        write!(path, "M{:.1} {:.1}", from[0], from[1]).expect("a String takes everything");
    }
    write!(path, "L{:.1} {:.1}", to[0], to[1]).expect("a String takes everything");
    *at = Some(to);
}
