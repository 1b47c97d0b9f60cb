//! The verdict: what is shown, what is not, and each floor.

use crate::bench::count;
use crate::html::{self, Cell};
use crate::inject::Group;
use crate::provenance::Provenance;

use super::super::{Evidence, Judged, State};
use super::{build, machine};

/// What no figure of this page shows.
const NOT_SHOWN: [&str; 5] = [
    "That the reference is right: both channels, the judge and the tests were written from one reference.",
    "What neither channel compares: the private state of an instruction, until it changes a value.",
    "Faults that no injection reaches: pointers, lengths, return addresses, a processor that computes wrongly every time, what stands before and behind the controller. The section on independence says what a user must do about each.",
    "That a sample is the whole: intervals are given where something was sampled.",
    "A safety integrity level. This is no certified safety device.",
];

pub(super) fn write(out: &mut String, evidence: &Evidence, here: &Provenance) {
    html::paragraph(out, &format!("Twinrung {}. This page was written on {}.", build(here), machine(here)));
    verdict(out, evidence);
    html::heading(out, 2, "What is demanded, and what was found");
    html::paragraph(
        out,
        "Floors stand in one table of the source, workbench/src/evidence/floors.rs; what is missing counts as not met.",
    );
    html::table(out, &["measured", "demanded", "verdict", "found", "floor from"], evidence.floors.iter().map(row));
    html::heading(out, 2, "What this shows");
    list(out, shown(evidence));
    html::heading(out, 2, "What this does not show");
    list(out, NOT_SHOWN.map(|line| (line.to_owned(), true)));
}

fn verdict(out: &mut String, evidence: &Evidence) {
    let of = |state| evidence.floors.iter().filter(move |judged| judged.state == state).count();
    let all = evidence.floors.len();
    if evidence.is_met {
        html::verdict(out, true, &format!("All {all} floors are met."));
        return;
    }
    html::verdict(
        out,
        false,
        &format!(
            "NOT ENOUGH for a release: of {all} floors {} are met, {} are missed, {} were not measured.",
            of(State::Met),
            of(State::Below),
            of(State::NotMeasured)
        ),
    );
    list(out, evidence.unmet().map(|judged| (format!("{}: {}", judged.what, judged.found), false)));
}

fn row(judged: &Judged) -> Vec<Cell> {
    let verdict = match judged.state {
        State::Met => Cell::Met("met".to_owned()),
        State::Below => Cell::Not("NOT MET".to_owned()),
        State::NotMeasured => Cell::Not("NOT MEASURED".to_owned()),
    };
    let found = if judged.state == State::Met { Cell::text(&judged.found) } else { Cell::Not(judged.found.clone()) };
    vec![Cell::text(judged.what), Cell::text(&judged.demanded), verdict, found, Cell::text(judged.source)]
}

/// What the figures amount to; false where they amount to nothing.
fn shown(evidence: &Evidence) -> Vec<(String, bool)> {
    let absent = |what: &str| (format!("{what}: not measured."), false);
    let campaign = evidence.campaign.as_ref().map_or_else(
        || absent("Whether the channels compute the same"),
        |campaign| {
            let total = &campaign.total;
            let open = evidence.open();
            let verdict = match open {
                0 => "no difference is left open".to_owned(),
                open => format!("{open} differences are OPEN"),
            };
            let ran = total.programs.saturating_sub(total.refused);
            let text = format!(
                "The channels were compared in {} scans of {} generated programs, {} instruction executions in each; {verdict}.",
                count(total.scans),
                count(ran),
                count(total.instructions)
            );
            (text, open == 0)
        },
    );
    let defects = match evidence.defects.guided.measured {
        0 => absent("Whether the fuzzer would find a mistake in one channel"),
        measured => {
            let (found, listed) = (evidence.defects.guided.found, evidence.defects.defects.len());
            let text = format!(
                "Of {listed} mistakes put into one channel on purpose, {measured} were measured and the fuzzer found {found}."
            );
            (text, found == listed)
        }
    };
    let injection = evidence.injection.as_ref().map_or_else(
        || absent("What a fault in the running machine does"),
        |injection| {
            let of = |group, what: &str| match injection.group(group) {
                Some(one) => {
                    format!("of {} faults {what} {} let a wrong output out", count(one.injected), count(one.let_out))
                }
                None => format!("faults {what} were not measured"),
            };
            let right = |group| injection.group(group).is_some_and(|one| one.let_out == 0);
            let channel = of(Group::Channel, "injected in one channel");
            let shared = of(Group::Shared, "injected in what both channels share");
            (format!("Fault injection: {channel}; {shared}."), right(Group::Channel) && right(Group::Shared))
        },
    );
    let scores: Vec<String> =
        evidence.mutants.iter().map(|score| format!("{} {:.1} %", score.run.name, score.now.share * 100.0)).collect();
    let mutants = match scores.is_empty() {
        true => absent("Whether the tests notice a small change"),
        false => {
            let mut floors = evidence.floors.iter().filter(|judged| judged.id.starts_with("mutants."));
            let is_good = floors.all(|judged| judged.state == State::Met);
            (format!("Small changes of the source that the tests notice: {}.", scores.join(", ")), is_good)
        }
    };
    vec![campaign, defects, injection, mutants]
}

fn list(out: &mut String, lines: impl IntoIterator<Item = (String, bool)>) {
    html::list(out, lines.into_iter().map(|(line, is_good)| if is_good { Cell::Text(line) } else { Cell::Not(line) }));
}
