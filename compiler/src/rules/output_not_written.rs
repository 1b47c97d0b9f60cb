//! Safety outputs that nobody writes. DESIGN 4.

use crate::diagnostic::{Finding, Findings};
use crate::names::Set;
use crate::project::{Project, TagClass, TagId, TagKind};
use crate::rules::usage;

rule! {
    /// A safety output that nobody writes.
    "W0104", Warning, "no logic writes a safety output",
    "The module's output tag is never written: its outputs stay off for ever. Write them, or take the module out of the project.",
    "DESIGN 4",
    good: "CONTROLLER Sample (ProcessorType := \"1756-L73S\", Major := 20)\n  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n  MODULE Field_In (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002, RPI := 10) END_MODULE\n  MODULE Field_Out (CatalogNumber := \"1734-OB8S\", Parent := \"Rack\", Slot := 2, SafetyNetwork := 16#0000_0000_0001_0002) END_MODULE\n  TAG\n    Run : BOOL (Class := Safety);\n  END_TAG\n  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n      N: XIC(Field_In:I.Pt00Data)XIO(Field_In:I.ConnectionFaulted)XIO(Field_Out:I.ConnectionFaulted)[OTE(Field_Out:O.Pt00Data) ,OTE(Run) ];\n    END_ROUTINE\n  END_PROGRAM\n  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 20, Priority := 5)\n    Safety_Main;\n  END_TASK\nEND_CONTROLLER\n",
    bad: "CONTROLLER Sample (ProcessorType := \"1756-L73S\", Major := 20)\n  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n  MODULE Field_In (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002, RPI := 10) END_MODULE\n  MODULE <<Field_Out>> (CatalogNumber := \"1734-OB8S\", Parent := \"Rack\", Slot := 2, SafetyNetwork := 16#0000_0000_0001_0002) END_MODULE\n  TAG\n    Run : BOOL (Class := Safety);\n  END_TAG\n  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n      N: XIC(Field_In:I.Pt00Data)XIO(Field_In:I.ConnectionFaulted)XIO(Field_Out:I.ConnectionFaulted)OTE(Run);\n    END_ROUTINE\n  END_PROGRAM\n  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 20, Priority := 5)\n    Safety_Main;\n  END_TASK\nEND_CONTROLLER\n"
}

/// Output tags of safety modules without a writer. What a tag that also resets faults of an input module holds may stay
/// unwritten.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    // Where no safety program is in the file, another file has the logic that writes them.
    if project.programs.is_empty() || !project.tags.iter().any(|tag| matches!(tag.kind, TagKind::ModuleOutput(_))) {
        return;
    }
    let mut written: Set<TagId> = Set::default();
    usage::accesses(project, &mut |access| {
        if let (true, Some(tag)) = (access.writes, access.reference.base_tag()) {
            written.insert(tag);
        }
    });
    for (position, tag) in project.tags.iter().enumerate() {
        let TagKind::ModuleOutput(_) = tag.kind else { continue };
        if tag.class != TagClass::Safety || written.contains(&TagId(position as u32)) || !has_data(project, tag.type_reference) {
            continue;
        }
        let message = format!("no logic writes the safety outputs `{}`", tag.image_name());
        findings.push(Finding::new(&CODE, tag.span, message).help("write them with OTE, or take the module out"));
    }
}

/// Whether a type has output points: members named like data, at any depth.
fn has_data(project: &Project, reference: Option<twinrung_bytecode::image::TypeReference>) -> bool {
    let Some(twinrung_bytecode::image::TypeReference::Structure(index)) = reference else { return true };
    project.types.record(index).members.iter().any(|member| {
        let points = member.name.to_ascii_lowercase().ends_with("data") && !member.name.to_ascii_lowercase().starts_with("test");
        let inner = matches!(member.type_reference, twinrung_bytecode::image::TypeReference::Structure(_));
        points || (inner && has_data(project, Some(member.type_reference)))
    })
}
