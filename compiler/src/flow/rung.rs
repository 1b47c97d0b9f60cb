//! One rung: from what its contacts hold to what its coils receive.

use super::kinds::{Condition, Value};
use super::network::{Follow, Join, Op, Unit};
use super::places::Slot;
use super::solve::Solver;

/// An open branch.
pub(super) struct Frame {
    /// The condition at its begin.
    absolute: Condition,
    /// What makes the legs before the branch false.
    relative: Value,
    /// What makes a leg true, from the rail on.
    on: Value,
    /// What makes all legs so far false.
    off: Value,
}

/// The state of a rung under way.
struct Rung {
    /// Why the routine is executed, and why not.
    rail: Condition,
    /// What left the rung out or ended it before.
    spoil: Value,
    /// The condition from the rail on.
    absolute: Condition,
    /// What makes it false since the innermost branch began.
    relative: Value,
    /// What was computed.
    value: Value,
    /// Why it may not be stored though the rung is true.
    unless: Value,
}

impl Rung {
    /// In series with the reasons for which the rung is executed.
    fn executed(&self, value: Value) -> Value {
        let value = value.series(self.rail.on);
        if self.spoil.kinds.is_none() { value } else { value.series(self.spoil.taint()) }
    }

    /// The reasons for which it is not executed.
    fn not_executed(&self) -> Value {
        let spoil = if self.spoil.kinds.is_none() { Value::NONE } else { self.spoil.taint() };
        self.rail.off.either(spoil)
    }

    fn series(&mut self, contact: Condition) {
        self.absolute = self.absolute.series(contact);
        self.relative = self.relative.either(contact.off);
    }
}

