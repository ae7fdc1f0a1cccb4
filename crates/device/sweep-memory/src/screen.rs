//! From the raster to the screen: the way of the read beam, the other way round.

use quantities::sin_cos;

use crate::read_out::cell_of;
use crate::{Memory, Reading};

impl Reading {
    /// Where the write beam puts a place (X, Y) of the upright view-plane: sweep, a whole number on each, and line position, from
    /// the top of the raster.
    pub fn written(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let sweep = self.view.fan.position(x * self.view.tangent_over_x()(y));
        [sweep, cell_of(y, self.view.raster.tan_half_height, self.cells) + 0.5]
    }

    /// Where the picture shows a place of the raster, sweep and line position as [`written`](Self::written) has them: pixels, from
    /// its top left corner. Along a sweep this is a straight line.
    pub fn shown(&self, [sweep, line]: [f64; 2]) -> [f64; 2] {
        let view = &self.view;
        let share = |place: f64, count: f64| 2.0 * place / count - 1.0;
        let y = view.raster.tan_half_height * share(line, self.cells as f64);
        let across = share(sweep + 0.5, f64::from(view.fan.sweeps));
        let x = match self.memory {
            Memory::ScanConverter => view.fan.edge * across / view.tangent_over_x()(y),
            Memory::Digital | Memory::DigitalTurned => view.raster.tan_half_width * across,
        };
        let (sin, cos) = sin_cos(view.yoke);
        let [x, y] = [cos * x + sin * y, cos * y - sin * x];
        let pixel = |place: f64, edge: f64, count: usize| 0.5 * (place / edge + 1.0) * count as f64;
        [pixel(x, view.field.tan_half_width, self.columns), pixel(y, view.field.tan_half_height, self.lines)]
    }

    /// Which place of the raster the picture shows at a place of its own: the other way round than [`shown`](Self::shown).
    pub fn seen(&self, pixel: [f64; 2]) -> [f64; 2] {
        let is_tube = self.memory == Memory::ScanConverter;
        let [sweep, cell] = self.view.source_at([self.columns, self.lines], self.cells, pixel, is_tube);
        [sweep, cell + 0.5]
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::{prop_assert, proptest};
    use quantities::sin_cos;
    use scenario::{FieldOfView, Projection};
    use sweep_program::Fan;

    use crate::{Memory, Reading, View, covering};

    const FIELD: FieldOfView = FieldOfView { tan_half_width: 0.47, tan_half_height: 0.27 };

    fn reading(memory: Memory, pitch: f64, yoke: f64) -> Reading {
        let raster = if yoke == 0.0 { FIELD } else { covering(FIELD, 0.8) };
        let projection = Projection::Exact;
        let fan = Fan::covering(projection, pitch, &raster, 80).unwrap();
        let view = View { fan, projection, pitch, raster, field: FIELD, yoke };
        Reading { memory, view, cells: 70, columns: 90, lines: 50 }
    }

    fn close(one: [f64; 2], other: [f64; 2]) -> bool {
        one.iter().zip(other).all(|(one, other)| (one - other).abs() < 1e-9)
    }

    proptest! {
        /// There and back, by every memory, level and turned; and straight along a sweep.
        #[test]
        fn what_is_shown_is_what_is_seen(
            sweep in -3.0..83.0f64, line in -3.0..73.0f64, pitch in -0.3..0.3f64, yoke in -0.4..0.4f64, turned: bool,
        ) {
            let memories = [Memory::ScanConverter, if turned { Memory::DigitalTurned } else { Memory::Digital }];
            for memory in memories {
                let reading = reading(memory, pitch, if turned { yoke } else { 0.0 });
                let shown = reading.shown([sweep, line]);
                prop_assert!(close(reading.seen(shown), [sweep, line]), "{:?}", memory);
                let ends = [0.0, 70.0].map(|line| reading.shown([sweep, line]));
                let share = line / 70.0;
                let between = [0, 1].map(|axis| ends[0][axis] + share * (ends[1][axis] - ends[0][axis]));
                prop_assert!(close(shown, between), "{:?}", memory);
            }
        }

        /// A scan converter shows a place of the view-plane where a camera that rolls as the yoke turns sees it.
        #[test]
        fn a_place_is_shown_where_a_rolled_camera_sees_it(
            x in -0.4..0.4f64, y in -0.2..0.2f64, pitch in -0.3..0.3f64, yoke in -0.4..0.4f64,
        ) {
            let reading = reading(Memory::ScanConverter, pitch, yoke);
            let (sin, cos) = sin_cos(yoke);
            let upright = [cos * x - sin * y, sin * x + cos * y];
            let shown = reading.shown(reading.written(upright));
            prop_assert!(close(shown, [45.0 * (x / 0.47 + 1.0), 25.0 * (y / 0.27 + 1.0)]));
        }
    }
}
