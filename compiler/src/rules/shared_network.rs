//! Networks that share a number. 1756-RM093, Safety Network Number; When Copying a Safety Project.

use super::network_number::bytes;
use crate::diagnostic::{Finding, Findings};
use crate::project::Project;

rule! {
    /// A network that has the number of another one.
    "S0414", Error, "two networks have one safety network number",
    "The chassis of the controller, and each network behind it, has a safety network number of its own. A controller that produces data for this one has another number than this controller's chassis: where both are alike, the project was copied and its numbers were not changed. After a copy change every number of the copy.",
    "1756-RM093, Safety Network Number; Safety Network Number (SNN) When Copying a Safety Project",
    good: sample!(modules "  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n  MODULE Doors (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002) END_MODULE\n"; "    Run : BOOL (Class := Safety);\n", "      N: XIC(Doors:I.Pt00Data)OTE(Run);\n"),
    bad: sample!(modules "  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n  MODULE Doors (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 1, SafetyNetwork := <<16#0000_0000_0001_0001>>) END_MODULE\n"; "    Run : BOOL (Class := Safety);\n", "      N: XIC(Doors:I.Pt00Data)OTE(Run);\n")
}

/// Every module that is not in the controller's own chassis.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    let own = project.attributes.iter().find(|(key, _)| key == "SafetyNetwork").and_then(|(_, text)| bytes(text));
    let Some(own) = own else { return };
    for module in &project.modules {
        let Some((text, span)) = &module.safety_network else { continue };
        let in_chassis = module.name == "Local" || (module.parent == "Local" && module.shown.address.is_none());
        if in_chassis || bytes(text) != Some(own) {
            continue;
        }
        let message = format!("`{}` has the safety network number of the controller's own chassis", module.name);
        let finding = Finding::new(&CODE, *span, message);
        findings.push(finding.help("give the network that it is on a number of its own"));
    }
}
