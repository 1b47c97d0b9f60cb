//! The channel's bits, for fault injection (`twinrung_bytecode::injection`).
//!
//! Left out is what no later execution reads: frames and bound arguments, which each begins by forgetting; the bytes of a
//! COP, which each writes before it reads them; the cells of the banks behind those in use. Which of three sizes the banks
//! have is their length, and out of reach.

mod parts;
mod tables;

use twinrung_bytecode::injection::{BitVisitor, Field, Injectable, Memory};

use crate::channel::Partner;
use crate::ladder::{Call, Ladder, Subroutine};
use crate::panel::Panels;
use crate::panel::record::{Pools, Records};
use crate::state::State;
use parts::Packed;

impl Injectable for Partner {
    fn visit_bits(&mut self, memory: Memory, visitor: &mut BitVisitor) {
        match memory {
            Memory::Program => {
                ladder(&mut self.ladder, visitor);
                visitor.field(&mut self.state.memory.image_bits);
                visitor.field(&mut self.state.memory.image_words);
                visitor.field(&mut self.state.memory.used_words);
            }
            Memory::Cells => {
                let cells = &mut self.state.memory;
                visitor.fields(cells.bits.get_mut(..cells.image_bits).unwrap_or_default());
                visitor.fields(cells.words.get_mut(..cells.image_words).unwrap_or_default());
            }
            Memory::State => {
                let used = self.ladder.initial_bits.len();
                state(&mut self.state, used, visitor);
                visitor.field(&mut self.first_scan);
            }
        }
    }
}

fn ladder(ladder: &mut Ladder, visitor: &mut BitVisitor) {
    visitor.fields(&mut ladder.steps);
    visitor.fields(&mut ladder.arguments);
    visitor.fields(&mut ladder.dynamics);
    for span in &mut ladder.spans {
        visitor.field(&mut span.start);
        visitor.field(&mut Packed(&mut span.element));
        for number in [&mut span.count, &mut span.bytes, &mut span.bits, &mut span.words] {
            visitor.field(number);
        }
        visitor.field(&mut span.moves);
        visitor.field(&mut span.first_field);
        visitor.field(&mut span.fields);
    }
    visitor.fields(&mut ladder.fields);
    visitor.fields(&mut ladder.operations);
    visitor.fields(&mut ladder.expressions);
    visitor.fields(&mut ladder.bodies);
    for called in &mut ladder.calls {
        call(called, visitor);
    }
    visitor.fields(&mut ladder.jumps);
    visitor.field(&mut ladder.counters);
    for called in &mut ladder.subroutines {
        subroutine(called, visitor);
    }
    for value in &mut ladder.system_values {
        for number in [&mut value.first, &mut value.length, &mut value.width] {
            visitor.field(number);
        }
        visitor.field(&mut Packed(&mut value.record_of));
    }
    for program in &mut ladder.programs {
        for body in [&mut program.main, &mut program.fault] {
            visitor.field(&mut Packed(body));
        }
        visitor.field(&mut program.disabled);
    }
    for program in &mut ladder.schedule {
        visitor.field(&mut program.0);
    }
    panels(&mut ladder.panels, visitor);
    visitor.field(&mut ladder.own);
    visitor.fields(&mut ladder.initial_bits);
    visitor.fields(&mut ladder.initial_words);
}

fn call(call: &mut Call, visitor: &mut BitVisitor) {
    visitor.fields(&mut call.arguments);
    visitor.fields(&mut call.inputs);
    visitor.fields(&mut call.outputs);
    visitor.field(&mut call.enable_in);
    visitor.field(&mut call.enable_out);
    visitor.field(&mut call.logic.0);
    visitor.field(&mut Packed(&mut call.prescan));
    visitor.field(&mut Packed(&mut call.enable_in_false));
    visitor.fields(&mut call.configuration);
    visitor.field(&mut call.private);
    visitor.field(&mut call.prescanned);
}

fn subroutine(call: &mut Subroutine, visitor: &mut BitVisitor) {
    visitor.field(&mut call.body.0);
    visitor.fields(&mut call.inputs);
    visitor.fields(&mut call.receivers);
    visitor.fields(&mut call.returns);
    visitor.field(&mut call.fault_routine);
}

fn panels(panels: &mut Panels, visitor: &mut BitVisitor) {
    visitor.fields(&mut panels.regions);
    visitor.fields(&mut panels.runs);
    visitor.fields(&mut panels.guards);
    match &mut panels.records {
        Records::Small(records) => pools(records, visitor),
        Records::Medium(records) | Records::Large(records) => pools(records, visitor),
    }
}

fn pools<I: Field>(pools: &mut Pools<I>, visitor: &mut BitVisitor) {
    visitor.fields(&mut pools.four_contacts);
    visitor.fields(&mut pools.six_contacts);
    visitor.fields(&mut pools.compares);
    visitor.fields(&mut pools.extracts);
    visitor.fields(&mut pools.inserts);
    visitor.fields(&mut pools.timers);
    visitor.fields(&mut pools.moves);
    visitor.fields(&mut pools.sums);
    visitor.fields(&mut pools.others);
}

/// What the comparison does not see as cells; `used` bit cells have a use.
fn state(state: &mut State, used: usize, visitor: &mut BitVisitor) {
    let cells = &mut state.memory;
    visitor.fields(cells.bits.get_mut(cells.image_bits..used).unwrap_or_default());
    visitor.fields(cells.words.get_mut(cells.image_words..cells.used_words).unwrap_or_default());
    visitor.fields(cells.stamps.get_mut(..cells.used_words).unwrap_or_default());
    visitor.field(&mut state.status.key);
    visitor.field(&mut state.status.minor_faults);
    visitor.field(&mut state.executed);
    visitor.field(&mut state.executed_before);
    visitor.field(&mut state.path);
    visitor.field(&mut state.cleared_faults);
    for flag in [&mut state.armed, &mut state.faulted, &mut state.in_fault_routine, &mut state.in_library] {
        visitor.field(flag);
    }
    visitor.fields(state.records.as_flattened_mut());
    visitor.fields(&mut state.events);
    visitor.fields(state.jumps.as_flattened_mut());
    visitor.fields(&mut state.visited);
    visitor.fields(&mut state.passed);
    visitor.fields(&mut state.values);
    visitor.fields(&mut state.addresses);
}
