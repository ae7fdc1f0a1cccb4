//! From text to a condition, clause by clause.

use std::ops::Range;

use signal::{Axis, Kind, Signal};

use crate::condition::{Clause, Condition, Named, Per, Test};
use crate::lexer::{Token, tokens};
use crate::{ConditionError, Fault};

const CLAUSE: &str = "a signal, an event such as late-load, or rising, falling, slope, saturation";
const TEST: &str = "a comparison, `in`, `outside`, `enters`, `leaves`, `shorter` or `longer`";
const NUMBER: &str = "a number";
const PER: &str = "/sample, /m or /us";

/// A reader of one text.
pub struct Parser<'t> {
    text: &'t str,
    table: &'t [Signal],
    tokens: Vec<(Token<'t>, Range<usize>)>,
    next: usize,
}

impl<'t> Parser<'t> {
    pub fn new(text: &'t str, table: &'t [Signal]) -> Self {
        Self { text, table, tokens: tokens(text), next: 0 }
    }

    /// Reads the whole text as one condition.
    pub fn condition(mut self) -> Result<Condition, ConditionError> {
        let mut clauses = vec![self.clause()?];
        while self.takes("and") {
            clauses.push(self.clause()?);
        }
        if self.token() != Token::End {
            return Err(self.unexpected("`and` or the end"));
        }
        let axis = self.common_axis(&clauses)?;
        Ok(Condition { text: self.text.to_owned(), clauses, axis })
    }

