//! Which corners stand in the registers: the one rule of transfers and loads, for all who follow a sweep.

use crate::{Colour, Event, Fold, Load, PreloadRegister, RampAxis, RegisterSet, Target};

/// Corners of the nine words in each register of the four colours, as indices into the level;
/// [`NO_CORNER`](crate::NO_CORNER) for words of 0.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RegisterCorners([[[u32; 9]; 3]; 4]);

impl RegisterCorners {
    /// What a sweep begins with.
    pub fn at_start(sets: &[RegisterSet; 4]) -> Self {
        Self(sets.map(|set| [set.hold, set.x_first, set.y_first].map(|corner| [corner; 9])))
    }

    /// Registers of a colour: hold, x-first, y-first; of each the corners of its words, 3p + q.
    pub fn of(&self, colour: Colour) -> &[[u32; 9]; 3] {
        &self.0[colour as usize]
    }

    /// Corner of the first word of a preload register: single words may be of another while they come in.
    pub fn waiting(&self, colour: Colour, register: PreloadRegister) -> u32 {
        self.of(colour)[1 + register as usize][0]
    }

    /// Follows the next event of the sweep.
    pub fn follow(&mut self, event: &Event) {
        match event {
            Event::Fold(fold) => self.transfer(*fold),
            Event::BareFold(_) => {}
            Event::Load(load) => self.load(load),
        }
    }

    /// Two colours take a preload register into hold (fig. 22).
    fn transfer(&mut self, fold: Fold) {
        for colour in fold.colours() {
            let [hold, x_first, y_first] = &mut self.0[colour as usize];
            *hold = if fold.axis == RampAxis::X { *x_first } else { *y_first };
        }
    }

    fn load(&mut self, load: &Load) {
        let register = match load.target {
            Target::Hold => 0,
            Target::Preload(register) => 1 + register as usize,
        };
        let words = &mut self.0[load.colour as usize][register];
        for (_, corner) in words.iter_mut().enumerate().filter(|(word, _)| load.words.has(*word)) {
            *corner = load.corner;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::RegisterCorners;
    use crate::{Colour, Event, Fold, Load, PreloadRegister, RampAxis, RegisterSet, Stop, Target, WordMask};

    #[test]
    fn a_stop_of_x_takes_x_first_of_its_two_colours_and_a_word_comes_alone() {
        let set = RegisterSet { hold: 1, x_first: 2, y_first: 3 };
        let mut corners = RegisterCorners::at_start(&[set; 4]);
        let target = Target::Preload(PreloadRegister::XFirst);
        let words = WordMask::only(4);
        corners.follow(&Event::Load(Load { colour: Colour::Yellow, target, corner: 7, words }));
        assert_eq!(corners.waiting(Colour::Yellow, PreloadRegister::XFirst), 2);
        let fold = Fold { axis: RampAxis::X, stop: Stop::One };
        corners.follow(&Event::BareFold(fold));
        assert_eq!(corners.of(Colour::Yellow)[0], [1; 9]);
        corners.follow(&Event::Fold(fold));
        assert_eq!(corners.of(Colour::Yellow)[0], [2, 2, 2, 2, 7, 2, 2, 2, 2]);
        assert_eq!(corners.of(Colour::Black)[0], [2; 9]);
        assert_eq!(corners.of(Colour::Green)[0], [1; 9]);
    }
}
