//! Settings of a module that its catalogue number does not have. 1734-UM013.

use twinrung_catalog::modules::{ConnectionChoice, Module};
use twinrung_grammar::tree::Text;

use crate::diagnostic::Finding;
use crate::names::closest;

rule! {
    /// A setting that the module does not have.
    "S0401", Error, "a module does not have this setting",
    "Which data a safety module sends and takes is chosen from a list, and the members of its tags follow from the choice. Write one of the words of the list, or leave the setting away for the first of them.",
    "1734-UM013, configuration of the connections",
    good: "CONTROLLER Sample (ProcessorType := \"1756-L73S\", Major := 20)\n  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n  MODULE Doors (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002, InputStatus := PT_STATUS) END_MODULE\n  TAG\n    Run : BOOL (Class := Safety);\n  END_TAG\n  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n      N: XIC(Doors:I.Pt00Data)XIC(Doors:I.Pt00Status)OTE(Run);\n    END_ROUTINE\n  END_PROGRAM\n  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 20, Priority := 5)\n    Safety_Main;\n  END_TASK\nEND_CONTROLLER\n",
    bad: "CONTROLLER Sample (ProcessorType := \"1756-L73S\", Major := 20)\n  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n  MODULE Doors (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002, InputStatus := <<PT_STATES>>) END_MODULE\n  TAG\n    Run : BOOL (Class := Safety);\n  END_TAG\n  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n      N: OTE(Run);\n    END_ROUTINE\n  END_PROGRAM\n  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 20, Priority := 5)\n    Safety_Main;\n  END_TASK\nEND_CONTROLLER\n"
}

/// The finding for a word that is not in the list of a choice.
pub(crate) fn choice(module: &Module, key: &str, choices: &'static [ConnectionChoice], word: &Text) -> Finding {
    let message = format!("{key} of the {} is not `{}`", module.catalog_number, word.as_str());
    let finding = Finding::new(&CODE, word.span, message);
    let words = || choices.iter().map(|choice| choice.word);
    match closest(word.as_str(), words()) {
        Some(like) => finding.help(format!("did you mean {like}?")),
        None => finding.help(format!("one of: {}", words().collect::<Vec<_>>().join(", "))),
    }
}
