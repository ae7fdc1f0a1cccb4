//! The overload map: where a frame lost something to the limits of memory and time.

use generator::Loss;
use raster::Screen;
use scene_sampler::{SIDE, area_of};

use crate::drawn::Drawn;
use crate::store::Gathered;

/// Fills the plane with the losses of each pixel. Lists and lateness are of whole sub-areas, whose readings `drawn` must have; stacks
/// are of pixels; a lost light marks the pixel of its middle.
pub fn fill(plane: &mut [f32], drawn: &Drawn, gathered: &Gathered, screen: &Screen, late: &[bool]) {
    let Drawn { picture, lost } = drawn;
    let [width, height] = screen.size().map(|pixels| pixels as usize);
    let mut areas: Vec<u8> = late.iter().map(|is_late| u8::from(*is_late) * Loss::Late.bit()).collect();
    lost.iter().for_each(|lost| areas[lost.sub_area as usize] |= Loss::List.bit());
    let mut bits: Vec<u8> = (0..plane.len())
        .map(|at| {
            let area = area_of(at, width);
            let pixel = SIDE * (at / width % SIDE) + at % width % SIDE;
            let is_full = picture.readings[area].lost_in >> pixel & 1 == 1;
            areas[area] | (u8::from(is_full) * Loss::Stack.bit())
        })
        .collect();
    let of_store = gathered.lost_points.iter().map(|point| point.middle);
    let of_beam = picture.beam.dropped.iter().map(|point| point.place);
    for [x, y] in of_store.chain(of_beam) {
        if (0.0..width as f64).contains(&x) && (0.0..height as f64).contains(&y) {
            bits[y as usize * width + x as usize] |= Loss::Light.bit();
        }
    }
    plane.iter_mut().zip(bits).for_each(|(value, bits)| *value = f32::from(bits));
}

#[cfg(test)]
mod tests {
    use generator::{Generator, Loss, PlaneKind, Planes};
    use light_points::BeamBudget;
    use signal::Probe;

    use crate::{Hardware, Memory, Parameters, Sampled, scenes};

    /// Bits of the 16 x 16 pixels of the pane and two stars.
    fn bits(update: u64, change: impl Fn(Sampled) -> Sampled) -> Vec<u8> {
        let (generator, rate) = scenes::slow(update);
        let stage = scenes::stage(scenes::pane_and_stars(), rate);
        let session = change(generator).prepare(stage).unwrap();
        let mut planes = Planes::new(16, 16, &[PlaneKind::Overload]);
        session.frame(0, &scenes::pose(), &mut planes, &mut Probe::off()).unwrap();
        planes.get(PlaneKind::Overload).unwrap().iter().map(|bits| *bits as u8).collect()
    }

    /// Whether exactly the pixels for which `is_lost` says so have the bit of `loss`, and no other bit is there.
    fn assert_lost(bits: &[u8], loss: Loss, is_lost: impl Fn([usize; 2]) -> bool) {
        for (at, bits) in bits.iter().enumerate() {
            let place = [at % 16, at / 16];
            assert_eq!(*bits, u8::from(is_lost(place)) * loss.bit(), "{place:?}");
        }
    }

    #[test]
    fn a_frame_in_time_with_room_loses_nothing() {
        assert!(bits(10, |generator| generator).iter().all(|bits| *bits == 0));
    }

    #[test]
    fn lists_are_full_by_sub_area_and_stacks_by_pixel() {
        let memory = Memory { list_depth: Some(1), ..Memory::default() };
        let short = bits(10, |generator| Sampled {
            hardware: Hardware { memory, ..generator.hardware },
            ..generator
        });
        assert_lost(&short, Loss::List, |[x, _]| x < 8);
        let shallow = bits(10, |generator| Sampled {
            parameters: Parameters {
                sampling: scene_sampler::Parameters { translucent: Some(0), ..generator.parameters.sampling },
                ..generator.parameters
            },
            ..generator
        });
        assert_lost(&shallow, Loss::Stack, |[x, _]| x < 8);
    }

    /// With 4 ticks a frame every sub-area comes after its line.
    #[test]
    fn late_sub_areas_are_marked_under_every_policy() {
        assert_lost(&bits(250, |generator| generator), Loss::Late, |_| true);
    }

    #[test]
    fn a_point_that_the_store_or_the_beam_leaves_out_marks_its_pixel() {
        let memory = Memory { points: Some(1), ..Memory::default() };
        let of_store = bits(10, |generator| Sampled {
            hardware: Hardware { memory, ..generator.hardware },
            ..generator
        });
        let beam = BeamBudget { jump_ns: 200_000_000, dwell_ns: 0 };
        let of_beam =
            bits(10, |generator| Sampled { hardware: Hardware { beam, ..generator.hardware }, ..generator });
        // The fainter star is that of the beam; both are lost at its place.
        assert_eq!(of_store, of_beam);
        assert_eq!(of_beam.iter().filter(|bits| **bits == Loss::Light.bit()).count(), 1);
        assert_lost(&of_beam, Loss::Light, |[x, y]| of_beam[16 * y + x] != 0 && x >= 8 && y >= 8);
    }
}
