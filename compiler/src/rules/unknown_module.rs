//! Catalogue numbers. DESIGN 4.

use twinrung_catalog::{Controller, modules};

use crate::diagnostic::{Finding, Findings};
use crate::names::closest;
use crate::project::Project;

rule! {
    /// A safety module of which nothing is known.
    "S0408", Error, "a safety module is not known",
    "A module that carries safety data is one of the catalogue, or an export shows its connections and tags. Of this one neither is known: correct the catalogue number, or take the module from an export.",
    "1734-UM013; 1756-RM093 Figure 11 and Appendix G; DESIGN 4",
    good: sample!(modules "  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n  MODULE Doors (CatalogNumber := \"1734-IB8S/B\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002) END_MODULE\n"; "    Run : BOOL (Class := Safety);\n", "      N: XIC(Doors:I.Pt00Data)OTE(Run);\n"),
    bad: sample!(modules "  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n  MODULE <<Doors>> (CatalogNumber := \"1734-IB8X\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002) END_MODULE\n"; "    Run : BOOL (Class := Safety);\n", "      N: OTE(Run);\n")
}

/// Modules with a safety network number and nothing else that is known.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    for module in &project.modules {
        let number = modules::without_series(&module.catalog_number);
        let controller = Controller::by_catalog_number(number).is_some() || number.starts_with("1756-L") || number.starts_with("1768-L");
        let described = modules::Module::by_catalog_number(number);
        let known = described.is_some_and(modules::Module::has_known_tags)
            || modules::CARRIERS.iter().any(|one| one.eq_ignore_ascii_case(number));
        let visible = !module.shown.connections.is_empty() || module.shown.usage != twinrung_grammar::tree::Usage::Target;
        if module.safety_network.is_none() || controller || known || visible || module.name.ends_with(":Partner") {
            continue;
        }
        if let Some(described) = described {
            let number = described.catalog_number;
            let message = format!("the tags of a {number} are known from no source, and nothing shows its connections");
            findings.push(Finding::new(&CODE, module.span, message).help("take the module from an export"));
            continue;
        }
        let message = format!("`{number}` is no known safety module, and nothing shows its connections");
        let finding = Finding::new(&CODE, module.span, message);
        let numbers = modules::ALL.iter().map(|one| one.catalog_number);
        findings.push(match closest(number, numbers) {
            Some(like) => finding.help(format!("did you mean {like}?")),
            None => finding.help("correct the catalogue number, or take the module from an export"),
        });
    }
}
