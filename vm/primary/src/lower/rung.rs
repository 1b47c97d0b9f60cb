//! Lowers a body, code by code.

use alloc::collections::BTreeMap;
use alloc::vec::Vec;

use twinrung_bytecode::format;
use twinrung_catalog::{Element, Opcode, Position};

use super::Constants;
use super::cone::Cone;
use super::hazard::{self, Written};
use super::rail::Rails;
use super::schedule::Scheduler;
use super::work::{Resource, Work};
use crate::error::LoadError;
use crate::number::{Binary, narrowed};
use crate::program::{BitNumber, Code, Instruction, NONE, Operand, Program, Range, Single, Step};
use crate::run::{binary, relation};

/// Work in a block after which it ends with the rung: bounds what is scheduled at once, and keeps what a block touches
/// near in memory. The orders of a block are no more than its work, so that they have room in a word beside four flags.
const BLOCK: usize = 1 << 15;
/// Cells that one instruction may touch within a block; what touches more stands alone.
const TOUCHED: usize = 128;

/// What lowering a body needs from outside.
pub(super) struct Around<'a> {
    pub(super) scheduler: &'a mut Scheduler,
    pub(super) constants: &'a mut Constants,
    pub(super) written: &'a Written,
    /// First bit cell behind those that are taken.
    pub(super) first_lasting: u32,
    /// Whether any instruction is an MCR.
    pub(super) overridden: bool,
}

/// A body while it is lowered.
struct Lowering<'a, 'b> {
    program: &'a mut Program,
    around: Around<'b>,
    rails: Rails,
    /// Instructions of the text since the last step.
    instructions: u32,
    order: u32,
    /// Lasting cells of this rung, and the most of any rung.
    lasting: u32,
    most_lasting: u32,
    /// Single steps of this rung.
    singles: Vec<usize>,
    rung: u32,
}

/// Lowers one body; gives the first bit cell behind its lasting ones.
pub(super) fn lower_body(program: &mut Program, index: usize, around: Around<'_>) -> Result<u32, LoadError> {
    let Some(body) = program.bodies.get(index).copied().filter(|body| body.stepped) else {
        return Ok(around.first_lasting);
    };
    let first_lasting = around.first_lasting;
    let first = program.steps.len();
    let mut labels: BTreeMap<u32, Vec<usize>> = BTreeMap::new();
    let end = body.codes.first.saturating_add(body.codes.count);
    // Labels are in the order of the codes, as bodies were built one after the other.
    let from = program.labels.partition_point(|label| label.code < body.codes.first);
    for (position, label) in program.labels.iter().enumerate().skip(from).take_while(|(_, label)| label.code < end) {
        labels.entry(label.code).or_default().push(position);
    }
    let rails = Rails::new(program.zero, program.one);
    let mut lowering = Lowering {
        program,
        around,
        rails,
        instructions: 0,
        order: 0,
        lasting: 0,
        most_lasting: 0,
        singles: Vec::new(),
        rung: 0,
    };
    let rail = (body.of_program && lowering.around.overridden).then_some(lowering.program.rail);
    for position in body.codes.first..end {
        let Some(code) = lowering.program.codes.get(position as usize).copied() else { break };
        match code {
            Code::Rung => {
                if let Some(labels) = labels.get(&position) {
                    lowering.flush();
                    let step = lowering.program.steps.len() as u32;
                    for label in labels {
                        if let Some(label) = lowering.program.labels.get_mut(*label) {
                            label.step = step;
                        }
                    }
                }
                lowering.lasting = 0;
                lowering.rails.begin_rung(rail);
            }
            Code::EndRung => lowering.end_rung(),
            Code::Branch => lowering.rails.open(),
            Code::NextLeg => lowering.rails.next_leg(),
            Code::EndBranch => lowering.rails.close(),
            Code::Instruction(instruction) => lowering.instruction(instruction, position),
            Code::AddOn(_) => lowering.single(position),
        }
    }
    lowering.flush();
    let lasting = first_lasting.saturating_add(lowering.most_lasting);
    let (program, rungs) = (lowering.program, lowering.rung);
    program.steps.push(Step::End { rungs });
    let steps = Range::since(first, &program.steps);
    if let Some(body) = program.bodies.get_mut(index) {
        body.steps = steps;
    }
    if program.steps.len() >= NONE as usize {
        return Err(LoadError::TooLarge("the steps"));
    }
    Ok(lasting)
}

