//! Reading rungs: every mnemonic and operand resolved, what is faulty reported once and left out.

use twinrung_bytecode::limits;
use twinrung_catalog::{Instruction as Declaration, OperandKind};
use twinrung_grammar::tree::{self, CompactString, Span};

pub(crate) use super::context::{Context, Meaning, Mnemonics, Operands, Refusal, RoutineNames};
use super::{AddOnId, Branch, Call, Element, Instruction, OperandId, OperandUse, Rung};
use crate::diagnostic::{DUPLICATE_NAME, EMPTY_RUNG, Finding, Findings, OPERAND_COUNT, OPERAND_MISSING, OVER_LIMIT};
use crate::names::{Map, fold};
use crate::operand::{self, Operand, Scope};
use crate::rules;

/// Reads the rungs of one routine after the other.
pub(crate) struct RungReader<'a, 'c> {
    pub context: &'a Context<'c>,
    pub mnemonics: &'a Mnemonics,
    pub operands: &'a mut Operands,
    pub findings: &'a mut Findings,
    pub scope: Scope,
    /// Labels of the routine that is being read, fold case, as they are spelled where they are defined.
    pub labels: Map<CompactString, (CompactString, Span)>,
    /// Whether the instruction that is being read writes a system value (SSV).
    pub sets_system_value: bool,
    /// Instructions on the rung so far.
    element: u32,
    incomplete: bool,
}

impl<'a, 'c> RungReader<'a, 'c> {
    pub fn new(
        context: &'a Context<'c>,
        mnemonics: &'a Mnemonics,
        operands: &'a mut Operands,
        findings: &'a mut Findings,
        scope: Scope,
    ) -> RungReader<'a, 'c> {
        RungReader {
            context,
            mnemonics,
            operands,
            findings,
            scope,
            labels: Map::default(),
            sets_system_value: false,
            element: 0,
            incomplete: false,
        }
    }

    /// Finds the labels of a routine before its rungs are read: jumps lead forward too.
    pub fn find_labels(&mut self, rungs: &[tree::Rung]) {
        for rung in rungs {
            // A label that stands elsewhere on its rung is refused where it is read.
            let Some(tree::Element::Instruction(first)) = rung.elements.first() else { continue };
            let ([label], true) = (first.operands.as_slice(), first.mnemonic.is("LBL")) else { continue };
            if let Some((_, known)) = self.labels.get(&fold(&label.text)) {
                let message = format!("the label `{}` is defined twice", label.text);
                let finding = Finding::new(&DUPLICATE_NAME, label.span, message).label(*known, "first defined here");
                self.findings.push(finding.help("rename one of the two"));
                continue;
            }
            self.labels.insert(fold(&label.text), (label.text.clone(), label.span));
        }
    }

    /// Reads one rung.
    pub fn rung(&mut self, shown: &tree::Rung) -> Rung {
        self.element = 0;
        self.incomplete = shown.broken;
        let elements = self.series(&shown.elements);
        // Legs without an instruction are no more than none.
        if self.element == 0 && !shown.broken {
            let message = if shown.elements.is_empty() {
                "the rung is empty"
            } else {
                "the rung has branches and no instruction"
            };
            let finding = Finding::new(&EMPTY_RUNG, shown.span, message).help("delete it, or write NOP()");
            self.findings.push(finding);
        }
        if self.element as usize > limits::INSTRUCTIONS_PER_RUNG {
            let message = format!("a rung has at most {} instructions", limits::INSTRUCTIONS_PER_RUNG);
            self.findings.push(Finding::new(&OVER_LIMIT, shown.span, message));
        }
        Rung { elements, kind: shown.kind.value, span: shown.span, incomplete: self.incomplete }
    }

    fn series(&mut self, shown: &[tree::Element]) -> Vec<Element> {
        let mut elements = Vec::with_capacity(shown.len());
        for element in shown {
            match element {
                tree::Element::Instruction(instruction) => {
                    let read = self.instruction(instruction);
                    self.element += 1;
                    match read {
                        Some(instruction) => elements.push(Element::Instruction(instruction)),
                        None => self.incomplete = true,
                    }
                }
                tree::Element::Branch(branch) => {
                    if branch.legs.len() > limits::BRANCH_LEGS {
                        let message = format!("a branch has at most {} legs", limits::BRANCH_LEGS);
                        self.findings.push(Finding::new(&OVER_LIMIT, branch.span, message));
                    }
                    let legs = branch.legs.iter().map(|leg| self.series(&leg.elements)).collect();
                    elements.push(Element::Branch(Branch { legs, span: branch.span }));
                }
            }
        }
        elements
    }

    fn instruction(&mut self, shown: &tree::Instruction) -> Option<Instruction> {
        match self.mnemonics.find(shown.mnemonic.as_str()) {
            Some(Meaning::Catalog(declaration)) => self.catalog_instruction(declaration, shown),
            Some(Meaning::AddOn(add_on)) => self.add_on_call(add_on, shown),
            Some(Meaning::StandardAddOn) => {
                self.findings.push(rules::uncertified::standard_add_on(&shown.mnemonic));
                None
            }
            Some(Meaning::Reported) => None,
            None => {
                let finding = rules::uncertified::finding(self.context, self.mnemonics, &shown.mnemonic);
                self.findings.push(finding);
                None
            }
        }
    }

