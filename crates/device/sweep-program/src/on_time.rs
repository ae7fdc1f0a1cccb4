//! Late words on time: the program that a sweep would have run if one fold had found all its words.

use crate::{Colour, Event, Load, Miss, Step, StepKind, SweepProgram, Target};

impl SweepProgram {
    /// Words that fold `crossing` found missing when it transferred its registers; none if all were there. A fold that
    /// transfers nothing, because the loader is off, waits for no words.
    pub fn late_words(&self, crossing: u32) -> Vec<Miss> {
        let missed = self.misses.iter().copied().filter(|miss| miss.crossing == crossing);
        self.transfer(crossing).map_or_else(Vec::new, |_| missed.collect())
    }

    /// Folds that found words missing, counted from 0 in the sweep, in their order.
    pub fn late_crossings(&self) -> Vec<u32> {
        let mut found: Vec<u32> = self.misses.iter().map(|miss| miss.crossing).collect();
        found.sort_unstable();
        found.dedup();
        found.retain(|crossing| !self.late_words(*crossing).is_empty());
        found
    }

    /// Brings the words that fold `crossing` found missing into their registers right before that fold. Nothing else
    /// changes: not what other folds find, and not when other words come. Words that came late are the very words that are
    /// on time now; words that never came are those of the corner that was asked for.
    pub fn bring_on_time(&mut self, crossing: u32) {
        let Some(fold) = self.transfer(crossing) else { return };
        let mut on_time = Vec::new();
        for miss in self.late_words(crossing) {
            let came = self.take_late(fold, miss.colour);
            let missing = came.iter().fold(miss.words, |left, load| left.without(load.words));
            let never =
                Load { colour: miss.colour, target: Target::Hold, corner: miss.corner, words: missing };
            let all = came.into_iter().chain((!missing.is_empty()).then_some(never));
            on_time.extend(all.map(|load| Load { target: Target::Preload(miss.register), ..load }));
        }
        let Step { time, range, .. } = self.steps[fold];
        self.steps
            .splice(fold..fold, on_time.into_iter().map(|load| Step::new(time, range, Event::Load(load))));
        self.misses.retain(|miss| miss.crossing != crossing);
    }

    /// The step of fold `crossing`, if that fold transfers registers.
    fn transfer(&self, crossing: u32) -> Option<usize> {
        let mut folds = self.steps.iter().enumerate().filter(|(_, step)| step.kind.fold().is_some());
        let (place, step) = folds.nth(crossing as usize)?;
        (!matches!(step.kind, StepKind::Event(Event::BareFold(_)))).then_some(place)
    }

    /// Takes out the words that came straight into the hold register of `colour` after step `fold`, before the next fold
    /// that gives it others.
    fn take_late(&mut self, fold: usize, colour: Colour) -> Vec<Load> {
        let (mut late, mut place, mut is_over) = (Vec::new(), 0, false);
        self.steps.retain(|step| {
            let is_after = place > fold;
            place += 1;
            match step.kind {
                StepKind::Event(Event::Load(load))
                    if is_after && !is_over && load.colour == colour && load.target == Target::Hold =>
                {
                    late.push(load);
                    return false;
                }
                StepKind::Event(Event::Fold(fold)) if is_after => {
                    is_over |= fold.axis.takes(fold.stop, colour)
                }
                _ => {}
            }
            true
        });
        late
    }
}

#[cfg(test)]
mod tests {
    use quantities::SweepTime;

    use crate::{
        Colour, Event, Fold, Load, Miss, MissCause, PreloadRegister, RampAxis, Step, Stop, SweepProgram,
        Target, WordMask,
    };

    const FOLD: Fold = Fold { axis: RampAxis::X, stop: Stop::One };

    fn load(target: Target, corner: u32, words: WordMask) -> Event {
        Event::Load(Load { colour: Colour::Yellow, target, corner, words })
    }

    fn miss(crossing: u32, words: WordMask) -> Miss {
        Miss {
            crossing,
            time: SweepTime(f64::from(crossing)),
            arrival: None,
            colour: Colour::Yellow,
            register: PreloadRegister::XFirst,
            corner: 9,
            words,
            cause: MissCause::Queue,
        }
    }

    /// A program with these events, an instant apart.
    fn program(events: &[Event], misses: Vec<Miss>) -> SweepProgram {
        let steps =
            events.iter().zip(0..).map(|(event, k)| Step::new(SweepTime(f64::from(k)), f64::from(k), *event));
        SweepProgram { steps: steps.collect(), misses, ..SweepProgram::idle() }
    }

    fn events(program: &SweepProgram) -> Vec<(f64, Event)> {
        program.events().map(|step| (step.time.0, step.kind)).collect()
    }

    /// Words that came late come before the fold; those that never came are of the corner that was asked for. What came
    /// late for the next fold of the colour stays.
    #[test]
    fn words_come_before_their_fold() {
        let (three, rest) = (WordMask::range(0, 3), WordMask::range(3, 9));
        let before = Target::Preload(PreloadRegister::XFirst);
        let late = [
            Event::Fold(FOLD),
            load(Target::Hold, 7, three),
            Event::Fold(FOLD),
            load(Target::Hold, 8, three),
        ];
        let mut program = program(&late, vec![miss(0, WordMask::ALL), miss(1, three)]);
        assert_eq!(program.late_crossings(), [0, 1]);
        program.bring_on_time(0);
        let expected = [
            (0.0, load(before, 7, three)),
            (0.0, load(before, 9, rest)),
            (0.0, late[0]),
            (2.0, late[2]),
            (3.0, late[3]),
        ];
        assert_eq!(events(&program), expected);
        assert_eq!((program.late_crossings(), program.misses), (vec![1], vec![miss(1, three)]));
    }

    #[test]
    fn a_fold_that_was_not_late_or_transfers_nothing_changes_nothing() {
        let steps = [Event::Fold(FOLD), Event::BareFold(FOLD)];
        let before = program(&steps, vec![miss(1, WordMask::ALL)]);
        for crossing in 0..3 {
            let mut after = before.clone();
            after.bring_on_time(crossing);
            assert_eq!(after, before);
            assert_eq!(before.late_words(crossing), []);
        }
        assert!(before.late_crossings().is_empty());
    }
}
