//! The beam: which calligraphic points it draws, in which order, and their spots in the picture.

use std::collections::HashMap;

use generator::BeamEntry;
use light_points::{BeamBudget, BeamPoint, Share, Spot, add_up, nearest_neighbour};
use raster::Screen;

use crate::lights::Point;
use crate::parameters::{BeamLayer, BeamOrder, Parameters};

/// What a beam does in a field.
#[derive(Debug, Default)]
pub struct Beam {
    /// Shares of all light points of the frame, summed over sub-areas.
    shares: Vec<Share>,
    /// Points that it draws, in the order of drawing.
    pub drawn: Vec<BeamPoint>,
    /// Points for which it has no time, the faintest first.
    pub dropped: Vec<BeamPoint>,
}

impl Beam {
    /// Adds up the `shares` of sub-areas (number of the sub-area, number of the point, share) of `points`, and takes out what a field (ns) has no time for. What nobody sees is not sent.
    pub fn new(
        points: &[Point],
        shares: Vec<(u32, u32, Share)>,
        run: &Parameters,
        budget: BeamBudget,
        field_ns: u64,
    ) -> Self {
        let shares = add_up(shares, points.len());
        let lit = points.iter().zip(&shares).filter_map(|(point, share)| {
            let intensity = share.display(point.disc.intensity).filter(|_| point.is_calligraphic)?;
            (intensity > 0.0).then(|| point.of_beam(intensity * point.disc.area()))
        });
        let mut drawn: Vec<BeamPoint> = lit.collect();
        let dropped = budget.drop_faintest(&mut drawn, field_ns);
        if run.beam_order == BeamOrder::NearestNeighbour {
            nearest_neighbour(&mut drawn);
        }
        Self { shares, drawn, dropped }
    }

    /// Adds the spots to `colours`, row by row, as the layers ask for: black below them where the beam stands alone.
    pub fn draw(&self, points: &[Point], run: &Parameters, screen: &Screen, colours: &mut [[f32; 3]]) {
        match run.beam_layer {
            BeamLayer::Raster => return,
            BeamLayer::Beam => colours.fill([0.0; 3]),
            BeamLayer::Both => {}
        }
        let Ok(spot) = Spot::new(run.spot) else { return };
        let known: HashMap<u32, [f64; 3]> = points.iter().map(|point| (point.id, point.colour())).collect();
        let width = screen.size()[0] as usize;
        for beam in &self.drawn {
            let colour = known[&beam.id];
            spot.draw(beam.place, beam.light, screen.size(), |[x, y], light| {
                let pixel = &mut colours[y as usize * width + x as usize];
                let lit = |channel: usize| f64::from(pixel[channel]) + light * colour[channel];
                *pixel = [lit(0), lit(1), lit(2)].map(|value| value as f32);
            });
        }
    }

    /// The points of the beam's list: those that it draws, in their order, then those that it leaves out.
    pub fn entries(&self, points: &[Point]) -> Vec<BeamEntry> {
        let known: HashMap<u32, usize> = points.iter().zip(0..).map(|(point, at)| (point.id, at)).collect();
        let entry = |(beam, is_drawn): (&BeamPoint, bool)| {
            let at = known[&beam.id];
            let (point, share) = (&points[at], &self.shares[at]);
            BeamEntry {
                light: point.light,
                place_px: point.middle,
                colour: point.colour(),
                diameter_px: point.disc.diameter,
                intensity: point.disc.intensity,
                aperture: share.aperture,
                attenuation: share.attenuation,
                display_intensity: share.display(point.disc.intensity).unwrap_or(0.0),
                is_drawn,
            }
        };
        let drawn = self.drawn.iter().map(|beam| (beam, true));
        drawn.chain(self.dropped.iter().map(|beam| (beam, false))).map(entry).collect()
    }
}
