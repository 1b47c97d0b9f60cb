//! Labels, subroutines and their parameters.

use alloc::collections::BTreeMap;
use alloc::string::String;
use alloc::vec::Vec;

use twinrung_catalog::{Element, Opcode};

use super::instruction::Check;
use super::operands::Fact;
use super::place::Place;
use crate::code::Operands;
use crate::error::{ImageError, Site};
use crate::image::{Image, Owner, TypeReference};
use crate::index::RoutineIndex;
use crate::limits;
use crate::names;
use crate::operand::OperandRecord;
use crate::text;

/// What passes through one parameter: types must be equal, nothing is converted (REQ-EXEC-023).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Passed {
    type_reference: TypeReference,
    dimensions: [u32; 3],
}

impl Passed {
    fn of(fact: Fact) -> Option<Passed> {
        let element = |element| Some(Passed { type_reference: TypeReference::Element(element), dimensions: [0; 3] });
        match fact {
            Fact::Integer(_) => element(Element::Dint),
            Fact::Real(_) => element(Element::Real),
            Fact::Reference(place) if place.bit.is_some() => element(Element::Bool),
            Fact::Reference(Place { type_reference, dimensions, .. }) => Some(Passed { type_reference, dimensions }),
            _ => None,
        }
    }
}

/// One JSR.
pub(super) struct Call {
    at: Site,
    target: RoutineIndex,
    inputs: Vec<Passed>,
    returns: Vec<Passed>,
}

/// What a routine offers to those that call or jump.
#[derive(Default)]
pub(super) struct Signature {
    /// The operands of its SBR.
    receives: Vec<Passed>,
    /// The operands of its RETs, where they all have the same types.
    returns: Option<Vec<Passed>>,
    /// Whether they differ.
    mixed: bool,
    labels: BTreeMap<String, String>,
    jumps: Vec<(Site, String)>,
}

impl Signature {
    /// Every jump leads to a label of the routine.
    pub(super) fn check_labels(&self) -> Result<(), ImageError> {
        for (at, label) in &self.jumps {
            if self.labels.get(&label.to_ascii_lowercase()) != Some(label) {
                return Err(ImageError::LabelMissing { at: *at });
            }
        }
        Ok(())
    }
}

impl Check<'_, '_> {
    /// JMP and LBL. A label is written in one way.
    pub(super) fn label(&mut self, opcode: Opcode, operands: Operands<'_>) -> Result<(), ImageError> {
        let at = self.at;
        let operand = operands.get(0).ok_or(ImageError::OperandCount { at })?;
        let OperandRecord::Text(label) = text::decode(self.tables.image, operand)? else {
            return Err(ImageError::LabelName { at });
        };
        if !names::is_component(&label) {
            return Err(ImageError::LabelName { at });
        }
        if opcode == Opcode::Jmp {
            self.signature.jumps.push((at, label));
        } else if self.signature.labels.insert(label.to_ascii_lowercase(), label).is_some() {
            return Err(ImageError::LabelTwice { at });
        }
        Ok(())
    }

    fn passed(&self, operands: Operands<'_>, from: usize) -> Result<Vec<Passed>, ImageError> {
        let kind = |position| ImageError::OperandKind { at: self.at, position };
        let mut passed = Vec::with_capacity(operands.len().saturating_sub(from));
        for (position, operand) in operands.iter().enumerate().skip(from) {
            passed.push(Passed::of(self.entries.get(operand)?.fact).ok_or(kind(position))?);
        }
        Ok(passed)
    }

    /// SBR and RET. Within an Add-On Instruction nobody passes anything.
    pub(super) fn parameters(&mut self, opcode: Opcode, operands: Operands<'_>) -> Result<(), ImageError> {
        let at = self.at;
        let in_add_on = matches!(self.owner, Owner::AddOn(_));
        if in_add_on && (opcode == Opcode::Sbr || !operands.is_empty()) {
            return Err(ImageError::CallOutside { at });
        }
        if operands.len() > limits::JSR_PARAMETERS {
            return Err(ImageError::CallCount { at });
        }
        let passed = self.passed(operands, 0)?;
        if opcode == Opcode::Sbr {
            self.write_all(operands, 0)?;
            self.signature.receives = passed;
        } else {
            match &self.signature.returns {
                Some(before) => self.signature.mixed |= *before != passed,
                None => self.signature.returns = Some(passed),
            }
        }
        Ok(())
    }

    fn write_all(&mut self, operands: Operands<'_>, from: usize) -> Result<(), ImageError> {
        for position in from..operands.len() {
            let place = self.place(operands, position);
            let place = place.ok_or(ImageError::OperandKind { at: self.at, position })?;
            let elements = if place.is_whole_array() { place.count } else { 1 };
            self.write(&place, elements)?;
        }
        Ok(())
    }

