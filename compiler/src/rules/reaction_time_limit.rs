//! The connection reaction time limit. 1734-UM013, Configure Safety Connections; neutral-text-and-l5x.md D.3.

use twinrung_catalog::points::TIME_UNIT_US;
use twinrung_grammar::tree::Spanned;

use crate::diagnostic::{Finding, Findings};
use crate::project::Project;

rule! {
    /// A limit that is not what interval and multipliers give.
    "W0116", Warning, "a connection reaction time limit is not what its parameters give",
    "The limit of an input connection is its interval times the timeout multiplier plus the network delay multiplier; that of an output connection has one timeout less. The reaction time of a safety function is computed from it: when the exported limit differs, it was set with other parameters. Set the parameters again and compute the reaction time anew.",
    "1734-UM013, Configure Safety Connections; neutral-text-and-l5x.md D.3 (derived)",
    good: sample!(modules "  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n  MODULE Doors (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002)\n    CONNECTION Safety_In (Type := SafetyInput, Rate := 10000, TimeoutMultiplier := 2, NetworkDelayMultiplier := 200, ReactionTimeLimit := 40.064) END_CONNECTION\n  END_MODULE\n"; "    Run : BOOL (Class := Safety);\n", "      N: XIC(Doors:I.Pt00Data)OTE(Run);\n"),
    bad: sample!(modules "  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n  MODULE Doors (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002)\n    CONNECTION Safety_In (Type := SafetyInput, Rate := 10000, TimeoutMultiplier := 2, NetworkDelayMultiplier := 200, ReactionTimeLimit := <<60.032>>) END_CONNECTION\n  END_MODULE\n"; "    Run : BOOL (Class := Safety);\n", "      N: XIC(Doors:I.Pt00Data)OTE(Run);\n")
}

/// Every safety connection of which all four are shown.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    for connection in project.modules.iter().filter(|module| module.safety).flat_map(|module| &module.shown.connections) {
        let kind = connection.connection_type.as_ref().map(|kind| kind.as_str().to_ascii_lowercase()).unwrap_or_default();
        let timeouts_less = if kind.starts_with("safetyinput") {
            0
        } else if kind.starts_with("safetyoutput") {
            1
        } else {
            continue;
        };
        judge(
            connection.rpi_us,
            connection.timeout_multiplier,
            connection.network_delay_multiplier,
            connection.reaction_time_limit_us,
            timeouts_less,
            findings,
        );
    }
}

fn judge(
    rpi_us: Option<Spanned<u64>>,
    timeout: Option<Spanned<u32>>,
    delay: Option<Spanned<u32>>,
    limit_us: Option<Spanned<u64>>,
    timeouts_less: u64,
    findings: &mut Findings,
) {
    let (Some(rpi), Some(timeout), Some(delay), Some(limit)) = (rpi_us, timeout, delay, limit_us) else { return };
    let timeouts = u64::from(timeout.value).saturating_sub(timeouts_less);
    let percent = timeouts.saturating_mul(100).saturating_add(u64::from(delay.value));
    let expected = rpi.value.saturating_mul(percent) / 100;
    // Rounded to the unit of the protocol, up or down.
    if expected.abs_diff(limit.value) <= TIME_UNIT_US {
        return;
    }
    let text = |value_us: u64| format!("{}.{:03} ms", value_us / 1000, value_us % 1000);
    let message = format!("the limit is {}; interval and multipliers give {}", text(limit.value), text(expected));
    findings.push(Finding::new(&CODE, limit.span, message).help("set the parameters of the connection again"));
}