impl Lowering<'_, '_> {
    /// Ends the block: what was collected becomes a step.
    fn flush(&mut self) {
        let block = self.rails.take_block();
        if !block.is_empty() || self.instructions > 0 {
            let runs = self.around.scheduler.schedule(block, &mut self.program.tables);
            self.program.steps.push(Step::Block { runs, instructions: self.instructions });
        }
        self.instructions = 0;
        self.order = 0;
    }

    fn end_rung(&mut self) {
        if !self.singles.is_empty() || self.rails.block.len() > BLOCK {
            self.flush();
        }
        let resume = self.program.steps.len() as u32;
        for single in self.singles.drain(..) {
            if let Some(Step::Single(single)) = self.program.steps.get_mut(single) {
                single.resume = resume;
            }
        }
        self.rung = self.rung.saturating_add(1);
    }

    /// An element that stands alone.
    fn single(&mut self, code: u32) {
        let first = self.around.first_lasting;
        let mut lasting = self.lasting;
        let input = self.rails.freeze(|| {
            let cell = first.saturating_add(lasting);
            lasting = lasting.saturating_add(1);
            cell
        });
        let output = first.saturating_add(lasting);
        self.lasting = lasting.saturating_add(1);
        self.most_lasting = self.most_lasting.max(self.lasting);
        let depth = self.rails.depth() as u32;
        self.flush();
        self.singles.push(self.program.steps.len());
        self.program.steps.push(Step::Single(Single { code, rung: self.rung, input, output, depth, resume: NONE }));
        self.rails.set(output);
    }

    fn instruction(&mut self, index: u32, code: u32) {
        let Some(instruction) = self.program.instructions.get(index as usize).copied() else { return };
        if self.stands_alone(instruction) {
            self.single(code);
            return;
        }
        self.instructions = self.instructions.saturating_add(1);
        let ends_rung = matches!(self.program.codes.get(code.saturating_add(1) as usize), Some(Code::EndRung));
        let first = self.program.operand(instruction.operands, 0);
        let second = self.program.operand(instruction.operands, 1);
        match (instruction.opcode, first, second) {
            (Opcode::Nop | Opcode::Lbl | Opcode::Sbr, ..) => {}
            (Opcode::Afi, ..) => self.rails.push(Cone::FALSE),
            (opcode @ (Opcode::Xic | Opcode::Xio), operand, _) => self.contact(operand, opcode == Opcode::Xio),
            (Opcode::Ote, Operand::Bit(location), _) => self.rails.store_condition(location.bit),
            (opcode @ (Opcode::Otl | Opcode::Otu), Operand::Bit(location), _) => {
                self.rails.latch(location.bit, opcode == Opcode::Otu, ends_rung);
            }
            (Opcode::Ons, Operand::Bit(location), _) => self.rails.one_shot(location.bit),
            (opcode @ (Opcode::Osr | Opcode::Osf), Operand::Bit(storage), Operand::Bit(output))
                if storage.bit != output.bit =>
            {
                self.rails.one_shot_output(storage.bit, output.bit, opcode == Opcode::Osr);
            }
            (opcode @ (Opcode::Ton | Opcode::Tof | Opcode::Rto), Operand::Region { location, .. }, _) => {
                let input = self.rails.materialise();
                for offset in 0..3 {
                    self.rails.protect(location.bit.saturating_add(offset));
                }
                self.program.watched_timers.push(location.word);
                self.rails.block.push(Work::Timer { opcode, input, word: location.word, bit: location.bit });
            }
            _ => {
                if !self.compared(instruction, first, second) && !self.computed(instruction, first, second) {
                    self.general(instruction, index);
                }
            }
        }
    }

