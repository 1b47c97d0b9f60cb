//! Connections whose status nobody reads. 1756-RM093, Table 9; DESIGN 4.

use twinrung_bytecode::image::TypeReference;
use twinrung_grammar::tree::Span;

use crate::diagnostic::{Finding, Findings};
use crate::names::{Map, Set};
use crate::project::{Project, TagClass, TagId, TagKind};
use crate::rules::usage;

rule! {
    /// Input data whose connection nobody watches.
    "W0105", Warning, "the connection behind safety inputs is not watched",
    "When a connection is lost its data reads 0, which is not always the safe value and returns by itself. Read ConnectionFaulted (or RunMode, or a status that a safety instruction takes) of every input connection.",
    "1756-RM093 Table 9; DESIGN 4",
    good: "CONTROLLER Sample (ProcessorType := \"1756-L73S\", Major := 20)\n  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n  MODULE Field_In (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002, RPI := 10) END_MODULE\n  MODULE Field_Out (CatalogNumber := \"1734-OB8S\", Parent := \"Rack\", Slot := 2, SafetyNetwork := 16#0000_0000_0001_0002) END_MODULE\n  TAG\n    Run : BOOL (Class := Safety);\n  END_TAG\n  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n      N: XIC(Field_In:I.Pt00Data)XIO(Field_In:I.ConnectionFaulted)XIO(Field_Out:I.ConnectionFaulted)[OTE(Field_Out:O.Pt00Data) ,OTE(Run) ];\n    END_ROUTINE\n  END_PROGRAM\n  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 20, Priority := 5)\n    Safety_Main;\n  END_TASK\nEND_CONTROLLER\n",
    bad: "CONTROLLER Sample (ProcessorType := \"1756-L73S\", Major := 20)\n  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n  MODULE Field_In (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002, RPI := 10) END_MODULE\n  MODULE Field_Out (CatalogNumber := \"1734-OB8S\", Parent := \"Rack\", Slot := 2, SafetyNetwork := 16#0000_0000_0001_0002) END_MODULE\n  TAG\n    Run : BOOL (Class := Safety);\n  END_TAG\n  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n      N: XIC(<<Field_In:I.Pt00Data>>)XIC(Field_In:I.Muting01Status)XIO(Field_Out:I.ConnectionFaulted)OTE(Field_Out:O.Pt00Data);\n    END_ROUTINE\n  END_PROGRAM\n  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 20, Priority := 5)\n    Safety_Main;\n  END_TASK\nEND_CONTROLLER\n"
}

/// Input and consumed tags of which logic reads data and no status.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    if !project.tags.iter().any(|tag| matches!(tag.kind, TagKind::ModuleInput(_) | TagKind::Consumed)) {
        return;
    }
    let mut used: Map<TagId, Span> = Map::default();
    let mut watched: Set<TagId> = Set::default();
    usage::accesses(project, &mut |access| {
        let Some(id) = access.reference.base_tag() else { return };
        let tag = project.tag(id);
        if !matches!(tag.kind, TagKind::ModuleInput(_) | TagKind::Consumed) || tag.class != TagClass::Safety {
            return;
        }
        if watches_connection(&usage::last_member(project, access.reference)) {
            watched.insert(id);
        } else {
            used.entry(id).or_insert(access.span);
        }
    });
    let mut list: Vec<_> = used.into_iter().filter(|(id, _)| !watched.contains(id)).collect();
    list.sort();
    for (id, span) in list {
        let tag = project.tag(id);
        if !has_status(project, tag.type_reference) {
            continue;
        }
        let message = format!("nobody reads the connection status of `{}`", tag.image_name());
        let help = format!("examine {}.ConnectionFaulted where its data is used", tag.image_name());
        findings.push(Finding::new(&CODE, span, message).help(help));
    }
}

/// Whether a member of a connection's tag tells if the connection, or a point behind it, is sound. The status of a muting lamp,
/// of the power or of a test output does not.
pub fn watches_connection(member: &str) -> bool {
    let name = member.to_ascii_lowercase();
    let of_point = ["pt", "ch"].iter().any(|letters| name.starts_with(letters)) && !name.ends_with("testoutputstatus");
    name == "connectionfaulted"
        || name == "runmode"
        || (name.ends_with("status") && (of_point || name.starts_with("combined")))
}

fn has_status(project: &Project, reference: Option<TypeReference>) -> bool {
    let Some(TypeReference::Structure(index)) = reference else { return false };
    let record = project.types.record(index);
    record.members.iter().any(|member| {
        member.name.eq_ignore_ascii_case("ConnectionFaulted")
            || project.types.predefined(member.type_reference).is_some_and(|one| one.name == "CONNECTION_STATUS")
    })
}
