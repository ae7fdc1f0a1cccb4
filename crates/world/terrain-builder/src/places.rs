//! Which reliefs lie near a place, in the order in which they are added up.

use crate::height_grid::Area;
use crate::relief::Relief;

/// Most cells a side: lists stay short for many small craters, and few for large ones (chosen).
const MOST_CELLS: f64 = 256.0;

/// Lists of reliefs by square cells over an area. Lists ascend, so sums have one order whatever the cells are.
#[derive(Debug, Clone)]
pub struct Places {
    area: Area,
    cells: [usize; 2],
    lists: Vec<Vec<u32>>,
    /// For places outside the area.
    all: Vec<u32>,
}

impl Places {
    /// Lists of `reliefs` over an area (m).
    pub fn new(area: Area, reliefs: &[Relief]) -> Self {
        let cells = ((reliefs.len() as f64).sqrt().ceil() * 2.0).clamp(1.0, MOST_CELLS) as usize;
        let all = (0..reliefs.len() as u32).collect();
        let mut places = Self { area, cells: [cells; 2], lists: vec![Vec::new(); cells * cells], all };
        for (number, relief) in reliefs.iter().enumerate() {
            places.enter(number as u32, &relief.area);
        }
        places
    }

    fn enter(&mut self, number: u32, area: &Area) {
        let is_apart =
            (0..2).any(|axis| area[1][axis] < self.area[0][axis] || area[0][axis] > self.area[1][axis]);
        if is_apart {
            return;
        }
        let [low, high] = [self.cell(area[0]), self.cell(area[1])];
        for row in low[0]..=high[0] {
            for column in low[1]..=high[1] {
                self.lists[row * self.cells[1] + column].push(number);
            }
        }
    }

    /// Cell of a place; places outside go to the border.
    fn cell(&self, place: [f64; 2]) -> [usize; 2] {
        [0, 1].map(|axis| {
            let share = (place[axis] - self.area[0][axis]) / (self.area[1][axis] - self.area[0][axis]);
            ((share * self.cells[axis] as f64).max(0.0) as usize).min(self.cells[axis] - 1)
        })
    }

    /// Numbers of all reliefs that may add to the height of a place, ascending.
    pub fn near(&self, place: [f64; 2]) -> &[u32] {
        let is_in = (0..2).all(|axis| (self.area[0][axis]..=self.area[1][axis]).contains(&place[axis]));
        if !is_in {
            return &self.all;
        }
        let [row, column] = self.cell(place);
        &self.lists[row * self.cells[1] + column]
    }
}
