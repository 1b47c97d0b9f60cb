//! Muting lamps. 1734-UM013 Table 19.

use twinrung_catalog::points::MUTING_LAMPS;
use twinrung_grammar::tree::PointKind;

use crate::diagnostic::{Finding, Findings};
use crate::project::Project;
use crate::project::module::point_number;

rule! {
    /// A muting lamp on a terminal that cannot watch it.
    "S0405", Error, "a muting lamp stands on a test output that cannot watch it",
    "Only T1 and T3 measure the current of a lamp and report a burned-out one. Connect the lamp there.",
    "1734-UM013 Table 19",
    good: sample!(modules "  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n  MODULE Doors (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002)\n    TEST T3 (Mode := MUTING_LAMP);\n  END_MODULE\n"; "    Run : BOOL (Class := Safety);\n", "      N: XIC(Doors:I.Pt00Data)OTE(Run);\n"),
    bad: sample!(modules "  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n  MODULE Doors (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002)\n    TEST T2 (Mode := <<MUTING_LAMP>>);\n  END_MODULE\n"; "    Run : BOOL (Class := Safety);\n", "      N: XIC(Doors:I.Pt00Data)OTE(Run);\n")
}

/// Every test output.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    for point in project.modules.iter().flat_map(|module| &module.points) {
        let Some(mode) = point.setting("Mode").filter(|mode| mode.value.eq_ignore_ascii_case("MUTING_LAMP")) else { continue };
        let watched = point_number(&point.name).is_some_and(|(_, number)| MUTING_LAMPS.contains(&number));
        if point.kind == PointKind::Test && !watched {
            let message = format!("{} cannot watch a muting lamp", point.name);
            findings.push(Finding::new(&CODE, mode.value_span, message).help("connect the lamp to T1 or T3"));
        }
    }
}
