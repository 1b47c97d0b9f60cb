//! Times behind two-hand instructions. v14-and-metal-form.md 3.3; dual-channel-inputs.md 10.1.

use twinrung_catalog::{Opcode, Relation};
use twinrung_grammar::tree::Spanned;

use crate::diagnostic::{Finding, Findings};
use crate::operand::Operand;
use crate::project::{Call, Project, TagId, TagKind};
use crate::rules::period::milliseconds;
use crate::rules::usage;

rule! {
    /// A safety task or an input connection that is too slow for two hands.
    "W0123", Warning, "a two-hand station is read too slowly",
    "THRS and THRSe judge whether both buttons are pressed within 500 ms of each other. Seen through a safety task above 40 ms or an input connection above 20 ms, presses that are further apart can pass, and good ones can be refused. Shorten the period of the safety task, and the requested packet interval of the module that the buttons are wired to. (For THRSe a longer period is refused by S0605.)",
    "dual-channel-inputs.md 10.1 (THRSe); v14-and-metal-form.md 3.3 (THRS, by analogy)",
    good: concat!("CONTROLLER Sample (ProcessorType := \"1756-L73S\", Major := 20, SafetyNetwork := 16#0000_0000_0001_0001)\n  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n",
        "  MODULE Press (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002, RPI := 20) END_MODULE\n",
        "  TAG\n    Hands : TWO_HAND_RUN_STATION (Class := Safety);\n    Reset : BOOL (Class := Safety);\n  END_TAG\n  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n",
        "      N: THRS(Hands,DISABLED,0,Press:I.Pt00Data,Press:I.Pt01Data,Press:I.Pt02Data,Press:I.Pt03Data,Reset);\n    END_ROUTINE\n  END_PROGRAM\n",
        "  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 40, Watchdog := 20, Priority := 5)\n    Safety_Main;\n  END_TASK\nEND_CONTROLLER\n"),
    bad: concat!("CONTROLLER Sample (ProcessorType := \"1756-L73S\", Major := 20, SafetyNetwork := 16#0000_0000_0001_0001)\n  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n",
        "  MODULE Press (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002, RPI := 21) END_MODULE\n",
        "  TAG\n    Hands : TWO_HAND_RUN_STATION (Class := Safety);\n    Reset : BOOL (Class := Safety);\n  END_TAG\n  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n",
        "      N: THRS(<<Hands>>,DISABLED,0,<<Press:I.Pt00Data>>,Press:I.Pt01Data,Press:I.Pt02Data,Press:I.Pt03Data,Reset);\n    END_ROUTINE\n  END_PROGRAM\n",
        "  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 41, Watchdog := 20, Priority := 5)\n    Safety_Main;\n  END_TASK\nEND_CONTROLLER\n")
}

const TWO_HAND: [Opcode; 2] = [Opcode::Thrs, Opcode::Thrse];
/// Greatest interval of the connection that brings the contacts, in µs.
const INTERVAL_US: u64 = 20_000;

/// Every call of THRS and THRSe.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    if !project.opcodes.any(&TWO_HAND) {
        return;
    }
    let period = project.safety_task.and_then(|at| project.tasks[at].period_us);
    usage::instructions(project, &mut |_, instruction| {
        let Call::Catalog(declaration) = instruction.call else { return };
        let Some(safety) = declaration.safety.filter(|_| TWO_HAND.contains(&declaration.opcode)) else { return };
        // Where the declaration itself has the limit, S0605 judges it.
        let judged = safety.relations.iter().any(|one| matches!(one, Relation::PeriodAtMost(_)));
        let limit_us = u64::from(period_limit_ms()) * 1000;
        if let (Some((period_us, span)), Some(backing)) = (period, instruction.operands.first())
            && period_us > limit_us
            && !judged
        {
            let message = format!(
                "{} needs a period of {} ms at most; the task has {} ms",
                declaration.mnemonic,
                limit_us / 1000,
                milliseconds(period_us)
            );
            let finding = Finding::new(&CODE, backing.span, message).label(span, "the period of the task");
            findings.push(finding.help("shorten the period of the safety task"));
        }
        let mut told: Vec<TagId> = Vec::new();
        for (declared, one) in declaration.operands.iter().zip(&instruction.operands) {
            let Operand::Reference(reference) = project.operand(one.id) else { continue };
            let contact = safety.channels.contains(&declared.name);
            let Some(tag) = reference.base_tag().filter(|tag| contact && !told.contains(tag)) else { continue };
            let Some(interval) = interval(project, tag).filter(|interval| interval.value > INTERVAL_US) else { continue };
            told.push(tag);
            let message = format!(
                "{} needs its contacts every {} ms at least; `{}` brings them every {} ms",
                declaration.mnemonic,
                INTERVAL_US / 1000,
                project.tag(tag).name,
                milliseconds(interval.value)
            );
            let finding = Finding::new(&CODE, one.span, message).label(interval.span, "the requested packet interval");
            findings.push(finding.help("set the interval of the connection to 20 ms or less"));
        }
    });
}

/// The period limit that the catalogue declares for THRSe.
fn period_limit_ms() -> u32 {
    let relations = Opcode::Thrse.instruction().safety.map_or(&[][..], |safety| safety.relations);
    let limit = relations.iter().find_map(|one| match one {
        Relation::PeriodAtMost(limit_ms) => Some(*limit_ms),
        _ => None,
    });
    limit.unwrap_or(u32::MAX)
}

/// How often a tag is brought from outside, where that is known.
fn interval(project: &Project, tag: TagId) -> Option<Spanned<u64>> {
    let tag = project.tag(tag);
    match tag.kind {
        TagKind::ModuleInput(module) => {
            let shown = &project.modules[module].shown;
            let of_connections = shown.connections.iter().find(|connection| {
                let kind = connection.connection_type.as_ref();
                kind.is_some_and(|kind| kind.as_str().to_ascii_lowercase().starts_with("safetyinput"))
            });
            of_connections.and_then(|connection| connection.rpi_us).or(shown.rpi_us)
        }
        TagKind::Consumed => tag.connection.as_ref().and_then(|info| info.rpi_us),
        _ => None,
    }
}