    /// Whether an instruction may fault, changes the flow, reads or sets the status out of the usual order, or touches
    /// too much.
    fn stands_alone(&self, instruction: Instruction) -> bool {
        let program = &*self.program;
        let operands = instruction.operands.of(&program.operands);
        let varies = operands.iter().any(|operand| !operand.is_fixed());
        let reads_status = operands
            .iter()
            .any(|operand| matches!(operand, Operand::Status(keyword) if *keyword != format::STATUS_FIRST_SCAN));
        if varies || reads_status {
            return true;
        }
        let [first, second, ..] = [0, 1].map(|index| program.operand(instruction.operands, index));
        match instruction.opcode {
            Opcode::Jmp | Opcode::Jsr | Opcode::Ret | Opcode::Tnd | Opcode::Fal | Opcode::Fsc | Opcode::Ssv => true,
            Opcode::Ton | Opcode::Tof | Opcode::Rto => match first {
                Operand::Region { location, .. } => self.around.written.touches(location.word, 2),
                _ => true,
            },
            Opcode::Cmp | Opcode::Cpt => {
                let expression = if instruction.opcode == Opcode::Cmp { first } else { second };
                match expression {
                    Operand::Expression { formula, overflows, .. } => {
                        (overflows && instruction.opcode == Opcode::Cmp) || self.formula_varies(formula)
                    }
                    _ => true,
                }
            }
            Opcode::Size => match (first, second) {
                (Operand::Integer(size), Operand::Word { element, .. }) => narrowed(size, element).1,
                _ => true,
            },
            Opcode::Fll => {
                !fill_fits(first, second) || self.out_of_array(instruction) || self.touches_too_much(instruction)
            }
            Opcode::Cop | Opcode::Gsv => self.out_of_array(instruction) || self.touches_too_much(instruction),
            _ => self.touches_too_much(instruction),
        }
    }

    fn formula_varies(&self, formula: u32) -> bool {
        use crate::program::FormulaOperation::{Address, Index, LoadAddress};
        let program = &*self.program;
        let range = program.formulas.get(formula as usize).copied().unwrap_or_default();
        let operations = range.of(&program.formula_operations);
        operations.len() > TOUCHED
            || operations.iter().any(|operation| matches!(operation, Address { .. } | Index { .. } | LoadAddress))
    }

    /// Whether a copy or a GSV with fixed operands would run over an array: it faults whenever it is executed.
    fn out_of_array(&self, instruction: Instruction) -> bool {
        let Some(plan) = self.program.copies.get(instruction.extra as usize) else { return true };
        let source_holds = instruction.opcode == Opcode::Fll || plan.source.holds(0, plan.source_length());
        !source_holds || !plan.destination.holds(0, plan.length)
    }

    fn touches_too_much(&self, instruction: Instruction) -> bool {
        let program = &*self.program;
        let cells = (0..instruction.operands.count as usize).fold(0u32, |sum, index| {
            let (bits, words) = hazard::cells(program, instruction, index);
            sum.saturating_add(bits).saturating_add(words)
        });
        cells as usize > TOUCHED
    }

    fn contact(&mut self, operand: Operand, inverted: bool) {
        match operand {
            Operand::Bit(location) => self.rails.push(Cone::literal(location.bit, inverted)),
            Operand::Status(_) => self.rails.push(Cone::literal(self.program.first_scan, inverted)),
            Operand::WordBit { location, number: BitNumber::Constant(bit), .. } => {
                let out = self.rails.signal();
                self.rails.block.push(Work::WordBit { word: location.word, bit, out });
                self.rails.push(Cone::literal(out, inverted));
            }
            // The verifier admits nothing else.
            _ => {}
        }
    }

    /// The cell of an integer operand: its own, or that of a constant.
    fn integer_cell(&mut self, operand: Operand) -> Option<u32> {
        match operand {
            Operand::Word { location, element: Element::Sint | Element::Int | Element::Dint, .. } => {
                Some(location.word)
            }
            Operand::Integer(value) => Some(self.around.constants.cell(value)),
            _ => None,
        }
    }

    /// Comparisons of two integers.
    fn compared(&mut self, instruction: Instruction, first: Operand, second: Operand) -> bool {
        let Some(relation) = relation(instruction.opcode) else { return false };
        let (Some(left), Some(right)) = (self.integer_cell(first), self.integer_cell(second)) else { return false };
        let out = self.rails.signal();
        self.rails.block.push(Work::Compare { relation, left, right, out });
        self.rails.push(Cone::literal(out, false));
        true
    }

    fn next_order(&mut self) -> u32 {
        self.order = self.order.saturating_add(1);
        self.order
    }

