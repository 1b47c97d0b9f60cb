//! Operands of one instruction that must agree with each other or with the task.

use twinrung_bytecode::image::TypeReference;
use twinrung_catalog::{Element, Opcode, Relation};

use crate::diagnostic::{Finding, Findings};
use crate::operand::{Operand, Shape};
use crate::project::{Call, Instruction, OperandUse, Project};
use crate::rules::usage;

rule! {
    /// Operands that contradict each other.
    "S0605", Error, "operands contradict each other",
    "Some operands of an instruction belong together: the two channels of a safety device are different tags, a time that a mode needs is not 0, SWPB has one type on both sides, SIZE asks for a dimension that the array has.",
    "dual-channel-inputs.md D20 and the relations of the catalog; general-instructions.md A.5, A.6",
    good: sample!("    E : DCI_STOP (Class := Safety);\n    A, B, R, S : BOOL (Class := Safety);\n", "      N: DCS(E,E-STOP,EQUIVALENT - ACTIVE HIGH,500,MANUAL,MANUAL,A,B,S,R);\n"),
    bad: sample!("    E : DCI_STOP (Class := Safety);\n    A, R, S : BOOL (Class := Safety);\n", "      N: DCS(E,E-STOP,EQUIVALENT - ACTIVE HIGH,500,MANUAL,MANUAL,A,<<A>>,S,R);\n")
}

/// Every instruction with such operands.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    if !project.opcodes.any(&[Opcode::Swpb, Opcode::Size]) && !project.opcodes.any_safety() {
        return;
    }
    let period_us = project.safety_task.and_then(|at| project.tasks[at].period_us);
    usage::instructions(project, &mut |_, instruction| {
        let Call::Catalog(declaration) = instruction.call else { return };
        match declaration.opcode {
            Opcode::Swpb => swap(project, instruction, findings),
            Opcode::Size => size(project, instruction, findings),
            _ => {}
        }
        let Some(safety) = declaration.safety else { return };
        let find = |name: &str| -> Option<(&OperandUse, &Operand)> {
            let at = declaration.operands.iter().position(|operand| operand.name == name)?;
            let one = instruction.operands.get(at)?;
            Some((one, project.operand(one.id)))
        };
        let integer = |name: &str| match find(name) {
            Some((one, Operand::Integer { value, .. } | Operand::Choice(value))) => Some((*value, one.span)),
            _ => None,
        };
        let real = |name: &str| match find(name) {
            Some((one, Operand::Real(bits))) => Some((f32::from_bits(*bits), one.span)),
            Some((one, Operand::Integer { value, .. })) => Some((*value as f32, one.span)),
            _ => None,
        };
        for relation in safety.relations {
            match *relation {
                Relation::DifferentTags(first, second) => {
                    let (Some((_, Operand::Reference(a))), Some((one, Operand::Reference(b)))) = (find(first), find(second))
                    else {
                        continue;
                    };
                    if a.location == b.location {
                        // Elements of one array by different variable subscripts: the two may meet.
                        let verb = if a.is_same_data(b) { "are" } else { "may be" };
                        let message = format!("{first} and {second} {verb} the same tag");
                        let help = "wire and name both channels: one channel checks nothing";
                        findings.push(Finding::new(&CODE, one.span, message).help(help));
                    }
                }
                Relation::NotZeroWhen(time, choice, value) => {
                    if let (Some((0, span)), Some((chosen, _))) = (integer(time), integer(choice))
                        && chosen == value {
                            let message = format!("{time} is 0, which the chosen {choice} does not admit");
                            findings.push(Finding::new(&CODE, span, message).help("give it a time"));
                        }
                }
                Relation::BelowUnlessZero(first, second) => {
                    if let (Some((a, span)), Some((b, _))) = (integer(first), integer(second))
                        && b != 0 && a >= b {
                            let message = format!("{first} ({a}) must be below {second} ({b})");
                            findings.push(Finding::new(&CODE, span, message).help("lower the first, or raise the second"));
                        }
                }
                Relation::NotAbove(first, second) => {
                    if let (Some((a, span)), Some((b, _))) = (real(first), real(second))
                        && a > b {
                            let message = format!("{first} ({a}) must not be above {second} ({b})");
                            findings.push(Finding::new(&CODE, span, message).help("exchange them, or correct one"));
                        }
                }
                Relation::PeriodAtMost(limit_ms) => {
                    if let Some((period, span)) = period_us.filter(|(period, _)| *period > u64::from(limit_ms) * 1000) {
                        let message = format!(
                            "{} needs a period of {limit_ms} ms at most; the task has {} ms",
                            declaration.mnemonic,
                            period / 1000
                        );
                        let finding = Finding::new(&CODE, instruction.span, message).label(span, "the period of the task");
                        findings.push(finding.help("shorten the period of the safety task"));
                    }
                }
            }
        }
    });
}

