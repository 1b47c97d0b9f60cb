//! Input tags that logic writes. 1756-RM093 Appendix F; general-instructions.md A.1.

use crate::diagnostic::{Finding, Findings};
use crate::project::{Project, TagKind};
use crate::rules::usage;

rule! {
    /// Logic writes an input tag.
    "W0111", Note, "logic writes an input tag",
    "The next scan's frozen inputs overwrite what is written here. The ladders of Appendix F do it on purpose, to hold inputs at 0 while a fault is latched.",
    "1756-RM093 Appendix F; general-instructions.md A.1",
    good: "CONTROLLER Sample (ProcessorType := \"1756-L73S\", Major := 20)\n  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n  MODULE Field_In (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002, RPI := 10) END_MODULE\n  MODULE Field_Out (CatalogNumber := \"1734-OB8S\", Parent := \"Rack\", Slot := 2, SafetyNetwork := 16#0000_0000_0001_0002) END_MODULE\n  TAG\n    Run : BOOL (Class := Safety);\n  END_TAG\n  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n      N: XIC(Field_In:I.Pt00Data)XIO(Field_In:I.ConnectionFaulted)XIO(Field_Out:I.ConnectionFaulted)[OTE(Field_Out:O.Pt00Data) ,OTE(Run) ];\n    END_ROUTINE\n  END_PROGRAM\n  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 20, Priority := 5)\n    Safety_Main;\n  END_TASK\nEND_CONTROLLER\n",
    bad: "CONTROLLER Sample (ProcessorType := \"1756-L73S\", Major := 20)\n  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n  MODULE Field_In (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002, RPI := 10) END_MODULE\n  MODULE Field_Out (CatalogNumber := \"1734-OB8S\", Parent := \"Rack\", Slot := 2, SafetyNetwork := 16#0000_0000_0001_0002) END_MODULE\n  TAG\n    Run : BOOL (Class := Safety);\n  END_TAG\n  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n      N: XIC(Field_In:I.ConnectionFaulted)OTU(<<Field_In:I.Pt00Data>>);\n    END_ROUTINE\n  END_PROGRAM\n  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 20, Priority := 5)\n    Safety_Main;\n  END_TASK\nEND_CONTROLLER\n"
}

/// Writes to tags of input modules.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    if !project.tags.iter().any(|tag| matches!(tag.kind, TagKind::ModuleInput(_))) {
        return;
    }
    usage::accesses(project, &mut |access| {
        let Some(id) = access.reference.base_tag().filter(|_| access.writes) else { return };
        let tag = project.tag(id);
        if matches!(tag.kind, TagKind::ModuleInput(_)) {
            let message = format!("`{}` is an input: the next scan overwrites it", usage::name_of(project, access.reference));
            findings.push(Finding::new(&CODE, access.span, message).help("nothing to mend where it is meant as in Appendix F"));
        }
    });
}
