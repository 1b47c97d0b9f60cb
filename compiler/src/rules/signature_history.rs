//! A signature history has at most six entries. 1756-RM093 Appendix B.

use twinrung_grammar::tree::File;

use crate::diagnostic::{Finding, Findings};
use crate::instruction_signature::{HISTORY_ENTRIES_MAX, safety_add_ons};

rule! {
    /// More entries than a history has.
    "S0802", Error, "a signature history is too long",
    "The signature history of a safety Add-On Instruction holds at most six entries. Remove the oldest ones.",
    "1756-RM093, Appendix B",
    good: instruction!(history "      HISTORY_ENTRY (User := \"A\", Timestamp := \"2026-11-22T18:00:00Z\", Description := \"released\") END_HISTORY_ENTRY\n"),
    bad: instruction!(history "      HISTORY_ENTRY (User := \"A\") END_HISTORY_ENTRY\n      HISTORY_ENTRY (User := \"A\") END_HISTORY_ENTRY\n      HISTORY_ENTRY (User := \"A\") END_HISTORY_ENTRY\n      HISTORY_ENTRY (User := \"A\") END_HISTORY_ENTRY\n      HISTORY_ENTRY (User := \"A\") END_HISTORY_ENTRY\n      HISTORY_ENTRY (User := \"A\") END_HISTORY_ENTRY\n      <<HISTORY_ENTRY (User := \"A\") >>END_HISTORY_ENTRY\n")
}

/// Histories.
pub(crate) fn check(files: &[&File], findings: &mut Findings) {
    for shown in safety_add_ons(files) {
        let Some(seventh) = shown.history.get(HISTORY_ENTRIES_MAX) else { continue };
        let message = format!("`{}` has a signature history of {} entries", shown.name, shown.history.len());
        findings.push(Finding::new(&CODE, seventh.span, message).help("remove the oldest entries"));
    }
}
