//! The producing controller of a consumed safety tag. 1756-RM093, Safety Network Number for Safety Consumed Tags.

use twinrung_grammar::tree::CompactString;

use super::network_number::bytes;
use crate::diagnostic::{Finding, Findings};
use crate::names::{Map, fold};
use crate::project::{Module, Project, TagClass, TagKind};

rule! {
    /// A consumed safety tag whose producer has no safety network number here.
    "S0413", Error, "the producer of a consumed safety tag has no safety network number",
    "A consumed safety tag comes from a controller that stands in the I/O tree with its safety network number, copied from its own project. Without it the connection is not made, or would be made with another controller of the same address.",
    "1756-RM093, Safety Network Number (SNN) for Safety Consumed Tags",
    good: concat!("CONTROLLER Sample (ProcessorType := \"1756-L73S\", Major := 20, SafetyNetwork := 16#0000_0000_0001_0001)\n  DATATYPE Link_T\n    CONNECTION_STATUS Status;\n    BOOL Stop;\n  END_DATATYPE\n  MODULE Other (CatalogNumber := \"1756-L73S\", Parent := \"Local\", Slot := 3, SafetyNetwork := 16#0000_0000_0001_0003) END_MODULE\n",
        "  TAG\n    Link : Link_T (Class := Safety, Producer := Other, RemoteTag := \"Link\", RPI := 20);\n    Run : BOOL (Class := Safety);\n  END_TAG\n  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n      N: XIC(Link.Stop)XIO(Link.Status.ConnectionFaulted)OTE(Run);\n    END_ROUTINE\n  END_PROGRAM\n  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 20, Priority := 5)\n    Safety_Main;\n  END_TASK\nEND_CONTROLLER\n"),
    bad: concat!("CONTROLLER Sample (ProcessorType := \"1756-L73S\", Major := 20, SafetyNetwork := 16#0000_0000_0001_0001)\n  DATATYPE Link_T\n    CONNECTION_STATUS Status;\n    BOOL Stop;\n  END_DATATYPE\n  MODULE Other (CatalogNumber := \"1756-L73S\", Parent := \"Local\", Slot := 3) END_MODULE\n",
        "  TAG\n    Link : Link_T (Class := Safety, Producer := <<Other>>, RemoteTag := \"Link\", RPI := 20);\n    Run : BOOL (Class := Safety);\n  END_TAG\n  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n      N: XIC(Link.Stop)XIO(Link.Status.ConnectionFaulted)OTE(Run);\n    END_ROUTINE\n  END_PROGRAM\n  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 20, Priority := 5)\n    Safety_Main;\n  END_TASK\nEND_CONTROLLER\n")
}

/// Every consumed safety tag of a whole project.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    let mut modules: Map<CompactString, &Module> = Map::default();
    for module in &project.modules {
        modules.entry(fold(&module.name)).or_insert(module);
    }
    for tag in project.tags.iter().filter(|tag| tag.class == TagClass::Safety && matches!(tag.kind, TagKind::Consumed)) {
        let Some(producer) = tag.connection.as_ref().and_then(|info| info.producer.as_ref()) else { continue };
        let Some(module) = modules.get(&fold(producer.as_str())) else {
            // A partial export has no I/O tree, and what stands in a text alone may have none yet.
            continue;
        };
        if module.safety_network.as_ref().is_some_and(|(text, _)| bytes(text).is_some()) {
            continue;
        }
        let message = format!("`{}` comes from `{}`, which has no safety network number", tag.name, module.name);
        let finding = Finding::new(&CODE, producer.span, message).label(module.span, "declared here");
        findings.push(finding.help("add its SafetyNetwork, copied from the producing controller's project"));
    }
}