impl Solver<'_> {
    /// What a rung writes.
    pub(super) fn unit(&mut self, number: u32) {
        let network = self.network;
        let unit = &network.units[number as usize];
        let mut rung = self.begin_rung(unit);
        self.frames.clear();
        for at in unit.ops.start..unit.ops.end {
            self.operation(at, &mut rung);
        }
    }

    fn begin_rung(&self, unit: &Unit) -> Rung {
        let mut absolute = match unit.zone {
            Some(zone) => {
                let on = self.read(zone.on);
                Condition { on: if zone.entered { on.taint() } else { on }, off: self.read(zone.off) }
            }
            None => Condition::RAIL,
        };
        if unit.incomplete {
            absolute = absolute.series(Condition { on: Value::SAFETY, off: Value::SAFETY });
        }
        Rung {
            rail: self.condition(unit.rail.0, unit.rail.1),
            spoil: unit.spoil.map_or(Value::NONE, |read| self.read(read)),
            absolute,
            relative: Value::NONE,
            value: Value::NEUTRAL,
            unless: Value::NONE,
        }
    }

    fn condition(&self, on: u32, off: u32) -> Condition {
        Condition { on: self.read(on), off: self.read(off) }
    }

    fn operation(&mut self, at: u32, rung: &mut Rung) {
        let op = self.network.ops[at as usize];
        match op {
            Op::Contact { on, off, selected } => {
                let contact = self.condition(on, off);
                let by = |value: Value| if selected { value.mixed(rung.value) } else { value };
                rung.series(Condition { on: by(contact.on), off: by(contact.off) });
            }
            Op::Test => rung.series(Condition { on: rung.value, off: rung.value }),
            Op::Never => rung.series(Condition { on: Value::NONE, off: Value::NEUTRAL }),
            Op::Edge { on, off } => {
                let stored = self.condition(on, off);
                rung.absolute.on = rung.absolute.on.series(stored.off.taint());
                rung.absolute.off = rung.absolute.off.either(stored.on);
                rung.relative = rung.relative.either(stored.on);
            }
            Op::Open => {
                let (on, off) = (Value::NONE, Value::NEUTRAL);
                self.frames.push(Frame { absolute: rung.absolute, relative: rung.relative, on, off });
                rung.relative = Value::NONE;
            }
            Op::Leg | Op::Close => self.leg(matches!(op, Op::Close), rung),
            Op::Clear => (rung.value, rung.unless) = (Value::NEUTRAL, Value::NONE),
            Op::Nothing => (rung.value, rung.unless) = (Value::NONE, Value::NONE),
            Op::Unless { read } => rung.unless = rung.unless.either(self.read(read)),
            Op::Join { read, how } => {
                let (value, joined) = (rung.value, self.read(read));
                rung.value = match how {
                    Join::Series => value.series(joined),
                    Join::Either => value.either(joined),
                    Join::Mixed => value.mixed(joined),
                    Join::Taint => value.series(joined.taint()),
                    Join::Spoil => value.either(joined.spoil()),
                };
            }
            Op::Resume { on, off } => {
                let bit = self.condition(on, off);
                rung.absolute = Condition {
                    on: rung.absolute.on.series(bit.on).either(bit.on),
                    off: rung.absolute.off.either(bit.off),
                };
                rung.relative = rung.relative.either(bit.off);
            }
            _ => self.store(at, op, rung),
        }
    }

    fn leg(&mut self, last: bool, rung: &mut Rung) {
        let Some(frame) = self.frames.last_mut() else { return };
        frame.on = frame.on.either(rung.absolute.on);
        frame.off = frame.off.series(rung.relative);
        if !last {
            (rung.absolute, rung.relative) = (frame.absolute, Value::NONE);
            return;
        }
        rung.absolute = Condition { on: frame.on, off: frame.absolute.off.either(frame.off) };
        rung.relative = frame.relative.either(frame.off);
        self.frames.pop();
    }

    fn store(&mut self, at: u32, op: Op, rung: &mut Rung) {
        let Condition { on, off } = rung.absolute;
        let unless = off.either(rung.not_executed());
        match op {
            // What is moved on is named before the conditions on which it is.
            Op::Store { slot, write } => {
                self.write(slot, rung.value.series(rung.executed(on)), write);
                self.keep(at, [Some(slot), None], unless.either(rung.unless), write);
            }
            Op::Put { slot, write } => {
                self.write(slot, rung.executed(rung.value), write);
                self.keep(at, [Some(slot), None], rung.not_executed(), write);
            }
            Op::Break { slot, write } => {
                self.write(slot, rung.executed(off.either(rung.value)), write);
                self.keep(at, [Some(slot), None], rung.not_executed(), write);
            }
            Op::Any { slot, write } => {
                self.write(slot, rung.executed(on.either(off)).series(rung.value), write);
            }
            Op::Skipped { slot, write } => self.write(slot, unless, write),
            Op::NotFalse { slot, write } => self.write(slot, on.either(rung.not_executed()), write),
            Op::Leave { slot, write } => {
                // Whether it is left at all is decided by what leaves it out before, too.
                let reasons = rung.executed(on.either(off)).either(rung.spoil);
                self.write(slot, reasons, write);
                rung.spoil = rung.spoil.either(reasons);
            }
            Op::Bit { on: set, off: clear, follow, write } => self.bit(at, (set, clear), follow, write, rung),
            _ => {}
        }
    }

    fn bit(&mut self, at: u32, (set, clear): (Slot, Slot), follow: Follow, write: u32, rung: &Rung) {
        let when_true = rung.executed(rung.absolute.on).series(rung.value);
        let when_false = rung.executed(rung.absolute.off).series(rung.value);
        let any = when_true.either(when_false);
        let (to_set, to_clear) = match follow {
            Follow::Coil => (when_true, when_false),
            Follow::Latch => (when_true, Value::NONE),
            Follow::Unlatch => (Value::NONE, when_true),
            Follow::Pulse => (when_true.series(rung.absolute.off.taint()), any),
            Follow::Falling => (when_false.series(rung.absolute.on.taint()), any),
            Follow::Held => (when_true.series(rung.absolute.off.taint()), when_false),
            Follow::Beyond => (when_true, any),
        };
        self.write(set, to_set, write);
        self.write(clear, to_clear, write);
        let unless = rung.absolute.off.either(rung.not_executed());
        if rung.value.kinds.has_unqualified() {
            // A subscript decides whether this or another element of an array is written.
            self.spoil_elements(set, rung.value, write);
            self.spoil_elements(clear, rung.value, write);
        }
        match follow {
            Follow::Latch | Follow::Beyond => self.keep(at, [None, Some(clear)], unless, write),
            Follow::Unlatch => self.keep(at, [Some(set), None], unless, write),
            _ => self.keep(at, [Some(set), Some(clear)], rung.not_executed(), write),
        }
    }
}
