//! Dual-channel evaluation in a module whose pair a safety instruction evaluates. 1756-RM093, SIL 2 Safety Inputs.

use twinrung_catalog::Element;
use twinrung_grammar::tree::Span;

use crate::diagnostic::{Finding, Findings};
use crate::project::{Project, TagKind};
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
    let mut reported: Option<Span> = None;
    usage::channels(project, &mut |channel, reference| {
        let call = channel.instruction.span;
        let Some(tag) = reference.base_tag().filter(|_| reported != Some(call)) else { return };
        let TagKind::ModuleInput(module) = project.tag(tag).kind else { return };
        let module = &project.modules[module];
        let member = usage::last_member(project, reference);
        let point = module.point_of(&member).filter(|point| point.is_dual());
        let single = reference.element().is_some_and(|element| element != Element::Real);
        if let Some(point) = point.filter(|_| single) {
            reported = Some(call);
            let message = format!("{} evaluates a channel that {} evaluates already", channel.mnemonic, module.name);
            let finding = Finding::new(&CODE, channel.span, message).label(point.span, "configured as one of a pair here");
            findings.push(finding.help("set both points to Type := SINGLE"));
        }
    });
}
