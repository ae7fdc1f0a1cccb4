//! `[[event]]`: what happens to objects, and whether it can.

use diagnostics::{Placed, Problem, Reader};
use limits::Limit;
use quantities::radians;

use super::object_ids::Ids;
use super::scenery::{expect_count, place};
use crate::{Action, Event, Object};

/// The events of a scenario, ascending in time; every one that cannot happen is a problem.
pub(super) fn events(tables: &[Reader], objects: &[Object]) -> Option<Vec<Event>> {
    expect_count(tables, Limit::Events, "events")?;
    let ids = Ids::of(objects);
    let read: Vec<_> = tables.iter().map(|table| event(table, &ids)).collect();
    let mut events = read.into_iter().collect::<Option<Vec<Placed<Event>>>>()?;
    // Stable: the later line of two at one time is the one that is refused.
    events.sort_by(|a, b| a.value.time.total_cmp(&b.value.time));
    let mut all_happen = true;
    let mut own: Vec<Vec<&Placed<Event>>> = vec![Vec::new(); objects.len()];
    events.iter().for_each(|event| own[event.value.object].push(event));
    for (object, own) in objects.iter().zip(own) {
        for problem in impossible(object, own.into_iter()) {
            tables[0].report(problem);
            all_happen = false;
        }
    }
    all_happen.then(|| events.into_iter().map(|event| event.value).collect())
}

fn event(table: &Reader, ids: &Ids<'_>) -> Option<Placed<Event>> {
    let time = table.f64("t_s").at_least(0.0).at_most(1e6).unit("s").placed().required();
    let object = ids.object(table, "object", "an event without an object that it could happen to");
    #[derive(Clone, Copy, PartialEq)]
    enum Word {
        Move,
        Delete,
        Add,
    }
    let words = [("move", Word::Move), ("delete", Word::Delete), ("add", Word::Add)];
    let action = match table.one_of("action", &words).required() {
        Some(Word::Move) => motion(table),
        Some(Word::Delete) => Some(Action::Delete),
        Some(Word::Add) => Some(Action::Add),
        None => {
            table.ignore_rest();
            None
        }
    };
    let Placed { value: time, place, key } = time?;
    Some(Placed { value: Event { time, object: object?, action: action? }, place, key })
}

fn motion(table: &Reader) -> Option<Action> {
    let at = place(table);
    let heading = table.f64("heading_deg").between(-360.0, 360.0).unit("degrees").map(radians);
    let heading = heading.optional();
    Some(Action::Move { at: at?, heading })
}

/// What is wrong with the events of one object, ascending in time.
fn impossible<'e>(object: &Object, events: impl Iterator<Item = &'e Placed<Event>>) -> Vec<Problem> {
    let mut stands = object.present;
    let mut before: Option<f64> = None;
    let mut problems = Vec::new();
    for event in events {
        let (id, Event { time, action, .. }) = (&object.id, event.value);
        let fault = if before == Some(time) {
            Some((format!("two events of \"{id}\" at t = {time} s"), "another time, or one of the two"))
        } else {
            match (action, stands) {
                (Action::Move { .. }, _) if object.moves.is_some() => {
                    Some((format!("\"{id}\" is moved at t = {time} s, and `moves` says where it is"), MOVES))
                }
                (Action::Add, true) => {
                    Some((format!("\"{id}\" is added at t = {time} s and stands already"), ADD))
                }
                (Action::Delete, false) => {
                    Some((format!("\"{id}\" is deleted at t = {time} s and does not stand"), STAND))
                }
                (Action::Move { .. }, false) => {
                    Some((format!("\"{id}\" is moved at t = {time} s and does not stand"), STAND))
                }
                _ => None,
            }
        };
        problems.extend(fault.map(|(title, expected)| Problem::of(event, title).expected(expected)));
        before = Some(time);
        stands = !matches!(action, Action::Delete);
    }
    problems
}

const MOVES: &str = "an event, or `moves` of the object: one of the two";
const ADD: &str = "an object declared with `present = false`, or deleted before";
const STAND: &str = "an object that stands then: present from the start, or added before";