fn swap(project: &Project, instruction: &Instruction, findings: &mut Findings) {
    let element = |at: usize| {
        let reference = instruction.operands.get(at).and_then(|one| project.operand(one.id).reference())?;
        (reference.shape() == Shape::Word).then(|| reference.element()).flatten()
    };
    if element(0).is_none_or(|one| one == Element::Sint) || element(0) != element(2) {
        let span = instruction.operands.get(2).map_or(instruction.span, |one| one.span);
        let message = "SWPB takes INT, DINT or REAL tags, both of one type";
        findings.push(Finding::new(&CODE, span, message).help("give source and destination the same type"));
    }
}

fn size(project: &Project, instruction: &Instruction, findings: &mut Findings) {
    let [source_use, dimension_use, _] = &*instruction.operands else { return };
    let (Some(reference), Operand::Integer { value, .. }) =
        (project.operand(source_use.id).reference(), project.operand(dimension_use.id))
    else {
        return;
    };
    if reference.type_reference == TypeReference::Element(Element::Bool) {
        let message = "SIZE does not count BOOLs";
        findings.push(Finding::new(&CODE, source_use.span, message).help("name an array of numbers or structures"));
        return;
    }
    let sizes = dimensions_of_array(project, reference);
    let exists = usize::try_from(*value).ok().and_then(|at| sizes.get(at).copied()).is_some_and(|size| size > 0);
    if !exists {
        let count = sizes.iter().filter(|size| **size > 0).count();
        let message = format!("dimension {value} of an array of {count} dimensions, which count from 0");
        findings.push(Finding::new(&CODE, dimension_use.span, message).help("name one of its dimensions"));
    }
}

/// Dimensions of the array that a reference is, or is an element of.
pub(crate) fn dimensions_of_array(project: &Project, reference: &crate::operand::Reference) -> [u32; 3] {
    use crate::operand::{Root, Step};
    if reference.dimensions != [0; 3] {
        return reference.dimensions;
    }
    let (mut current, mut dimensions) = match reference.root {
        Root::Tag(tag) => {
            let tag = project.tag(tag);
            (tag.type_reference, tag.dimensions)
        }
        Root::Member(add_on, member) => {
            let index = project.add_on(add_on).instance_type;
            let member = index.and_then(|index| project.types.record(index).members.get(usize::from(member)));
            (member.map(|one| one.type_reference), member.map_or([0; 3], |one| one.dimensions))
        }
        Root::InOut(add_on, parameter) => {
            let parameter = &project.add_on(add_on).parameters[usize::from(parameter)];
            (parameter.type_reference, parameter.dimensions)
        }
    };
    for step in &reference.steps {
        if let (Step::Member(member), Some(TypeReference::Structure(index))) = (step, current)
            && let Some(member) = project.types.record(index).members.get(usize::from(*member)) {
                current = Some(member.type_reference);
                dimensions = member.dimensions;
            }
    }
    dimensions
}
