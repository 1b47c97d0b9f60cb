//! An instruction that safety logic may not hold. 1756-RM093 Tables 10 to 12.

use twinrung_grammar::tree::Name;

use crate::diagnostic::Finding;
use crate::names::closest;
use crate::project::reading::{Context, Mnemonics};

rule! {
    /// An instruction that is not certified.
    "S0101", Error, "an instruction is not certified for safety",
    "Safety logic holds the instructions of Tables 10 to 12 of the safety reference manual and safety Add-On Instructions, and nothing else: everything else is untested for this use. Replace it by a certified one, or move the work to a standard task and bring the result in through the tag map.",
    "1756-RM093 Appendix A, Tables 10-12",
    good: sample!("    A, B : DINT (Class := Safety);\n", "      N: MOV(A,B);\n"),
    bad: sample!("    A, B : DINT (Class := Safety);\n", "      N: <<BTD>>(A,0,B,4,8);\n")
}

/// The finding for a mnemonic that means nothing admitted.
pub(crate) fn finding(context: &Context<'_>, mnemonics: &Mnemonics, mnemonic: &Name) -> Finding {
    let message = format!("{mnemonic} is not certified for safety logic");
    let finding = Finding::new(&CODE, mnemonic.span, message);
    let like = context.suggest(|| closest(mnemonic.as_str(), mnemonics.names()).map(str::to_ascii_uppercase));
    // A suggestion is one for a slip of the pen, not for another instruction that exists.
    match like.filter(|_| !is_known(mnemonic.as_str())) {
        Some(like) => finding.help(format!("did you mean {like}?")),
        None => finding.help("replace it by a certified instruction, or compute the value in a standard task and map the tag"),
    }
}

/// The finding for an Add-On Instruction of class Standard.
pub(crate) fn standard_add_on(mnemonic: &Name) -> Finding {
    let message = format!("{mnemonic} is an Add-On Instruction of class Standard");
    Finding::new(&CODE, mnemonic.span, message)
        .help("declare it with Class := Safety; its own logic is then held to the safety rules")
}

/// Whether this is an instruction of standard logic that safety logic may not hold, of those that exports show most.
pub fn is_known(mnemonic: &str) -> bool {
    const KNOWN: [&str; 60] = [
        "ABL", "ACB", "ACL", "ACS", "AHL", "ALMA", "ALMD", "ARD", "ARL", "ASN", "ATN", "AVE", "AWA", "AWT", "BSL", "BSR",
        "BTD", "CONCAT", "COS", "CPS", "DDT", "DEG", "DELETE", "DTOS", "DTR", "FBC", "FFL", "FFU", "FIND", "FOR", "BRK",
        "FRD", "INSERT", "IOT", "LFL", "LFU", "LN", "LOG", "LOWER", "MID", "MSG", "PID", "RAD", "RTOS", "SFP", "SFR",
        "SIN", "SQI", "SQL", "SQO", "SRT", "STD", "STOD", "STOR", "TAN", "TOD", "TRN", "UID", "UPPER", "XPY",
    ];
    KNOWN.iter().any(|known| known.eq_ignore_ascii_case(mnemonic))
}
