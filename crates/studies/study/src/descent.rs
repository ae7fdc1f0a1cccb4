//! Pictures of a descent beside the curves of its [pops](crate::pops): which frames, what they show, and where.

use std::collections::BTreeSet;

use ::report::{DescentPicture, DescentPlace, DescentShot, place_pixels};
use generator::{Generator, Label, PlaneKind, Planes, Session, Stage};
use landscape::MapFrame;
use picture::{AnyPicture, Depth, Encoder, SOFTWARE, Transfer};
use quantities::degrees;
use scenario::{Pose, View};
use scene_sampler::Camera;
use signal::Probe;
use timing::LevelChange;

use crate::StudyError;
use crate::pops::{LEAST_POP, PopCurve};

/// Most jumps of a curve that have pictures of their own: the largest ones. Chosen.
const MOST_JUMPS: usize = 12;

/// Frames that have pictures: so many, spread evenly over those of the curves, the first of which is `first`; and each of the largest jumps with
/// the frame before it.
pub fn shot_frames(curves: &[PopCurve], first: u64, pictures: usize) -> Vec<u64> {
    let frames = curves.first().map_or(0, |curve| curve.pops.len());
    let last = frames.saturating_sub(1);
    let even =
        (0..pictures.min(frames)).map(|number| number * last / pictures.min(frames).saturating_sub(1).max(1));
    let jumps = curves.iter().flat_map(|curve| {
        let mut pops: Vec<(usize, f64)> =
            curve.pops.iter().copied().enumerate().filter(|(_, pop)| *pop > LEAST_POP).collect();
        pops.sort_by(|a, b| b.1.total_cmp(&a.1).then(a.0.cmp(&b.0)));
        pops.truncate(MOST_JUMPS);
        pops.into_iter().flat_map(|(index, _)| [index.saturating_sub(1), index])
    });
    let chosen: BTreeSet<usize> = even.chain(jumps).collect();
    chosen.into_iter().map(|index| first + index as u64).collect()
}

/// A generator on a stage in several ways, one after the other.
pub struct DescentWays<'a> {
    stage: &'a Stage,
    ways: Vec<Box<dyn Session>>,
    kinds: Vec<PlaneKind>,
    encoder: Encoder,
    timed: Option<Box<dyn generator::Timed>>,
}

impl<'a> DescentWays<'a> {
    /// Makes `generators`, ways of one generator, ready for `stage`.
    ///
    /// # Errors
    /// If one cannot draw it.
    pub fn new(stage: &'a Stage, generators: &[&dyn Generator]) -> Result<Self, StudyError> {
        let ways = generators.iter().map(|generator| generator.prepare(stage.clone()));
        let is_colourful = generators.iter().any(|generator| generator.draws_colour(stage));
        let light = if is_colourful { &PlaneKind::COLOUR[..] } else { &[PlaneKind::Intensity] };
        let display = &stage.view.display;
        let transfer = Transfer::new(display.white as f32, display.gamma as f32)?;
        Ok(Self {
            stage,
            ways: ways.collect::<Result<_, _>>()?,
            kinds: light.iter().chain(&[PlaneKind::Label, PlaneKind::Distance]).copied().collect(),
            encoder: Encoder::new(transfer, Depth::Eight),
            timed: generators.last().map_or(Ok(None), |generator| generator.timed(stage.clone()))?,
        })
    }

    /// What all ways show of frame `frame` from `pose`.
    ///
    /// # Errors
    /// If one cannot draw it.
    pub fn shot(&self, frame: u64, pose: &Pose) -> Result<DescentShot, StudyError> {
        let pictures = self.ways.iter().map(|way| self.picture(&**way, frame, pose));
        let pictures = pictures.collect::<Result<_, _>>()?;
        Ok(DescentShot { frame, changes: self.changes(frame, pose)?, pictures })
    }

    /// Tiles that take another level in a frame; they are the same in all ways.
    fn changes(&self, frame: u64, pose: &Pose) -> Result<Vec<LevelChange>, StudyError> {
        match &self.timed {
            Some(timed) => Ok(timed.frame(frame, pose)?.level_changes),
            None => Ok(Vec::new()),
        }
    }

    fn picture(&self, way: &dyn Session, frame: u64, pose: &Pose) -> Result<DescentPicture, StudyError> {
        let View { columns, lines, .. } = self.stage.view;
        let raster = [columns, lines].map(|pixels| pixels as usize);
        let mut planes = Planes::new(raster[0], raster[1], &self.kinds);
        way.frame(frame, pose, &mut planes, &mut Probe::off())?;
        let picture: AnyPicture = match planes.colour() {
            Some(colour) => self.encoder.encode_colour(colour, raster[0], raster[1])?.into(),
            None => {
                let plane = planes.get(PlaneKind::Intensity).unwrap_or_default();
                self.encoder.encode(plane, raster[0], raster[1])?.into()
            }
        };
        let png = picture.encode_png(&[SOFTWARE])?;
        Ok(DescentPicture { png, places: places(&planes, &Camera::new(pose, &self.stage.view), self.map()) })
    }

