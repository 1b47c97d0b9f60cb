//! Tags connected to other controllers. 1756-RM093, produced and consumed safety tags.

use twinrung_bytecode::image::TypeReference;

use crate::diagnostic::{Finding, Findings};
use crate::project::{Project, TagClass, TagKind, TagScope};

rule! {
    /// A produced or consumed tag without a connection status.
    "S0402", Error, "a produced or consumed safety tag is not what it must be",
    "A produced or consumed safety tag belongs to the controller and has a user-defined type whose first member is a CONNECTION_STATUS: without it nobody sees that the connection is lost.",
    "1756-RM093, Produced and Consumed Safety Tags; neutral-text-and-l5x.md D.3",
    good: "CONTROLLER Sample (ProcessorType := \"1756-L73S\", Major := 20)\n  DATATYPE Line_T\n    CONNECTION_STATUS Status;\n    BOOL Stop;\n  END_DATATYPE\n  DATATYPE Bare_T\n    BOOL Stop;\n  END_DATATYPE\n  TAG\n    Run : BOOL (Class := Safety);\n    Line : Line_T (Class := Safety, Produced := 1, RPI := 20);\n  END_TAG\n  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n      N: XIC(Run)OTE(Line.Stop);\n    END_ROUTINE\n  END_PROGRAM\n  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 20, Priority := 5)\n    Safety_Main;\n  END_TASK\nEND_CONTROLLER\n",
    bad: "CONTROLLER Sample (ProcessorType := \"1756-L73S\", Major := 20)\n  DATATYPE Line_T\n    CONNECTION_STATUS Status;\n    BOOL Stop;\n  END_DATATYPE\n  DATATYPE Bare_T\n    BOOL Stop;\n  END_DATATYPE\n  TAG\n    Run : BOOL (Class := Safety);\n    Line : <<Bare_T>> (Class := Safety, Produced := 1, RPI := 20);\n  END_TAG\n  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n      N: XIC(Run)OTE(Line.Stop);\n    END_ROUTINE\n  END_PROGRAM\n  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 20, Priority := 5)\n    Safety_Main;\n  END_TASK\nEND_CONTROLLER\n"
}

/// Produced and consumed safety tags.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    for tag in project.tags.iter().filter(|tag| tag.class == TagClass::Safety) {
        let word = match tag.kind {
            TagKind::Produced => "produced",
            TagKind::Consumed => "consumed",
            _ => continue,
        };
        if tag.scope != TagScope::Controller {
            let message = format!("the {word} tag `{}` belongs to a program", tag.name);
            findings.push(Finding::new(&CODE, tag.span, message).help("declare it in the controller"));
        }
        let Some(reference) = tag.type_reference else { continue };
        let first = match reference {
            TypeReference::Structure(index) => project.types.record(index).members.first(),
            TypeReference::Element(_) => None,
        };
        let begins = first.is_some_and(|member| {
            member.dimensions == [0; 3]
                && project.types.predefined(member.type_reference).is_some_and(|one| one.name == "CONNECTION_STATUS")
        });
        if !begins {
            let message = format!("the type of the {word} tag `{}` does not begin with a CONNECTION_STATUS", tag.name);
            let help = "make a type whose first member is CONNECTION_STATUS, and watch that member";
            findings.push(Finding::new(&CODE, tag.type_span, message).help(help));
        }
    }
}
