//! What the channels share.

use crate::html::{self, Cell};

use super::super::Independence;

pub(super) fn write(out: &mut String, review: Option<&Independence>) {
    html::heading(out, 2, "Independence");
    let Some(review) = review else {
        html::warning(
            out,
            "Not there: docs/independence.md cannot be found, and without it nobody has said what the channels share.",
        );
        return;
    };
    html::paragraph(
        out,
        &format!(
            "What both channels share, and what covers it: the review in {}, in its own words. A test follows the dependency graph and fails where the channels meet in anything that computes.",
            review.file
        ),
    );
    let said = |text: &String| if text.is_empty() { Cell::Not("NOTHING IS SAID".to_owned()) } else { Cell::text(text) };
    let rows = review.areas.iter().map(|area| {
        let parts = [&area.covered_by, &area.not_covered, &area.user].map(said);
        [vec![Cell::text(&area.name)], parts.to_vec()].concat()
    });
    html::table(out, &["shared", "covered by", "not covered", "what the user must do"], rows);
    if !review.unnamed.is_empty() {
        html::warning(
            out,
            &format!("Residual classes of faults that the review does not name: {}.", review.unnamed.join(", ")),
        );
    }
}