    fn catalog_instruction(
        &mut self,
        declaration: &'static Declaration,
        shown: &tree::Instruction,
    ) -> Option<Instruction> {
        if let Some(profile) = self.context.profile
            && let Some(finding) = rules::admission::finding(profile, declaration, &shown.mnemonic)
        {
            self.findings.push(finding);
            return None;
        }
        let (least, most) = declaration.operand_count();
        let count = shown.operands.len();
        // `AFI()` is read with one empty operand by some tools, with none by others; the grammar gives none.
        if count < least || most.is_some_and(|most| count > most) || count > limits::OPERANDS_PER_INSTRUCTION {
            let names: Vec<&str> = declaration.operands.iter().map(|operand| operand.name).collect();
            let message = format!("{} has {}, not {count}", declaration.mnemonic, count_text(least, most));
            let help = format!("{}({})", declaration.mnemonic, names.join(", "));
            self.findings.push(Finding::new(&OPERAND_COUNT, shown.span, message).help(help));
            return None;
        }
        self.sets_system_value = declaration.opcode == twinrung_catalog::Opcode::Ssv;
        let mut uses = Vec::with_capacity(count);
        let mut faulty = false;
        let mut inputs: Option<usize> = None;
        for (position, operand) in shown.operands.iter().enumerate() {
            let Some(declared) = declaration.operand(position) else { continue };
            let kind = match (declared.kind, inputs) {
                // Of a JSR's parameters the first `Number of Inputs` are read, the others written.
                (OperandKind::Parameter(_), Some(inputs)) => OperandKind::Parameter(if position < 2 + inputs {
                    twinrung_catalog::Access::Read
                } else {
                    twinrung_catalog::Access::Write
                }),
                (kind, _) => kind,
            };
            match self.operand(kind, declared.name, operand, &uses) {
                Ok(id) => {
                    if kind == OperandKind::InputCount {
                        inputs = match self.operands.table[id.position()] {
                            Operand::Integer { value, .. } => usize::try_from(value).ok(),
                            _ => None,
                        };
                    }
                    uses.push(OperandUse { id, span: operand.span });
                }
                Err(refusal) => {
                    refusal.report(self.findings);
                    faulty = true;
                    if !uses_may_go_on(kind) {
                        return None;
                    }
                }
            }
        }
        if faulty {
            return None;
        }
        self.operands.opcodes.insert(declaration.opcode);
        Some(Instruction {
            call: Call::Catalog(declaration),
            operands: uses.into_boxed_slice(),
            element: self.element,
            span: shown.span,
        })
    }

    fn operand(
        &mut self,
        kind: OperandKind,
        name: &'static str,
        shown: &tree::Operand,
        before: &[OperandUse],
    ) -> Result<OperandId, Refusal> {
        let may_be_empty = matches!(kind, OperandKind::SystemInstance);
        if (shown.is_unassigned() && !matches!(kind, OperandKind::Pseudo(_))) || (shown.is_empty() && !may_be_empty) {
            let message = format!("{name} is missing: the rung is unfinished");
            return Err(Finding::new(&OPERAND_MISSING, shown.span, message)
                .help("enter a tag or a value where it is missing")
                .into());
        }
        operand::read(self, kind, name, shown, before)
    }

    fn add_on_call(&mut self, id: AddOnId, shown: &tree::Instruction) -> Option<Instruction> {
        let add_on = &self.context.add_ons[id.position()];
        let arguments: Vec<usize> =
            (0..add_on.parameters.len()).filter(|position| add_on.parameters[*position].argument).collect();
        if shown.operands.len() > limits::OPERANDS_PER_INSTRUCTION {
            let message = format!("an instruction has at most {} operands", limits::OPERANDS_PER_INSTRUCTION);
            self.findings.push(Finding::new(&OVER_LIMIT, shown.span, message));
            return None;
        }
        if shown.operands.len() != arguments.len() + 1 {
            let names: Vec<&str> = arguments.iter().map(|at| add_on.parameters[*at].name.as_str()).collect();
            let message = format!(
                "{} has {}, not {}",
                add_on.name,
                count_text(arguments.len() + 1, Some(arguments.len() + 1)),
                shown.operands.len()
            );
            let comma = if names.is_empty() { "" } else { ", " };
            let help = format!("{}(tag of type {}{comma}{})", add_on.name, add_on.name, names.join(", "));
            self.findings.push(Finding::new(&OPERAND_COUNT, shown.span, message).help(help));
            return None;
        }
        let mut uses = Vec::with_capacity(shown.operands.len());
        let mut faulty = false;
        for (position, operand) in shown.operands.iter().enumerate() {
            let missing = operand.is_unassigned() || operand.is_empty();
            let outcome = if missing {
                let finding =
                    Finding::new(&OPERAND_MISSING, operand.span, "an argument is missing: the rung is unfinished");
                Err(finding.help("enter a tag or a value where it is missing").into())
            } else if position == 0 {
                operand::read_instance(self, id, operand)
            } else {
                operand::read_argument(self, id, arguments[position - 1], operand)
            };
            match outcome {
                Ok(id) => uses.push(OperandUse { id, span: operand.span }),
                Err(refusal) => {
                    refusal.report(self.findings);
                    faulty = true;
                }
            }
        }
        if faulty {
            return None;
        }
        Some(Instruction {
            call: Call::AddOn(id),
            operands: uses.into_boxed_slice(),
            element: self.element,
            span: shown.span,
        })
    }
}

/// Whether the operands after a faulty one can still be judged by themselves.
fn uses_may_go_on(kind: OperandKind) -> bool {
    !matches!(kind, OperandKind::InputCount | OperandKind::SystemClass | OperandKind::SystemInstance)
}

fn count_text(least: usize, most: Option<usize>) -> String {
    let plural = |count: usize| if count == 1 { "1 operand".to_owned() } else { format!("{count} operands") };
    match most {
        // An instruction has one number of operands, or its last one repeats.
        Some(most) => plural(most),
        None => format!("at least {}", plural(least)),
    }
}
