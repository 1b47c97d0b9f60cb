//! Points that a module evaluates as a pair. 1734-UM013, Configure the Safety Digital Inputs; Table 18.

use crate::diagnostic::{Finding, Findings};
use crate::names::Map;
use crate::project::module::point_number;
use crate::project::{Point, Project};

rule! {
    /// Two points of a pair that are not set alike.
    "S0406", Error, "the two points of a pair are not set alike",
    "A module evaluates points in pairs (0 and 1, 2 and 3, ...): both are single, or both have the same dual-channel operation and the same discrepancy time. A point in Mode STANDARD is never one of a dual channel.",
    "1734-UM013, Configure the Safety Digital Inputs and Outputs, Tables 18 and 20",
    good: sample!(modules "  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n  MODULE Doors (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002)\n    POINT I00 (Mode := SAFETY, Type := EQUIVALENT, DiscrepancyTime := 100);\n    POINT I01 (Mode := SAFETY, Type := EQUIVALENT, DiscrepancyTime := 100);\n  END_MODULE\n"; "    Run : BOOL (Class := Safety);\n", "      N: XIC(Doors:I.Pt00Data)OTE(Run);\n"),
    bad: sample!(modules "  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n  MODULE Doors (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002)\n    POINT I00 (Mode := SAFETY, Type := EQUIVALENT, DiscrepancyTime := 100);\n    POINT <<I01>> (Mode := SAFETY);\n  END_MODULE\n"; "    Run : BOOL (Class := Safety);\n", "      N: XIC(Doors:I.Pt00Data)OTE(Run);\n")
}

const OPERATION: [&str; 3] = ["Type", "Channel", "DiscrepancyTime"];

/// Every pair of which both points are set, and every STANDARD point of a dual channel.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    for module in project.modules.iter().filter(|module| !module.known_points().is_empty()) {
        let mut by_number: Map<(char, u32), &Point> = Map::default();
        for point in &module.points {
            if let Some(number) = point_number(&point.name) {
                by_number.entry(number).or_insert(point);
            }
        }
        for point in &module.points {
            if let (true, Some(mode)) = (point.is_dual(), point.setting("Mode"))
                && mode.value.eq_ignore_ascii_case("STANDARD")
            {
                let message = format!("{} is STANDARD and one of a dual channel", point.name);
                let finding = Finding::new(&CODE, mode.value_span, message);
                findings.push(finding.help("set Mode := SAFETY or SAFETY_PULSE_TEST, or Type := SINGLE"));
            }
            let Some((letter, number)) = point_number(&point.name).filter(|(_, number)| number % 2 == 1) else { continue };
            let Some(first) = by_number.get(&(letter, number - 1)).copied() else { continue };
            let differs = OPERATION.into_iter().find(|key| operation(first, key) != operation(point, key));
            if let Some(key) = differs.filter(|_| is_dual(first) || is_dual(point)) {
                let message = format!("{} and {} are a pair and differ in {key}", first.name, point.name);
                let finding = Finding::new(&CODE, point.span, message).label(first.span, "the other point");
                findings.push(finding.help("set both alike, or both to single"));
            }
        }
    }
}

/// Whether a point is one of a pair; an output is, unless it is set to single (Table 20, default).
fn is_dual(point: &Point) -> bool {
    point.is_dual() || (point.name.starts_with('O') && point.setting("Channel").is_none())
}

fn operation(point: &Point, key: &str) -> Option<String> {
    let written = point.setting(key).map(|one| one.value.to_ascii_uppercase().to_string());
    let default = (key == "Channel" && point.name.starts_with('O')).then(|| "DUAL".to_owned());
    written.or(default).filter(|word| word != "SINGLE")
}
