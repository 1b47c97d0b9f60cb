//! Test sources of pulse-tested inputs. 1734-UM013, Configure the Safety Digital Inputs.

use twinrung_catalog::modules;

use crate::diagnostic::{Finding, Findings};
use crate::project::Project;

rule! {
    /// A pulse-tested input whose test source does not pulse.
    "S0404", Error, "a pulse-tested input has no test source",
    "An input with Mode SAFETY_PULSE_TEST is fed from a test output of its own module that pulses (T0 and T1 of a 1734-IB8S do unless they are set to something else, all others when they are set to PULSE_TEST). Without it, or with one that does something else, the circuit is not tested and the module reports a fault.",
    "1734-UM013, Configure the Safety Digital Inputs, Tables 18 and 19; 1791ES-UM001 Tables 68 and 69",
    good: sample!(modules "  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n  MODULE Doors (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002)\n    POINT I00 (Mode := SAFETY_PULSE_TEST, TestSource := T0);\n    POINT I01 (Mode := SAFETY_PULSE_TEST, TestSource := T2);\n    TEST T2 (Mode := PULSE_TEST);\n  END_MODULE\n"; "    Run : BOOL (Class := Safety);\n", "      N: XIC(Doors:I.Pt00Data)OTE(Run);\n"),
    bad: sample!(modules "  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n  MODULE Doors (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002)\n    POINT <<I00>> (Mode := SAFETY_PULSE_TEST);\n    POINT I01 (Mode := SAFETY_PULSE_TEST, TestSource := <<T2>>);\n  END_MODULE\n"; "    Run : BOOL (Class := Safety);\n", "      N: XIC(Doors:I.Pt00Data)OTE(Run);\n")
}

/// Every input with a pulse test.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    for module in &project.modules {
        let Some(known) = modules::Module::by_catalog_number(&module.catalog_number) else { continue };
        let tests = known.points.iter().find(|kind| kind.test).map_or(0, |kind| kind.count);
        for point in module.points.iter().filter(|point| point.name.starts_with('I') && point.has("Mode", "SAFETY_PULSE_TEST")) {
            let source = point.setting("TestSource").filter(|one| !one.value.eq_ignore_ascii_case("NONE"));
            let Some(source) = source else {
                let message = format!("{} is pulse-tested and names no test source", point.name);
                findings.push(Finding::new(&CODE, point.span, message).help("add TestSource := T0, as the device is wired"));
                continue;
            };
            let Some(number) = source.value.get(1..).and_then(|digits| digits.parse::<u32>().ok()) else { continue };
            let test = module.point('T', number);
            let mode = test.and_then(|test| test.setting("Mode"));
            let default = if number < known.pulsing_tests { "PULSE_TEST" } else { "NOT_USED" };
            let word = mode.map_or(default, |mode| mode.value.as_str());
            if number >= tests || word.eq_ignore_ascii_case("PULSE_TEST") {
                continue;
            }
            let message = format!("{} takes {} as test source, which is {word}", point.name, source.value);
            let finding = Finding::new(&CODE, source.value_span, message);
            let finding = match mode {
                Some(mode) => finding.label(mode.value_span, "set here"),
                None => finding,
            };
            findings.push(finding.help(format!("set TEST {} (Mode := PULSE_TEST), or name another test source", source.value)));
        }
    }
}
