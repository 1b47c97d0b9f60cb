//! Fault injection.

use crate::bench::count;
use crate::html::{self, Cell};
use crate::inject::{Group, classes_table, groups_table, mechanisms_table};

use super::super::InjectionEvidence;

pub(super) fn write(out: &mut String, evidence: Option<&InjectionEvidence>) {
    html::heading(out, 2, "Fault injection");
    let Some(evidence) = evidence else {
        html::warning(out, "Not measured: there is no report of `twinrung inject --report` in evidence/inject.");
        return;
    };
    html::paragraph(
        out,
        "One thing goes wrong at a time while a sample runs, and what becomes of it is compared with the run in which nothing is wrong. Diagnostic coverage is the share that was detected or only switched off, among those that a run showed (neither masked nor latent). Made again by, for each project:",
    );
    html::commands(
        out,
        [
            "twinrung inject PROJECT --injections N --seed SEED --group channel,shared --report evidence/inject/NAME.json",
            "twinrung inject PROJECT --injections N --seed SEED --group residual --report evidence/inject/NAME-residual.json",
        ],
    );
    groups_table(out, &evidence.groups);
    for group in
        [Group::Channel, Group::Shared, Group::Residual].into_iter().filter(|group| evidence.group(*group).is_none())
    {
        html::warning(out, &format!("Group {}: not measured.", group.name()));
    }
    if !evidence.not_reported.is_empty() {
        html::warning(out, &format!("Samples into which nothing was injected: {}.", evidence.not_reported.join(", ")));
    }
    if !evidence.not_injected.is_empty() {
        html::warning(out, &format!("Classes of which no fault was injected: {}.", evidence.not_injected.join(", ")));
    }
    html::heading(out, 3, "By project");
    let heads = [
        "project",
        "safety application",
        "inputs",
        "seed",
        "scans",
        "followed",
        "group",
        "injected",
        "shown",
        "let out",
    ];
    let rows = evidence.projects.iter().flat_map(|project| {
        project.groups.iter().map(move |group| {
            vec![
                Cell::text(&project.project),
                Cell::Code(project.signature.clone()),
                Cell::text(&project.stimulus),
                Cell::Number(project.seed.to_string()),
                Cell::count(u64::from(project.scans)),
                Cell::count(u64::from(project.follow)),
                Cell::text(group.group.name()),
                Cell::count(group.injected),
                Cell::count(group.effective),
                Cell::count(group.let_out),
            ]
        })
    });
    html::table(out, &heads, rows);
    html::heading(out, 3, "By mechanism");
    html::paragraph(
        out,
        "The fault's own scan counts as 1. A fault that takes longer lies in something that nothing used until then.",
    );
    mechanisms_table(out, evidence.mechanisms.iter().cloned());
    html::heading(out, 3, "By class");
    classes_table(out, &evidence.classes);
    misses(out, evidence);
}

fn misses(out: &mut String, evidence: &InjectionEvidence) {
    html::heading(out, 3, "Wrong outputs let out, each with its replay");
    let let_out: u64 = evidence.groups.iter().map(|group| group.let_out).sum();
    match let_out {
        0 => html::paragraph(out, "None."),
        let_out => html::paragraph(
            out,
            &format!(
                "{} in all; the reports list at most 100 of a class and project, {} of them.",
                count(let_out),
                count(evidence.misses.len() as u64)
            ),
        ),
    }
    for group in [Group::Channel, Group::Shared, Group::Residual] {
        let of_group = |name: &str| evidence.classes.iter().any(|class| class.name == name && class.group == group);
        let mut lines =
            evidence.misses.iter().filter(|miss| of_group(&miss.class)).map(|miss| miss.replay.as_str()).peekable();
        if lines.peek().is_some() {
            let what = match group {
                Group::Residual => {
                    "Residual: what a controller alone cannot see, and docs/independence.md says what covers it."
                        .to_owned()
                }
                _ => format!("Group {}: the controller has to find these.", group.name()),
            };
            html::paragraph(out, &what);
            html::commands(out, lines);
        }
    }
}
