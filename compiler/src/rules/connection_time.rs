//! Times of safety connections. 1734-UM013, Configure Safety Connections.

use twinrung_catalog::points::{NETWORK_DELAY_MULTIPLIER, RPI_US, TIMEOUT_MULTIPLIER};
use twinrung_grammar::tree::{Span, Spanned};

use super::period::milliseconds;
use crate::diagnostic::{Finding, Findings};
use crate::project::{Project, TagClass, TagKind};

rule! {
    /// A packet interval or multiplier out of range.
    "S0411", Error, "a time of a safety connection is out of range",
    "The requested packet interval of a safety input or of a consumed tag is 6 to 500 ms; the timeout multiplier 1 to 4; the network delay multiplier 10 to 600 percent. An output connection has the period of the safety task as its interval.",
    "1734-UM013, Configure Safety Connections; DESIGN 4",
    good: sample!(modules "  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n  MODULE Doors (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002, RPI := 6) END_MODULE\n"; "    Run : BOOL (Class := Safety);\n", "      N: XIC(Doors:I.Pt00Data)OTE(Run);\n"),
    bad: sample!(modules "  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n  MODULE Doors (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002, RPI := <<5>>) END_MODULE\n"; "    Run : BOOL (Class := Safety);\n", "      N: XIC(Doors:I.Pt00Data)OTE(Run);\n")
}

/// Every safety module with its connections, and every consumed safety tag.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    for module in project.modules.iter().filter(|module| module.safety) {
        interval(module.shown.rpi_us, findings);
        for connection in &module.shown.connections {
            let kind = connection.connection_type.as_ref().map(|kind| kind.as_str().to_ascii_lowercase()).unwrap_or_default();
            if !kind.starts_with("safety") {
                continue;
            }
            if kind.starts_with("safetyinput") {
                interval(connection.rpi_us, findings);
            }
            multiplier("the timeout multiplier", "", connection.timeout_multiplier, TIMEOUT_MULTIPLIER, findings);
            let delay = connection.network_delay_multiplier;
            multiplier("the network delay multiplier", " %", delay, NETWORK_DELAY_MULTIPLIER, findings);
        }
    }
    for tag in project.tags.iter().filter(|tag| tag.class == TagClass::Safety && matches!(tag.kind, TagKind::Consumed)) {
        let Some(info) = &tag.connection else { continue };
        interval(info.rpi_us, findings);
        multiplier("the timeout multiplier", "", info.timeout_multiplier, TIMEOUT_MULTIPLIER, findings);
        let delay = info.network_delay_multiplier;
        multiplier("the network delay multiplier", " %", delay, NETWORK_DELAY_MULTIPLIER, findings);
    }
}

fn interval(rpi_us: Option<Spanned<u64>>, findings: &mut Findings) {
    let Some(rpi) = rpi_us.filter(|rpi| !(RPI_US.0..=RPI_US.1).contains(&rpi.value)) else { return };
    let message = format!("the requested packet interval is {} ms", milliseconds(rpi.value));
    findings.push(Finding::new(&CODE, rpi.span, message).help("write 6 to 500 ms"));
}

fn multiplier(what: &str, unit: &str, value: Option<Spanned<u32>>, range: (u32, u32), findings: &mut Findings) {
    let Some(value) = value.filter(|value| !(range.0..=range.1).contains(&value.value)) else { return };
    let span: Span = value.span;
    let finding = Finding::new(&CODE, span, format!("{what} is {}{unit}", value.value));
    findings.push(finding.help(format!("write {} to {}{unit}", range.0, range.1)));
}
