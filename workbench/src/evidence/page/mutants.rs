//! Mutation testing.

use crate::html::{self, Cell};
use crate::inject::Coverage;

use super::super::floors::{MUTATED, MUTATION_SAMPLE};
use super::super::{MutationScore, mutants};
use super::recorded;

pub(super) fn write(out: &mut String, scores: &[MutationScore]) {
    html::heading(out, 2, "Mutation testing");
    html::paragraph(
        out,
        "A mutant is the source with one operator, condition, value or arm changed; tests run on each. The score is the share of mutants that a test notices, or that make one run on and on, among those that compile: with the tests that were there before, and with those of now. The interval is that of Wilson, 95 %; a crate that was mutated as a whole has none.",
    );
    for folder in MUTATED.iter().filter(|folder| mutants::of(scores, folder).is_none()) {
        html::warning(out, &format!("{folder}: not measured."));
    }
    let heads = [
        "crate",
        "mutants",
        "tried",
        "noticed",
        "ran on",
        "do not compile",
        "missed at first",
        "missed now",
        "score at first",
        "score now",
        "commit",
    ];
    html::table(out, &heads, scores.iter().map(row));
    for score in scores {
        let run = &score.run;
        html::heading(out, 3, &run.name);
        if !run.is_enough() {
            html::warning(
                out,
                &format!("The sample of {} viable mutants is smaller than {MUTATION_SAMPLE}.", run.viable()),
            );
        }
        if !run.sample.is_empty() {
            html::paragraph(out, &run.sample);
        }
        html::paragraph(out, &format!("{}. Made again by:", recorded(Some(&run.tool))));
        html::commands(out, [recorded(Some(&run.command)).as_str()]);
        let survivors = score.survivors.iter().map(|survivor| {
            let why = match survivor.why.trim() {
                "" => Cell::Not("no reason given".to_owned()),
                why if survivor.is_argued() => Cell::text(why),
                why => Cell::Not(why.to_owned()),
            };
            vec![Cell::Code(survivor.mutant.clone()), why]
        });
        html::table(out, &["mutant that no test notices", "why nothing has to"], survivors);
        if (score.survivors.len() as u64) < run.missed {
            html::warning(out, &format!("{} missed, and only {} of them named.", run.missed, score.survivors.len()));
        }
    }
}

fn row(score: &MutationScore) -> Vec<Cell> {
    let run = &score.run;
    let shown = |of: Coverage| {
        let interval = match run.is_whole() {
            true => "whole crate".to_owned(),
            false => format!("{:.1} to {:.1} %", of.lower * 100.0, of.upper * 100.0),
        };
        Cell::Number(format!("{:.1} % ({interval})", of.share * 100.0))
    };
    vec![
        Cell::text(&run.name),
        Cell::count(run.of),
        Cell::count(run.tried),
        Cell::count(run.caught),
        Cell::count(run.timeout),
        Cell::count(run.unviable),
        Cell::count(run.missed_first),
        Cell::count(run.missed),
        shown(score.first),
        shown(score.now),
        Cell::Code(recorded(Some(&run.commit))),
    ]
}
