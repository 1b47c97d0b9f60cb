//! The differential campaign, and the differences that were found.

use crate::bench::count;
use crate::fuzz::Run;
use crate::html::{self, Cell, duration};

use super::super::{CampaignEvidence, Difference, Evidence, InstructionCoverage, Share};
use super::recorded;

pub(super) fn write(out: &mut String, evidence: &Evidence) {
    html::heading(out, 2, "Differential campaign");
    match &evidence.campaign {
        None => html::warning(out, "Not measured: there is no report of `twinrung fuzz --report` in evidence/fuzz."),
        Some(campaign) => measured(out, campaign),
    }
    differences(out, &evidence.differences);
}

fn measured(out: &mut String, campaign: &CampaignEvidence) {
    let total = &campaign.total;
    html::paragraph(
        out,
        "Programs that the tool writes itself run on both interpreters, and every value is compared after every scan. Made again by:",
    );
    html::commands(out, ["twinrung fuzz --seed SEED --jobs THREADS --time TIME --report evidence/fuzz/NAME.json"]);
    html::paragraph(
        out,
        "On one thread a seed gives the same campaign; on several the order in which threads reach something new differs, and with it the programs.",
    );
    let per_second = |number: u64| format!("{:.0}", number as f64 / total.seconds.max(f64::EPSILON));
    let processor = match campaign.processor_recorded {
        Share { reached: 0, .. } => "not recorded".to_owned(),
        Share { reached, of } if reached == of => duration(campaign.processor_seconds),
        Share { reached, of } => format!(
            "{} in {reached} of {of} campaigns, not recorded in the others",
            duration(campaign.processor_seconds)
        ),
    };
    let figures = [
        ("campaigns", count(total.seeds.len() as u64)),
        ("time from begin to end", duration(total.seconds)),
        ("threads times that time", duration(total.thread_seconds)),
        ("processor time", processor),
        (
            "programs",
            format!("{}, of which {} were refused by the compiler", count(total.programs), count(total.refused)),
        ),
        ("scans and prescans", count(total.scans)),
        ("rungs executed, by each evaluator", count(total.rungs)),
        ("instruction executions, by each evaluator", count(total.instructions)),
        (
            "in a second",
            format!(
                "{} programs, {} instruction executions",
                per_second(total.programs),
                per_second(total.instructions)
            ),
        ),
        ("ordered pairs of instructions on a rung, the most in one campaign", count(total.instruction_pairs as u64)),
        ("differences reported", count(total.differences.len() as u64)),
    ];
    html::table(
        out,
        &["figure", "all campaigns together"],
        figures.map(|(name, value)| vec![Cell::text(name), Cell::Text(value)]),
    );
    let heads = [
        "seed",
        "guidance",
        "evaluators",
        "programs",
        "differences",
        "begun (UTC)",
        "elapsed",
        "processor time",
        "threads",
        "commit",
    ];
    html::table(out, &heads, total.runs.iter().map(run));
    if total.runs.len() < total.seeds.len() {
        let without = total.seeds.len() - total.runs.len();
        html::warning(
            out,
            &format!("{without} campaigns were run by a release that recorded neither its build nor the machine."),
        );
    }
    coverage(out, campaign);
}

fn run(run: &Run) -> Vec<Cell> {
    let made = &run.provenance;
    let evaluators = if run.judged { "primary, partner, judge" } else { "primary, partner" };
    vec![
        Cell::Number(run.seed.to_string()),
        Cell::text(if run.guided { "guided" } else { "plain" }),
        Cell::text(evaluators),
        Cell::count(run.programs),
        Cell::count(run.differences as u64),
        Cell::Text(recorded(made.begun.as_deref())),
        Cell::Number(duration(made.seconds)),
        Cell::Number(made.processor_seconds.map_or_else(|| "not recorded".to_owned(), duration)),
        Cell::count(made.jobs as u64),
        Cell::Code(recorded(made.commit.as_deref())),
    ]
}

fn coverage(out: &mut String, campaign: &CampaignEvidence) {
    let total = &campaign.total;
    html::heading(out, 3, "What was reached");
    html::paragraph(
        out,
        "For each instruction: its outcomes, each form that each operand admits, each class of values that each operand reads. The reports name what was not reached; what nothing can reach is argued in contest/src/fuzz/coverage/unreachable.rs.",
    );
    let (there, here) = (total.points_reachable, campaign.points_reachable_here);
    match &total.table {
        Some(_) if campaign.unknown() == 0 => {}
        Some(_) => html::warning(
            out,
            &format!(
                "The campaigns knew {there} points of another table than this release, which knows {here}: all of these count as not reached, and the table below says nothing."
            ),
        ),
        None => html::warning(
            out,
            &format!(
                "Which points a campaign knew was not recorded in all reports. They knew {there}, this release knows {here}: the difference of the numbers counts as not reached, and the table below holds if they were the same points."
            ),
        ),
    }
    let missing = total.points_missing.len();
    let reached = total.points_reachable.saturating_sub(missing);
    html::paragraph(
        out,
        &format!(
            "{} of {} points reached, {} not.",
            count(reached as u64),
            count(total.points_reachable as u64),
            count(missing as u64)
        ),
    );
    if missing > 0 {
        html::warning(out, &format!("Not reached: {}.", total.points_missing.join("; ")));
    }
    let share = |share: Share| match share {
        Share { of: 0, .. } => Cell::Number("none".to_owned()),
        Share { reached, of } if reached == of => Cell::Number(format!("{reached}/{of}")),
        Share { reached, of } => Cell::Not(format!("{reached}/{of}: missing")),
    };
    let row = |one: &InstructionCoverage| {
        vec![Cell::Code(one.mnemonic.to_owned()), share(one.outcomes), share(one.forms), share(one.values)]
    };
    html::table(out, &["instruction", "outcomes", "operand forms", "value classes"], campaign.coverage.iter().map(row));
    let reasons =
        campaign.unreachable.iter().map(|(reason, points)| vec![Cell::count(*points as u64), Cell::text(reason)]);
    html::table(out, &["points out of reach", "because"], reasons);
}

fn differences(out: &mut String, differences: &[Difference]) {
    html::heading(out, 3, "Differences found, and what became of them");
    if differences.is_empty() {
        html::warning(out, "Not recorded: there is no evidence/differences.toml, and no report names a difference.");
    }
    let row = |one: &Difference| {
        let named = |text: &str| if text.is_empty() { Cell::Not("not judged".to_owned()) } else { Cell::text(text) };
        let became = match one.is_open() {
            true => Cell::Not("OPEN".to_owned()),
            false => Cell::Text(format!("{}; {}", one.mended, one.kept_by.join("; "))),
        };
        let place = one.report.as_ref().map_or(String::new(), |report| {
            let seed = one.seed.map_or_else(|| "not recorded".to_owned(), |seed| seed.to_string());
            format!(" ({report}, seed {seed}, program {})", one.program.unwrap_or_default())
        });
        vec![Cell::text(&one.what), Cell::Text(format!("{}{place}", one.found_by)), named(&one.wrong), became]
    };
    html::table(
        out,
        &["difference", "found by", "wrong by the reference", "mended, and kept so by"],
        differences.iter().map(row),
    );
}
