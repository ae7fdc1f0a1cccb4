//! The page of a descent: ways with levels of detail side by side, their curves below, and what each jump comes from.
//!
//! **Law.** Pictures, curves and places are given; the page shows them, and works nothing out but where a click falls. A click on a jump
//! leads to its frame and to the tiles that changed there; a click on the ground tells its place, and the command that puts a crater there.
//! **Files.** `index.html` in the folder; pictures and places lie beside it, and are read when they are wanted.

use std::io::Write;
use std::path::{Path, PathBuf};

use maud::{DOCTYPE, Markup, PreEscaped, html};
use serde_json::{Value, json};
use timing::LevelChange;

use crate::ReportError;
use crate::data::in_script;
use crate::page::head_with;

const STYLE: &str = include_str!("descent.css");
const SCRIPT: &str = include_str!("descent.js");

/// Pictures and places are files beside the page.
const POLICY: &str = "default-src 'none'; img-src 'self' file: data:; style-src 'unsafe-inline'; \
                      script-src 'unsafe-inline' 'self' file:; base-uri 'none'; form-action 'none'";

/// Folder of pictures and places within that of the page.
const PICTURES: &str = "pictures";

/// Name of the page in its folder.
const PAGE: &str = "index.html";

/// Most places along a side of a picture. Chosen: a click is told within a hundredth of the picture.
const MOST_PLACES: usize = 96;

/// Curves and pictures of a descent in several ways.
#[derive(Debug, Clone, PartialEq)]
pub struct DescentPage {
    /// Title of the scenario.
    pub title: String,
    /// Who drew what, in one line.
    pub facts: String,
    /// Columns and lines of a picture.
    pub raster: [usize; 2],
    /// Number of the first frame of the curves.
    pub first: u64,
    /// Time of each frame (s).
    pub times: Vec<f64>,
    /// Ways, in the order of the columns.
    pub ways: Vec<DescentWay>,
    /// Frames that have pictures, in rising order.
    pub shots: Vec<DescentShot>,
}

/// One way to draw levels of detail.
#[derive(Debug, Clone, PartialEq)]
pub struct DescentWay {
    /// Name of the way.
    pub name: String,
    /// What it is off the finest ground (m), frame by frame; NaN where that is not known.
    pub off: Vec<f64>,
    /// Pop of each frame (m); NaN where that is not known.
    pub pops: Vec<f64>,
}

/// A frame with a picture of each way.
#[derive(Debug, Clone, PartialEq)]
pub struct DescentShot {
    /// Number of the frame.
    pub frame: u64,
    /// Tiles that take another level in it.
    pub changes: Vec<LevelChange>,
    /// What each way shows, in the order of the ways.
    pub pictures: Vec<DescentPicture>,
}

/// The picture of a way, and where its pixels lie.
#[derive(Debug, Clone, PartialEq)]
pub struct DescentPicture {
    /// The picture as a PNG file.
    pub png: Vec<u8>,
    /// Place of the pixel in the middle of each cell of the [grid](place_pixels), row by row.
    pub places: Vec<Option<DescentPlace>>,
}

/// Where a pixel of ground lies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DescentPlace {
    /// North and east on the map (m).
    pub map: [f64; 2],
    /// Longitude and latitude (degrees), where the ground has them.
    pub degrees: Option<[f64; 2]>,
}

/// Pixels whose places a page knows, for a picture of columns and lines: columns and lines of a grid, from the top left.
pub fn place_pixels([columns, lines]: [usize; 2]) -> [Vec<usize>; 2] {
    let step = columns.max(lines).div_ceil(MOST_PLACES).max(1);
    [columns, lines].map(|pixels| (step / 2..pixels).step_by(step).collect())
}

impl DescentPage {
    /// Whether a page leaves a file of this name in its folder.
    pub fn leaves(file: &str) -> bool {
        file == PAGE || file.strip_prefix(PICTURES).is_some_and(|rest| rest.starts_with('/'))
    }

