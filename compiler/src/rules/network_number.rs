//! Safety network numbers. 1756-RM093, Safety Network Number; neutral-text-and-l5x.md D.3.

use twinrung_grammar::tree::Span;

use crate::diagnostic::{Finding, Findings};
use crate::project::{Module, Project};

rule! {
    /// A safety network number that is none, or is missing.
    "S0409", Error, "a safety network number is malformed or missing",
    "Every safety device has a safety network number: six bytes, in an export 16# and four groups of four hexadecimal digits of which the first is 0000. Either the software makes it from date and time, or a person enters it by hand; it is never all zeros or all ones. Copy the number of the network that the device is on.",
    "1756-RM093, Safety Network Number; neutral-text-and-l5x.md D.3",
    good: sample!(modules "  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n  MODULE Doors (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_41b4_02bb_cb7f) END_MODULE\n"; "    Run : BOOL (Class := Safety);\n", "      N: XIC(Doors:I.Pt00Data)OTE(Run);\n"),
    bad: sample!(modules "  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n  MODULE Doors (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 1, SafetyNetwork := <<16#0001_41b4_02bb_cb7f>>) END_MODULE\n  MODULE <<Gates>> (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 2) END_MODULE\n"; "    Run : BOOL (Class := Safety);\n", "      N: XIC(Doors:I.Pt00Data)OTE(Run);\n")
}

/// The six bytes of a number as it is written; nothing when it is malformed.
pub(crate) fn bytes(text: &str) -> Option<u64> {
    let digits = text.trim().strip_prefix("16#")?;
    let groups: Vec<&str> = digits.split('_').collect();
    let plain: String = groups.concat();
    let shaped = groups.len() == 1 || groups.iter().all(|group| group.len() == 4);
    // Sixteen digits as an export has them, or the twelve of the six bytes.
    if !shaped || !matches!(plain.len(), 12 | 16) {
        return None;
    }
    let value = u64::from_str_radix(&plain, 16).ok()?;
    (value > 0 && value < (1 << 48) - 1).then_some(value)
}

/// Every safety module, and every module that has a number.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    for module in &project.modules {
        match &module.safety_network {
            Some((text, span)) => judge(module, text, *span, findings),
            // An export without the number is a partial one, or of a controller that has it on its ports.
            None if module.safety && module.shown.connections.is_empty() && module.shown.ports.is_empty() => {
                let message = format!("the safety module `{}` has no safety network number", module.name);
                let finding = Finding::new(&CODE, module.span, message);
                findings.push(finding.help("add SafetyNetwork := with the number of the network that it is on"));
            }
            None => {}
        }
    }
}

fn judge(module: &Module, text: &str, span: Span, findings: &mut Findings) {
    // The safety partner of an export has zeros: it is addressed through its controller.
    let unset = text.trim_start_matches("16#").chars().all(|character| matches!(character, '0' | '_'));
    if bytes(text).is_some() || (unset && !module.safety) {
        return;
    }
    let message = format!("`{text}` is no safety network number");
    let finding = Finding::new(&CODE, span, message);
    findings.push(finding.help("write it as 16#0000_xxxx_xxxx_xxxx with hexadecimal digits, neither all zeros nor all ones"));
}
