//! Names with dots as scopes within scopes, blocks first.

use signal::{Axis, Wire};

/// A scope: its wires, then the scopes inside.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Scope {
    /// Name; empty for the root.
    pub name: &'static str,
    /// Own name and place in the header of each wire.
    pub wires: Vec<(&'static str, usize)>,
    /// Scopes inside, in the order in which they come first.
    pub scopes: Vec<Scope>,
}

/// Scope of the signals that lie against display lines, not against time.
pub const DISPLAY: &str = "display";

impl Scope {
    /// The tree of all wires: scopes are blocks by prefix, signals of the display axis below [`DISPLAY`].
    pub fn of(wires: &[Wire]) -> Self {
        let mut root = Self::default();
        for (place, wire) in wires.iter().enumerate() {
            let (scopes, name) = path(wire);
            let mut scope = &mut root;
            for inner in scopes {
                scope = scope.inside(inner);
            }
            scope.wires.push((name, place));
        }
        root
    }

    fn inside(&mut self, name: &'static str) -> &mut Self {
        let place = self.scopes.iter().position(|scope| scope.name == name).unwrap_or_else(|| {
            self.scopes.push(Self { name, ..Self::default() });
            self.scopes.len() - 1
        });
        &mut self.scopes[place]
    }
}

/// Scopes of a wire, outermost first, and its own name. A name without a dot is a scope and a name.
pub fn path(wire: &Wire) -> (Vec<&'static str>, &'static str) {
    let mut scopes: Vec<&str> = if wire.signal.axis == Axis::Display { vec![DISPLAY] } else { vec![] };
    let (blocks, name) = wire.signal.name.rsplit_once('.').unwrap_or((wire.signal.name, wire.signal.name));
    scopes.extend(blocks.split('.'));
    (scopes, name)
}