    /// Leaves the page with its files in `folder`; where the page is.
    ///
    /// # Errors
    /// If a file cannot be written.
    pub fn leave(&self, folder: &Path) -> Result<PathBuf, ReportError> {
        files::make_folder(&folder.join(PICTURES))?;
        for shot in &self.shots {
            for (way, picture) in self.ways.iter().zip(&shot.pictures) {
                let [image, places] = files_of(&way.name, shot.frame);
                leave(&folder.join(image), &picture.png)?;
                leave(&folder.join(places), self.places(way, shot.frame, picture).as_bytes())?;
            }
        }
        let path = folder.join(PAGE);
        leave(&path, text::visible(&self.markup().into_string()).as_bytes())?;
        Ok(path)
    }

    /// A script that hands the places of a picture over.
    fn places(&self, way: &DescentWay, frame: u64, picture: &DescentPicture) -> String {
        let rounded = |value: f64, digits: f64| (value * digits).round() / digits;
        let number = |place: &Option<DescentPlace>| match place {
            None => Value::Null,
            Some(DescentPlace { map: [north, east], degrees }) => {
                let map = [north, east].map(|metres| rounded(*metres, 100.0));
                // A ten-millionth of a degree of the Moon is 3 mm.
                let degrees = degrees.iter().flatten().map(|degrees| rounded(*degrees, 1e7));
                map.into_iter().chain(degrees).collect::<Vec<f64>>().into()
            }
        };
        let places: Vec<Value> = picture.places.iter().map(number).collect();
        let key = Value::from(format!("{}-{frame}", way.name));
        format!("places({}, {});\n", in_script(&key), in_script(&places.into()))
    }

    fn markup(&self) -> Markup {
        let title = format!("{} – levels of detail", self.title);
        let data = in_script(&self.data());
        html! {
            (DOCTYPE)
            html lang="en" {
                (head_with(&title, STYLE, POLICY))
                body {
                    a.skip href="#pictures" { "To the pictures" }
                    header.running { span.house { "lunoid" } span { (self.facts) } }
                    main {
                        h1 { (self.title) }
                        p.abstract {
                            "The same descent with levels of detail in " (self.ways.len()) " ways. A jump of a curve is a pop: the ground moves "
                            "under a camera that stands. Click on a jump to see the tiles that made it, or on the ground to get its place."
                        }
                        p.needs-no-script { "This page needs its script: without it, the pictures lie in the folder " code { (PICTURES) } "." }
                        section #pictures.needs-script aria-label="Pictures" {
                            div.ways {
                                @for way in &self.ways {
                                    figure {
                                        div.stack {
                                            canvas width=(self.raster[0]) height=(self.raster[1]) data-way=(way.name) tabindex="0"
                                                aria-label=(format!("Picture, {}", way.name)) {}
                                        }
                                        figcaption { b { (way.name) } " " span data-told=(way.name) {} }
                                    }
                                }
                            }
                            div.controls {
                                button #before type="button" { "Before" }
                                input #shot type="range" min="0" max=(self.shots.len().saturating_sub(1)) value="0" aria-label="Picture";
                                button #after type="button" { "Next" }
                                output #now for="shot" {}
                            }
                            p #place.place aria-live="polite" { "Click on the ground for its place." }
                        }
                        section.needs-script aria-label="Curves" {
                            h2 { "Off the finest ground, and pops" }
                            canvas #curves width="1200" height="420" tabindex="0" aria-label="Curves of all ways over the frames; arrow keys go from picture to picture" {}
                            p #legend.legend {}
                        }
                        section.needs-script aria-label="Jumps" {
                            h2 { "Jumps" }
                            p #no-jumps hidden { "No way has a pop in these frames." }
                            ol #jumps.jumps {}
                            h2 { "Tiles that take another level" }
                            p #changed {}
                        }
                    }
                    script #data type="application/json" { (PreEscaped(data)) }
                    script { (PreEscaped(SCRIPT)) }
                }
            }
        }
    }

    fn data(&self) -> Value {
        let number = |value: &f64| if value.is_finite() { Value::from(*value) } else { Value::Null };
        let curve = |values: &[f64]| values.iter().map(number).collect::<Vec<_>>();
        let ways = self
            .ways
            .iter()
            .map(|way| json!({ "name": way.name, "off": curve(&way.off), "pops": curve(&way.pops) }));
        let shots = self.shots.iter().map(|shot| {
            let files: Vec<[String; 2]> =
                self.ways.iter().map(|way| files_of(&way.name, shot.frame)).collect();
            json!({ "frame": shot.frame, "changes": shot.changes, "files": files })
        });
        let [columns, lines] = place_pixels(self.raster);
        json!({
            "first": self.first,
            "times": self.times,
            "raster": self.raster,
            "columns": columns,
            "lines": lines,
            "ways": ways.collect::<Vec<_>>(),
            "shots": shots.collect::<Vec<_>>(),
        })
    }
}

