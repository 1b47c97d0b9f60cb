//! The maker's instruction signature is compared by a person. 1756-RM093 Appendix B.

use twinrung_grammar::tree::{File, Text};

use crate::diagnostic::{Finding, Findings};
use crate::instruction_signature::{MAKER_EDITED, MAKER_ID, MAKER_TIMESTAMP, attribute, safety_add_ons};

rule! {
    /// A signature that only the maker's tool computes.
    "W0130", Warning, "an instruction signature of another tool is not verified here",
    "An export states the instruction signature that the maker's tool has computed. How it does that is not published, so that this tool cannot say whether the content is the sealed one. Compare signature, date and time and the safety instruction signature with those that were recorded; seal the instruction here too (twinrung signature FILE generate NAME, in a .rll), and changes are found from then on.",
    "1756-RM093, Appendix B; neutral-text-and-l5x.md D.8 (decided)",
    good: instruction!(attributes ""),
    bad: instruction!(attributes ", SignatureID := <<16#cae1_ac8c>>, SignatureTimestamp := \"2022-03-01T03:10:25.642Z\"")
}

/// Whether a change is later than a seal: both are of one form, in which later is greater.
fn is_later(edited: &Text, sealed: &Text) -> bool {
    let of_one_form = |one: &Text| one.text.ends_with('Z') && one.text.len() == sealed.text.len();
    of_one_form(edited) && of_one_form(sealed) && edited.text > sealed.text
}

/// Signatures of the maker's tool; a date of change after that of the seal shows that the file was changed by another tool.
pub(crate) fn check(files: &[&File], findings: &mut Findings) {
    for shown in safety_add_ons(files) {
        let [id, sealed, edited] = [MAKER_ID, MAKER_TIMESTAMP, MAKER_EDITED].map(|key| attribute(&shown.attributes, key));
        let Some(id) = id else { continue };
        if let (Some(sealed), Some(edited)) = (sealed, edited)
            && is_later(edited, sealed)
        {
            let message = format!("`{}` was changed {}, after it was sealed {}", shown.name, edited.text, sealed.text);
            let finding = Finding::new(&super::instruction_signature::CODE, edited.span, message);
            findings.push(finding.label(id.span, "the seal").help(super::instruction_signature::WAY_OUT));
            continue;
        }
        let message = format!("`{}` is sealed as {} by another tool", shown.name, id.text);
        let help = "compare signature, date and time with those that were recorded";
        findings.push(Finding::new(&CODE, id.span, message).help(help));
    }
}
