//! Muting lamps. 1734-UM013 Table 19; 1791ES-UM001 Table 69.

use twinrung_catalog::modules::Module;
use twinrung_grammar::tree::PointKind;

use crate::diagnostic::{Finding, Findings};
use crate::project::Project;
use crate::project::module::point_number;

rule! {
    /// A muting lamp on a terminal that cannot watch it.
    "S0405", Error, "a muting lamp stands on a test output that cannot watch it",
    "Only some terminals measure the current of a lamp and report a burned-out one: T1 and T3 of a 1734-IB8S, T3, T7 and T11 of Guard I/O as far as a module has them. Connect the lamp there.",
    "1734-UM013 Table 19; 1791ES-UM001 Table 69",
    good: sample!(modules "  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n  MODULE Doors (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002)\n    TEST T3 (Mode := MUTING_LAMP);\n  END_MODULE\n"; "    Run : BOOL (Class := Safety);\n", "      N: XIC(Doors:I.Pt00Data)OTE(Run);\n"),
    bad: sample!(modules "  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n  MODULE Doors (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002)\n    TEST T2 (Mode := <<MUTING_LAMP>>);\n  END_MODULE\n"; "    Run : BOOL (Class := Safety);\n", "      N: XIC(Doors:I.Pt00Data)OTE(Run);\n")
}

/// Every test output.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    for module in &project.modules {
        let Some(known) = Module::by_catalog_number(&module.catalog_number) else { continue };
        for point in module.points.iter().filter(|point| point.kind == PointKind::Test) {
            let mode = point.setting("Mode").filter(|mode| mode.value.eq_ignore_ascii_case("MUTING_LAMP"));
            let watched = point_number(&point.name).is_some_and(|(_, number)| known.muting_lamps.contains(&number));
            if let Some(mode) = mode.filter(|_| !watched) {
                let message = format!("{} of the {} cannot watch a muting lamp", point.name, known.catalog_number);
                let terminals: Vec<String> = known.muting_lamps.iter().map(|number| format!("T{number}")).collect();
                let help = format!("connect the lamp to {}", terminals.join(" or "));
                findings.push(Finding::new(&CODE, mode.value_span, message).help(help));
            }
        }
    }
}
