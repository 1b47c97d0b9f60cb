//! Dual-channel evaluation in a module whose pair a safety instruction evaluates. 1756-RM093, SIL 2 Safety Inputs.

use twinrung_catalog::Element;

use crate::diagnostic::{Finding, Findings};
use crate::operand::Operand;
use crate::project::{Call, Project, TagKind};
use crate::rules::usage;

rule! {
    /// A pair that both the module and an instruction evaluate.
    "S0407", Error, "the module evaluates a pair that a safety instruction evaluates",
    "Where a safety instruction judges the two channels of a device, its input points are configured as single: a module that evaluates the pair itself shows both as off, and hides every discrepancy from the instruction.",
    "1756-RM093, SIL 2 Safety Inputs; 1734-UM013, Configure the Safety Digital Inputs; dual-channel-inputs.md 1.1",
    good: sample!(modules "  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n  MODULE Doors (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002)\n    POINT I00 (Mode := SAFETY);\n    POINT I01 (Mode := SAFETY);\n  END_MODULE\n"; "    E : DCI_STOP (Class := Safety);\n", "      N: DCS(E,E-STOP,EQUIVALENT - ACTIVE HIGH,500,MANUAL,MANUAL,Doors:I.Pt00Data,Doors:I.Pt01Data,Doors:I.CombinedInputStatus,Doors:I.Pt02Data);\n"),
    bad: sample!(modules "  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n  MODULE Doors (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002)\n    POINT I00 (Mode := SAFETY, Type := EQUIVALENT, DiscrepancyTime := 100);\n    POINT I01 (Mode := SAFETY, Type := EQUIVALENT, DiscrepancyTime := 100);\n  END_MODULE\n"; "    E : DCI_STOP (Class := Safety);\n", "      N: DCS(E,E-STOP,EQUIVALENT - ACTIVE HIGH,500,MANUAL,MANUAL,<<Doors:I.Pt00Data>>,Doors:I.Pt01Data,Doors:I.CombinedInputStatus,Doors:I.Pt02Data);\n")
}

/// The channels of every safety instruction; one finding for each call.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    if !project.modules.iter().any(|module| module.points.iter().any(|point| point.is_dual())) {
        return;
    }
    usage::instructions(project, &mut |_, instruction| {
        let Call::Catalog(declaration) = instruction.call else { return };
        let Some(safety) = declaration.safety else { return };
        for (at, one) in instruction.operands.iter().enumerate() {
            let channel = declaration.operand(at).is_some_and(|operand| safety.decides.contains(&operand.name));
            let Operand::Reference(reference) = project.operand(one.id) else { continue };
            let Some(tag) = reference.base_tag().filter(|_| channel && safety.decides.len() > 1) else { continue };
            let TagKind::ModuleInput(module) = project.tag(tag).kind else { continue };
            let module = &project.modules[module];
            let member = usage::last_member(project, reference);
            let point = module.point_of(&member).filter(|point| point.is_dual());
            let single = reference.element().is_some_and(|element| element != Element::Real);
            if let Some(point) = point.filter(|_| single) {
                let message = format!("{} evaluates a channel that {} evaluates already", declaration.mnemonic, module.name);
                let finding = Finding::new(&CODE, one.span, message).label(point.span, "configured as one of a pair here");
                findings.push(finding.help("set both points to Type := SINGLE"));
                return;
            }
        }
    });
}