    /// Moves and arithmetic between integers into a DINT.
    fn computed(&mut self, instruction: Instruction, first: Operand, second: Operand) -> bool {
        let is_dint = |operand: Operand| match operand {
            Operand::Word { location, element: Element::Dint, .. } => Some(location.word),
            _ => None,
        };
        let third = self.program.operand(instruction.operands, 2);
        let operator = match instruction.opcode {
            Opcode::Mov | Opcode::Clr => {
                let (source, destination) =
                    if instruction.opcode == Opcode::Mov { (first, second) } else { (Operand::Integer(0), first) };
                let (Some(destination), Some(source)) = (is_dint(destination), self.integer_cell(source)) else {
                    return false;
                };
                let input = self.rails.materialise();
                let order = self.next_order();
                self.rails.block.push(Work::Move { input, source, destination, order });
                return true;
            }
            Opcode::Add | Opcode::Sub | Opcode::Mul => binary(instruction.opcode),
            opcode @ (Opcode::And | Opcode::Or | Opcode::Xor) => {
                // SINT and INT would have to be zero-filled.
                let full = |operand: Operand| is_dint(operand).is_some() || matches!(operand, Operand::Integer(_));
                match opcode {
                    _ if !full(first) || !full(second) => None,
                    Opcode::And => Some(Binary::And),
                    Opcode::Or => Some(Binary::Or),
                    _ => Some(Binary::Xor),
                }
            }
            _ => None,
        };
        let (Some(operator), Some(destination)) = (operator, is_dint(third)) else { return false };
        let (Some(left), Some(right)) = (self.integer_cell(first), self.integer_cell(second)) else { return false };
        let input = self.rails.materialise();
        let order = self.next_order();
        self.rails.block.push(Work::Arithmetic { operator, input, left, right, destination, order });
        true
    }

    /// Any other instruction that cannot fault.
    fn general(&mut self, instruction: Instruction, index: u32) {
        let (reads, writes) = self.touched(instruction);
        let declared = instruction.opcode.instruction();
        let is_input = declared.position == Position::Input;
        // A comparison gives what its operands say, whatever the rung; with a false rung it cannot be seen.
        let input =
            if is_input && instruction.opcode != Opcode::Ons { self.program.one } else { self.rails.materialise() };
        for resource in &writes {
            if let Resource::Bit(cell) = resource {
                self.rails.protect(*cell);
            }
        }
        let output = if is_input { self.rails.signal() } else { NONE };
        let order = if affects_status(instruction.opcode) { self.next_order() } else { 0 };
        self.rails.block.push(Work::General { instruction: index, input, output, order, reads, writes });
        match instruction.opcode {
            Opcode::Ons => self.rails.set(output),
            _ if is_input => self.rails.push(Cone::literal(output, false)),
            _ => {}
        }
    }

    fn touched(&self, instruction: Instruction) -> (Vec<Resource>, Vec<Resource>) {
        let program = &*self.program;
        let (mut reads, mut writes) = (Vec::new(), Vec::new());
        if instruction.opcode == Opcode::Mcr {
            reads.push(Resource::Bit(program.rail));
            writes.push(Resource::Bit(program.rail));
        }
        for (position, operand) in instruction.operands.of(&program.operands).iter().enumerate() {
            let mut each = |resource: Resource| {
                // What an instruction may write it may also leave as it is, so it always depends on the value before.
                reads.push(resource);
                if hazard::writes(instruction, position) {
                    writes.push(resource);
                }
            };
            if let Operand::Expression { formula, .. } = operand {
                let range = program.formulas.get(*formula as usize).copied().unwrap_or_default();
                for operation in range.of(&program.formula_operations) {
                    if let crate::program::FormulaOperation::Load { word } = operation {
                        each(Resource::Word(*word));
                    }
                }
            }
            let Some(location) = operand.location() else { continue };
            let (bits, words) = hazard::cells(program, instruction, position);
            for offset in 0..bits {
                each(Resource::Bit(location.bit.saturating_add(offset)));
            }
            for offset in 0..words {
                each(Resource::Word(location.word.saturating_add(offset)));
            }
        }
        (reads, writes)
    }
}

/// Whether FLL's source fits its destination, whatever its value.
fn fill_fits(source: Operand, destination: Operand) -> bool {
    let Operand::Word { element, .. } = destination else { return false };
    match source {
        Operand::Integer(value) => !narrowed(value, element).1,
        Operand::Word { element: from, .. } => {
            from == element || element == Element::Real || (element == Element::Dint && from != Element::Real)
        }
        _ => false,
    }
}

/// Whether an instruction clears the arithmetic status and sets it anew.
fn affects_status(opcode: Opcode) -> bool {
    matches!(
        opcode,
        Opcode::Mov
            | Opcode::Mvm
            | Opcode::Clr
            | Opcode::And
            | Opcode::Or
            | Opcode::Xor
            | Opcode::Not
            | Opcode::Add
            | Opcode::Sub
            | Opcode::Mul
            | Opcode::Div
            | Opcode::Mod
            | Opcode::Sqr
            | Opcode::Neg
            | Opcode::Abs
            | Opcode::Cpt
    )
}