    fn map(&self) -> Option<&MapFrame> {
        self.stage.landscape.bank().map()
    }
}

/// Where the pixels of the grid of a page lie, with longitude and latitude where the map has them.
fn places(planes: &Planes, camera: &Camera, map: Option<&MapFrame>) -> Vec<Option<DescentPlace>> {
    let (labels, distances) = (planes.get(PlaneKind::Label), planes.get(PlaneKind::Distance));
    let (Some(labels), Some(distances)) = (labels, distances) else { return Vec::new() };
    let ground = f32::from(Label::Terrain.code());
    let place = |[column, line]: [usize; 2]| {
        let at = line * planes.columns() + column;
        if labels[at] != ground || !distances[at].is_finite() {
            return None;
        }
        let seen = camera.shown([column, line], f64::from(distances[at]));
        let on_map = [seen.x, seen.y];
        let point = map.and_then(|map| map.point(on_map));
        let degrees = point.map(|[latitude, longitude]| [longitude, latitude].map(degrees));
        Some(DescentPlace { map: on_map, degrees })
    };
    let [columns, lines] = place_pixels([planes.columns(), planes.lines()]);
    lines.iter().flat_map(|line| columns.iter().map(move |column| [*column, *line])).map(place).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Straight from above, 100 m up: a pixel is a metre wide, the picture has north at the top.
    #[test]
    fn places_are_where_pixels_look() {
        let rate = quantities::Rate::new(10, 1).unwrap();
        let view = View {
            columns: 100,
            lines: 100,
            field: scenario::FieldOfView { tan_half_width: 0.5, tan_half_height: 0.5 },
            update: rate,
            refresh: rate,
            display: scenario::Display { white: 1.0, gamma: 1.0 },
            laws: scenario::Laws { curvature: scenario::Curvature::None, ..scenario::Laws::default() },
            ranges: [1.0, 1000.0],
            yoke: None,
            levels: None,
            shadows: None,
        };
        let attitude = landscape::Attitude { roll: 0.0, pitch: quantities::radians(-90.0), heading: 0.0 };
        let camera = Camera::new(&Pose { time: 0.0, eye: [500.0, 300.0, 100.0], attitude, yoke: 0.0 }, &view);
        let mut planes = Planes::new(100, 100, &[PlaneKind::Label, PlaneKind::Distance]);
        planes.get_mut(PlaneKind::Label).unwrap().fill(f32::from(Label::Terrain.code()));
        planes.get_mut(PlaneKind::Label).unwrap()[0] = f32::from(Label::Sky.code());
        let [columns, lines] = place_pixels([100, 100]);
        let distance = |at: usize| {
            let [x, y] = [at % 100, at / 100].map(|pixel| pixel as f64 + 0.5 - 50.0);
            (1e4 + x * x + y * y).sqrt() as f32
        };
        let plane = planes.get_mut(PlaneKind::Distance).unwrap();
        (0..100 * 100).for_each(|at| plane[at] = distance(at));
        let found = places(&planes, &camera, None);
        assert_eq!(found.len(), columns.len() * lines.len());
        for (number, place) in found.iter().enumerate() {
            let (column, line) = (columns[number % columns.len()], lines[number / columns.len()]);
            let expected = [500.0 + 50.0 - line as f64 - 0.5, 300.0 - 50.0 + column as f64 + 0.5];
            match place {
                None => assert_eq!((column, line), (0, 0), "sky"),
                Some(DescentPlace { map, degrees }) => {
                    assert!((0..2).all(|axis| (map[axis] - expected[axis]).abs() < 1e-3), "{map:?}");
                    assert!(degrees.is_none(), "the map has no place");
                }
            }
        }
    }

    #[test]
    fn pictures_are_even_and_at_the_largest_jumps() {
        let mut pops = vec![0.0; 101];
        (pops[40], pops[73], pops[0]) = (0.5, 1e-12, f64::NAN);
        let curve = |pops: Vec<f64>| PopCurve { name: "it".into(), distances: vec![1.0; 101], pops };
        let curves = [curve(vec![0.0; 101]), curve(pops)];
        assert_eq!(shot_frames(&curves, 1000, 3), [1000, 1039, 1040, 1050, 1100]);
        assert_eq!(shot_frames(&curves, 0, 1), [0, 39, 40]);
        let many = curve((0..101).map(|index| f64::from(index) / 100.0).collect());
        assert_eq!(shot_frames(&[many], 0, 0).len(), MOST_JUMPS + 1);
        assert_eq!(shot_frames(&[], 0, 5), [0; 0]);
    }
}