    /// JSR.
    pub(super) fn call(&mut self, operands: Operands<'_>) -> Result<(), ImageError> {
        let at = self.at;
        let Owner::Program(program) = self.owner else { return Err(ImageError::CallOutside { at }) };
        // Of the same program: the scope of the operand says so.
        let target = operands.get(0).and_then(|operand| self.entries.get(operand).ok()).map(|entry| entry.fact);
        let Some(Fact::Routine(target)) = target else { return Err(ImageError::OperandKind { at, position: 0 }) };
        let stated = self.literal(operands, 1).and_then(|count| usize::try_from(count).ok());
        let passed = self.passed(operands, 2)?;
        let (inputs, returns) = stated
            .and_then(|count| passed.split_at_checked(count))
            .filter(|(inputs, returns)| inputs.len().max(returns.len()) <= limits::JSR_PARAMETERS)
            .ok_or(ImageError::CallCount { at })?;
        let (inputs, returns) = (inputs.to_vec(), returns.to_vec());
        self.write_all(operands, 2usize.saturating_add(inputs.len()))?;
        if self.is_user_fault(program, target, operands, returns.len()) {
            return Ok(());
        }
        self.calls.push(Call { at, target, inputs, returns });
        Ok(())
    }

    /// JSR to the fault routine with a number from 990 to 999 calls nothing: it raises a fault (REQ-EXEC-053).
    fn is_user_fault(
        &self,
        program: crate::index::ProgramIndex,
        target: RoutineIndex,
        operands: Operands<'_>,
        returns: usize,
    ) -> bool {
        let fault = self.tables.image.programs.get(program.position()).and_then(|program| program.fault);
        let number = if operands.len() == 3 { self.literal(operands, 2) } else { None };
        fault == Some(target) && returns == 0 && number.is_some_and(|number| (990..=999).contains(&number))
    }
}

/// Who calls whom.
pub(super) struct Calls {
    routines: Vec<Routine>,
}

#[derive(Default)]
struct Routine {
    signature: Signature,
    calls: Vec<Call>,
    /// Instructions, first its own, then with those of its subroutines.
    length: u64,
    depth: usize,
}

impl Calls {
    pub(super) fn new(routines: usize) -> Calls {
        let mut list = Vec::new();
        list.resize_with(routines, Routine::default);
        Calls { routines: list }
    }

    pub(super) fn add(&mut self, routine: RoutineIndex, signature: Signature, calls: Vec<Call>, length: u64) {
        if let Some(place) = self.routines.get_mut(routine.position()) {
            *place = Routine { signature, calls, length, depth: 0 };
        }
    }

    /// Parameters fit, nobody calls itself, depth and length are bounded.
    pub(super) fn check(mut self, image: &Image) -> Result<(), ImageError> {
        self.check_parameters()?;
        self.check_graph()?;
        let mut scan = 0u64;
        for program in &image.programs {
            for routine in [program.main, program.fault].into_iter().flatten() {
                let length = self.routines.get(routine.position()).map_or(0, |found| found.length);
                scan = scan.saturating_add(length);
                if scan > limits::STRAIGHT_INSTRUCTIONS {
                    return Err(ImageError::StraightLength { routine });
                }
            }
        }
        Ok(())
    }

    fn check_parameters(&self) -> Result<(), ImageError> {
        for call in self.routines.iter().flat_map(|routine| &routine.calls) {
            let at = call.at;
            let target = self.routines.get(call.target.position()).ok_or(ImageError::CallParameters { at })?;
            let returns = target.signature.returns.as_deref().unwrap_or_default();
            if target.signature.mixed || call.inputs != target.signature.receives || call.returns != returns {
                return Err(ImageError::CallParameters { at });
            }
        }
        Ok(())
    }

    /// Routines without calls first, then those whose subroutines are all done; who is left calls in a circle.
    fn check_graph(&mut self) -> Result<(), ImageError> {
        let mut callers: Vec<Vec<usize>> = alloc::vec![Vec::new(); self.routines.len()];
        let mut open: Vec<usize> = Vec::with_capacity(self.routines.len());
        let mut ready = Vec::new();
        for (index, routine) in self.routines.iter().enumerate() {
            open.push(routine.calls.len());
            if routine.calls.is_empty() {
                ready.push(index);
            }
            for call in &routine.calls {
                if let Some(callers) = callers.get_mut(call.target.position()) {
                    callers.push(index);
                }
            }
        }
        while let Some(done) = ready.pop() {
            let Some((length, depth)) = self.routines.get(done).map(|routine| (routine.length, routine.depth)) else {
                continue;
            };
            for caller in callers.get(done).into_iter().flatten() {
                if let (Some(routine), Some(open)) = (self.routines.get_mut(*caller), open.get_mut(*caller)) {
                    routine.length = routine.length.saturating_add(length);
                    routine.depth = routine.depth.max(depth.saturating_add(1));
                    if routine.depth > limits::CALL_DEPTH {
                        return Err(ImageError::CallDepth { routine: RoutineIndex(*caller as u32) });
                    }
                    *open = open.saturating_sub(1);
                    if *open == 0 {
                        ready.push(*caller);
                    }
                }
            }
        }
        match open.iter().position(|open| *open > 0) {
            Some(index) => Err(ImageError::CallCircle { routine: RoutineIndex(index as u32) }),
            None => Ok(()),
        }
    }
}