    fn token(&self) -> Token<'t> {
        self.tokens[self.next].0
    }

    fn place(&self) -> Range<usize> {
        self.tokens[self.next].1.clone()
    }

    fn step(&mut self) {
        // The end is never passed.
        self.next = (self.next + 1).min(self.tokens.len() - 1);
    }

    /// Takes a word or a sign if it is next.
    fn takes(&mut self, wanted: &str) -> bool {
        let is_next = matches!(self.token(), Token::Word(text) | Token::Sign(text) if text == wanted);
        if is_next {
            self.step();
        }
        is_next
    }

    fn fault(&self, place: Range<usize>, fault: Fault) -> ConditionError {
        ConditionError { text: self.text.to_owned(), place, fault }
    }

    fn unexpected(&self, expected: &'static str) -> ConditionError {
        self.fault(self.place(), Fault::Unexpected { found: self.token().told(), expected })
    }

    fn clause(&mut self) -> Result<Clause, ConditionError> {
        let place = self.place();
        let Token::Word(word) = self.token() else { return Err(self.unexpected(CLAUSE)) };
        match word {
            "rising" | "falling" => {
                self.step();
                self.edge(word == "rising")
            }
            "slope" => {
                self.step();
                self.slope()
            }
            "saturation" => {
                self.step();
                self.saturation(place)
            }
            "late-load" => self.any_of(&["dpu.late", "dpu.coarse.late"]),
            "fold" => {
                self.step();
                self.fold(place)
            }
            "blank" => self.gate_moves("dpp.blank", Test::Above(0.5)),
            "unblank" => self.gate_moves("dpp.blank", Test::Below(0.5)),
            "and" => Err(self.unexpected(CLAUSE)),
            _ => self.of_signal(),
        }
    }

    /// `SIGNAL` and what is asked of it.
    fn of_signal(&mut self) -> Result<Clause, ConditionError> {
        let of = self.signal()?;
        if of.signal.kind == Kind::Event {
            let test = self.comparison()?;
            return Ok(Clause::Event { any: vec![of], test });
        }
        if let Some(test) = self.comparison()? {
            return Ok(Clause::Level { of, slope: None, test });
        }
        let Token::Word(word) = self.token() else { return self.gate_alone(of) };
        match word {
            "in" | "outside" => Ok(Clause::Level { of, slope: None, test: self.window(word)? }),
            "enters" => Ok(Clause::Becomes { of, test: self.window("in")? }),
            "leaves" => Ok(Clause::Becomes { of, test: self.window("outside")? }),
            "shorter" | "longer" => self.pulse(of, word == "longer"),
            _ => self.gate_alone(of),
        }
    }

    /// A gate by itself: it is on.
    fn gate_alone(&mut self, of: Named) -> Result<Clause, ConditionError> {
        match of.signal.kind {
            Kind::Gate => Ok(Clause::Level { of, slope: None, test: Test::Above(0.5) }),
            _ => Err(self.unexpected(TEST)),
        }
    }

    fn edge(&mut self, rising: bool) -> Result<Clause, ConditionError> {
        let of = self.signal_with_values()?;
        let level = self.number(NUMBER)?;
        let by = if self.takes("by") { self.size("a hysteresis of 0 or more")? } else { 0.0 };
        Ok(Clause::Edge { of, rising, level, by })
    }

    fn slope(&mut self) -> Result<Clause, ConditionError> {
        let of = self.signal()?;
        self.expect_kind(&of, &[Kind::Analog], "a voltage")?;
        let test = match (self.comparison()?, self.token()) {
            (Some(test), _) => test,
            (None, Token::Word(word @ ("in" | "outside"))) => self.window(word)?,
            (None, _) => return Err(self.unexpected("a comparison, `in` or `outside`")),
        };
        let place = self.place();
        let slope = if self.takes("/") { self.per()? } else { return Err(self.unexpected(PER)) };
        if slope != Per::Sample && of.signal.axis == Axis::Display {
            let place = place.start..self.tokens[self.next - 1].1.end;
            let found = format!("`{}`", &self.text[place.clone()]);
            return Err(
                self.fault(place, Fault::Unexpected { found, expected: "/sample: a line of the display" })
            );
        }
        Ok(Clause::Level { of, slope: Some(slope), test })
    }

    fn per(&mut self) -> Result<Per, ConditionError> {
        let per = self.unit().ok_or_else(|| self.unexpected("sample, m or us"))?;
        self.step();
        Ok(per)
    }

    fn unit(&self) -> Option<Per> {
        match self.token() {
            Token::Word("sample" | "samples") => Some(Per::Sample),
            Token::Word("m") => Some(Per::Metre),
            Token::Word("us" | "µs") => Some(Per::Microsecond),
            _ => None,
        }
    }

    fn saturation(&mut self, place: Range<usize>) -> Result<Clause, ConditionError> {
        let is_named = matches!(self.token(), Token::Word(word) if word != "and");
        if !is_named {
            return Ok(Clause::Saturated(None, place));
        }
        let of = self.signal()?;
        self.expect_kind(&of, &[Kind::Analog], "a voltage")?;
        Ok(Clause::Saturated(Some(of), place))
    }

    fn any_of(&mut self, names: &[&str]) -> Result<Clause, ConditionError> {
        let any = names.iter().map(|name| self.known(name)).collect::<Result<_, _>>()?;
        self.step();
        Ok(Clause::Event { any, test: None })
    }

    /// `fold`, `fold x`, `fold y`, with the stop as value.
    fn fold(&mut self, place: Range<usize>) -> Result<Clause, ConditionError> {
        let names: &[&str] = match self.token() {
            Token::Word("x") => &["sweep.fold.x"],
            Token::Word("y") => &["sweep.fold.y"],
            Token::Word(word) if word != "and" => return Err(self.unexpected("x, y, `=`, `and` or the end")),
            _ => &["sweep.fold.x", "sweep.fold.y"],
        };
        if names.len() == 1 {
            self.step();
        }
        let mut any = names.iter().map(|name| self.known(name)).collect::<Result<Vec<_>, _>>()?;
        any.iter_mut().for_each(|named| named.place = place.clone());
        Ok(Clause::Event { any, test: self.stop()? })
    }

    /// A comparison with a stop, if one is next: there are two.
    fn stop(&mut self) -> Result<Option<Test>, ConditionError> {
        let test = self.comparison()?;
        match test {
            Some(Test::Is(stop) | Test::IsNot(stop)) if stop != 0.0 && stop != 1.0 => {
                let place = self.tokens[self.next - 1].1.clone();
                let found = format!("`{}`", &self.text[place.clone()]);
                Err(self.fault(place, Fault::Unexpected { found, expected: "a stop, 0 or 1" }))
            }
            test => Ok(test),
        }
    }

    fn gate_moves(&mut self, name: &str, test: Test) -> Result<Clause, ConditionError> {
        let of = self.known(name)?;
        self.step();
        Ok(Clause::Becomes { of, test })
    }

    /// `shorter` or `longer`, a width, and its unit.
    fn pulse(&mut self, of: Named, longer: bool) -> Result<Clause, ConditionError> {
        self.expect_kind(&of, &[Kind::Gate], "a gate")?;
        self.step();
        let width = self.size("a width of 0 or more")?;
        let per = self.unit();
        if per.is_some() {
            self.step();
        }
        Ok(Clause::Pulse { of, longer, width, per: per.unwrap_or(Per::Sample) })
    }

    /// A comparison with a number, if one is next.
    fn comparison(&mut self) -> Result<Option<Test>, ConditionError> {
        let test: fn(f64) -> Test = match self.token() {
            Token::Sign(">") => Test::Above,
            Token::Sign(">=") => Test::AtLeast,
            Token::Sign("<") => Test::Below,
            Token::Sign("<=") => Test::AtMost,
            Token::Sign("=") => Test::Is,
            Token::Sign("!=") => Test::IsNot,
            _ => return Ok(None),
        };
        self.step();
        Ok(Some(test(self.number(NUMBER)?)))
    }

    /// The window behind the next word.
    fn window(&mut self, word: &str) -> Result<Test, ConditionError> {
        self.step();
        let begin = self.place().start;
        let from = self.number("a window, as 1650..1700")?;
        if !self.takes("..") {
            return Err(self.unexpected("`..` and the upper end of the window"));
        }
        let place = begin..self.place().end;
        let until = self.number("the upper end of the window")?;
        if from > until {
            return Err(self.fault(place, Fault::EmptyWindow { from, until }));
        }
        Ok(if word == "in" { Test::Inside([from, until]) } else { Test::Outside([from, until]) })
    }

    fn number(&mut self, expected: &'static str) -> Result<f64, ConditionError> {
        let Token::Number(value) = self.token() else { return Err(self.unexpected(expected)) };
        self.step();
        Ok(value)
    }

    fn size(&mut self, expected: &'static str) -> Result<f64, ConditionError> {
        let place = self.place();
        let value = self.number(expected)?;
        match value < 0.0 {
            true => Err(self.fault(place, Fault::Negative { value, expected })),
            false => Ok(value),
        }
    }

    fn signal(&mut self) -> Result<Named, ConditionError> {
        let Token::Word(name) = self.token() else { return Err(self.unexpected("the name of a signal")) };
        let named = self.known(name)?;
        self.step();
        Ok(named)
    }

    /// A signal that has a value at any time.
    fn signal_with_values(&mut self) -> Result<Named, ConditionError> {
        let of = self.signal()?;
        self.expect_kind(&of, &[Kind::Analog, Kind::Gate, Kind::Bus], "a voltage, a gate or a bus")?;
        Ok(of)
    }

    /// The signal called `name`, at the place of the next token.
    fn known(&self, name: &str) -> Result<Named, ConditionError> {
        let place = self.place();
        match self.table.iter().find(|signal| signal.name == name) {
            Some(signal) => Ok(Named { signal: *signal, place }),
            None => {
                Err(self
                    .fault(place, Fault::UnknownSignal { name: name.into(), nearest: self.nearest(name) }))
            }
        }
    }

    /// The signal whose name is most like `name`, if any is like it.
    fn nearest(&self, name: &str) -> Option<&'static str> {
        let likeness = |signal: &Signal| (strsim::jaro_winkler(name, signal.name), signal.name);
        let best =
            self.table.iter().map(likeness).reduce(|best, next| if next.0 > best.0 { next } else { best });
        best.filter(|(likeness, _)| *likeness > 0.75).map(|(_, name)| name)
    }

    fn expect_kind(&self, of: &Named, kinds: &[Kind], expected: &'static str) -> Result<(), ConditionError> {
        if kinds.contains(&of.signal.kind) {
            return Ok(());
        }
        let found = match of.signal.kind {
            Kind::Analog => "a voltage",
            Kind::Gate => "a gate",
            Kind::Bus => "a bus",
            Kind::Event => "an event",
        };
        Err(self.fault(of.place.clone(), Fault::WrongKind { name: of.signal.name, found, expected }))
    }

    /// The axis along which all clauses have samples.
    fn common_axis(&self, clauses: &[Clause]) -> Result<Axis, ConditionError> {
        let named = || clauses.iter().flat_map(Clause::named);
        let display = named().find(|named| named.signal.axis == Axis::Display);
        let ground = named().find(|named| named.signal.axis != Axis::Display);
        match (display, ground) {
            (None, _) => Ok(Axis::Ground),
            (Some(_), None) => self.without_saturation(clauses),
            (Some(display), Some(ground)) => {
                let second = if display.place.start > ground.place.start { display } else { ground };
                let (name, other) = (display.signal.name, ground.signal.name);
                Err(self.fault(second.place.clone(), Fault::TwoAxes { name, other }))
            }
        }
    }

    /// Saturation of any voltage is looked for along the ground.
    fn without_saturation(&self, clauses: &[Clause]) -> Result<Axis, ConditionError> {
        let any = clauses.iter().find_map(|clause| match clause {
            Clause::Saturated(None, place) => Some(place.clone()),
            _ => None,
        });
        match any {
            None => Ok(Axis::Display),
            Some(place) => {
                let fault = Fault::Unexpected {
                    found: "`saturation` of any voltage".into(),
                    expected: "a signal of the display",
                };
                Err(self.fault(place, fault))
            }
        }
    }
}