/// Picture and places of a way in a frame, within the folder of the page.
fn files_of(way: &str, frame: u64) -> [String; 2] {
    ["png", "js"].map(|end| format!("{PICTURES}/{way}-{frame:06}.{end}"))
}

fn leave(path: &Path, bytes: &[u8]) -> Result<(), ReportError> {
    if !files::holds(path, bytes) {
        files::write_atomic(path, |out: &mut dyn Write| out.write_all(bytes))?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn page() -> DescentPage {
        let change = LevelChange {
            tile: "tile.3.7".into(),
            from: 1,
            to: 0,
            distance_m: 445.0,
            fraction: 0.97,
            borders_m: [0.0, 0.0, 80.0, 80.0],
        };
        let place = DescentPlace { map: [12.345_6, 78.9], degrees: Some([3.633_86, 26.132_22]) };
        let picture = DescentPicture { png: vec![1, 2, 3], places: vec![None, Some(place)] };
        let way = |name: &str, pop: f64| DescentWay {
            name: name.into(),
            off: vec![0.5, f64::NAN],
            pops: vec![0.0, pop],
        };
        DescentPage {
            title: "Down </script>".into(),
            facts: "lod-mesh".into(),
            raster: [200, 100],
            first: 7,
            times: vec![0.0, 0.1],
            ways: vec![way("switching", 0.6), way("morphing", 0.0)],
            shots: vec![DescentShot {
                frame: 8,
                changes: vec![change],
                pictures: vec![picture.clone(), picture],
            }],
        }
    }

    #[test]
    fn a_page_stands_beside_its_pictures_and_places() {
        let folder = tempfile::tempdir().unwrap();
        let path = page().leave(folder.path()).unwrap();
        let text = std::fs::read_to_string(&path).unwrap();
        let of =
            |start: &str, end: &str| text.split_once(start).unwrap().1.split_once(end).unwrap().0.to_owned();
        let data: Value = serde_json::from_str(&of("type=\"application/json\">", "</script>")).unwrap();
        assert_eq!(data["ways"][0]["pops"], json!([0.0, 0.6]));
        assert_eq!(data["ways"][0]["off"], json!([0.5, null]), "what is not known is not there");
        assert_eq!(data["shots"][0]["changes"][0]["tile"], "tile.3.7");
        for (way, file) in [("switching", 0), ("morphing", 1)] {
            let files = &data["shots"][0]["files"][file];
            let read = |at: usize| std::fs::read(folder.path().join(files[at].as_str().unwrap())).unwrap();
            assert_eq!(read(0), [1, 2, 3]);
            let places = String::from_utf8(read(1)).unwrap();
            assert_eq!(places, format!("places(\"{way}-8\", [null,[12.35,78.9,3.63386,26.13222]]);\n"));
        }
    }

    #[test]
    fn the_grid_lies_within_the_picture() {
        assert_eq!(place_pixels([3, 2]), [vec![0, 1, 2], vec![0, 1]]);
        let [columns, lines] = place_pixels([700, 350]);
        assert!(columns.len() <= 96 && columns[0] == 4 && *columns.last().unwrap() < 700);
        assert!(lines.len() <= 96 && *lines.last().unwrap() < 350);
    }
}
