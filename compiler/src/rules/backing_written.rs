//! Nothing but its own instruction writes a backing tag. dual-channel-inputs.md 1.1.

use twinrung_bytecode::image::TypeReference;
use twinrung_catalog::Opcode;

use crate::diagnostic::{Finding, Findings};
use crate::operand::Shape;
use crate::project::{Call, Project};
use crate::rules::usage;

rule! {
    /// Logic writes a backing tag.
    "S0602", Error, "logic writes the backing tag of a safety instruction",
    "The members of a backing tag belong to its instruction: logic that writes them could switch an output on or hide a fault. Read them; change what the instruction does by its operands.",
    "1756-RM093 Tables 10 and 11; dual-channel-inputs.md 1.1",
    good: sample!("    E : DCI_STOP (Class := Safety);\n    A, B, R, S, Run : BOOL (Class := Safety);\n", "      N: DCS(E,E-STOP,EQUIVALENT - ACTIVE HIGH,500,MANUAL,MANUAL,A,B,S,R);\n      N: XIC(E.O1)OTE(Run);\n"),
    bad: sample!("    E : DCI_STOP (Class := Safety);\n    A, B, R, S, Run : BOOL (Class := Safety);\n", "      N: DCS(E,E-STOP,EQUIVALENT - ACTIVE HIGH,500,MANUAL,MANUAL,A,B,S,R);\n      N: XIC(Run)OTE(<<E.O1>>);\n")
}

/// Writes into backing tags, and copies that reach them.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    let backing = project.types.records().iter().enumerate().any(|(at, _)| {
        project.types.layouts().get(at).is_some_and(|layout| layout.holds_backing)
    });
    if !backing {
        return;
    }
    usage::accesses(project, &mut |access| {
        let call = access.instruction.call;
        let is_own = matches!(call, Call::Catalog(declaration) if declaration.safety.is_some()) && access.operand == 0;
        if is_own {
            return;
        }
        let backs = |reference: &TypeReference| project.types.predefined(*reference).is_some_and(|one| one.backs_one_call);
        let passes = matches!(call.opcode(), Some(Opcode::Jsr | Opcode::Sbr | Opcode::Ret));
        if access.writes && !matches!(call, Call::AddOn(_)) {
            let path = usage::types_on_path(project, access.reference);
            let within = path.split_last().is_some_and(|(_, before)| before.iter().any(backs));
            let whole = access.reference.shape() == Shape::Region
                && usage::holds_safety_backing(project, access.reference.type_reference);
            if within || whole {
                let message = format!("`{}` belongs to a safety instruction and is written by logic", usage::name_of(project, access.reference));
                findings.push(Finding::new(&CODE, access.span, message).help("write a tag of your own; read this one"));
                return;
            }
        }
        if matches!(call, Call::AddOn(_)) && access.writes && access.operand > 0 {
            let path = usage::types_on_path(project, access.reference);
            if path.split_last().is_some_and(|(_, before)| before.iter().any(backs)) {
                let message = format!("`{}` belongs to a safety instruction and is written by logic", usage::name_of(project, access.reference));
                findings.push(Finding::new(&CODE, access.span, message).help("pass a tag of your own"));
            }
        }
        if passes && access.reference.shape() == Shape::Region && !access.writes {
            let holds = match access.reference.type_reference {
                TypeReference::Structure(index) => project.types.layout(index).holds_backing,
                TypeReference::Element(_) => false,
            };
            if holds {
                let message = format!("`{}` cannot be passed: it is, or holds, the tag of an instruction", usage::name_of(project, access.reference));
                findings.push(Finding::new(&CODE, access.span, message).help("pass the members that the routine needs"));
            }
        }
    });
}
