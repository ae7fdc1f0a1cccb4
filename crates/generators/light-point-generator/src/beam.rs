//! The list of calligraphic points that leaves the machine, and the spots that a second beam makes of it.

use generator::BeamEntry;
use light_points::{Disc, Share, Spot, add_up};
use quantities::intensity;

use crate::placing::Point;
use crate::table::PointTable;

/// The list of a frame, near to far, from what all its sweeps say; what nobody sees is not sent.
pub fn beam_entries(table: &PointTable, shares: Vec<(u32, u32, Share)>) -> Vec<BeamEntry> {
    let sums = add_up(shares, table.points().len());
    let entry = |(point, share): (&Point, Share)| {
        let display_intensity = share.display(point.disc.intensity).filter(|seen| *seen > 0.0)?;
        point.is_calligraphic.then_some(BeamEntry {
            light: point.light,
            place_px: point.middle,
            colour: point.colour,
            diameter_px: point.disc.diameter,
            intensity: point.disc.intensity,
            aperture: share.aperture,
            attenuation: share.attenuation,
            display_intensity,
            is_drawn: true,
        })
    };
    table.points().iter().zip(sums).filter_map(entry).collect()
}

/// Adds the spots of a list to a grey picture of `size` (columns, lines; row by row): the luminance of each.
pub fn draw_beam(entries: &[BeamEntry], size: [u32; 2], pixels: &mut [f32]) {
    let Ok(spot) = Spot::new(Spot::DEFAULT_SIGMA) else { return };
    for entry in entries {
        let disc = Disc { diameter: entry.diameter_px, intensity: entry.display_intensity };
        let light = disc.light() * intensity(entry.colour);
        spot.draw(entry.place_px, light, size, |[x, y], part| {
            pixels[(y * size[0] + x) as usize] += part as f32;
        });
    }
}
