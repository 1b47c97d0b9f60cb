//! Unique node references. 1756-RM093, Unique Node Reference.

use twinrung_grammar::tree::{CompactString, Span};

use super::network_number::bytes;
use crate::diagnostic::{Finding, Findings};
use crate::names::Map;
use crate::project::Project;

rule! {
    /// Two devices with one safety network number and one node address.
    "S0410", Error, "two devices have the same safety network number and node address",
    "Safety network number and node address together name a device in the whole routable system; two devices with one name could receive each other's data. Give each network, and each rack, a number of its own, or the device another address.",
    "1756-RM093, Unique Node Reference; neutral-text-and-l5x.md D.10",
    good: sample!(modules "  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n  MODULE Doors (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002) END_MODULE\n  MODULE Gates (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 2, SafetyNetwork := 16#0000_0000_0001_0002) END_MODULE\n"; "    Run : BOOL (Class := Safety);\n", "      N: XIC(Doors:I.Pt00Data)OTE(Run);\n"),
    bad: sample!(modules "  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n  MODULE Rack_2 (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.11\") END_MODULE\n  MODULE Doors (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002) END_MODULE\n  MODULE <<Gates>> (CatalogNumber := \"1734-IB8S\", Parent := \"Rack_2\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002) END_MODULE\n"; "    Run : BOOL (Class := Safety);\n", "      N: XIC(Doors:I.Pt00Data)OTE(Run);\n")
}

/// Every module whose number and address are known.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    let mut seen: Map<(u64, CompactString), (Span, &str)> = Map::default();
    for module in &project.modules {
        let Some(network) = module.safety_network.as_ref().and_then(|(text, _)| bytes(text)) else { continue };
        let address = match (&module.shown.address, module.slot) {
            (Some(address), _) => address.text.to_ascii_lowercase(),
            (None, Some(slot)) => CompactString::from(format!("slot {slot}")),
            (None, None) => continue,
        };
        let known = seen.get(&(network, address.clone())).copied();
        match known {
            Some((span, name)) => {
                let message = format!("`{}` and `{name}` have one safety network number and one address ({address})", module.name);
                let finding = Finding::new(&CODE, module.span, message).label(span, "the other device");
                findings.push(finding.help("give the network or rack of one of them a safety network number of its own"));
            }
            None => {
                seen.insert((network, address), (module.span, &module.name));
            }
        }
    }
}
