//! The rules, one file each: the entry of the code table with its samples, the check, and the test that both samples
//! behave as the entry says.

/// A complete project for a sample: what stands in its TAG block and in its routine.
macro_rules! sample {
    (on $processor:literal, $revision:literal; $tags:literal, $rungs:literal) => {
        concat!(
            "CONTROLLER Sample (ProcessorType := \"", $processor, "\", Major := ", $revision, ")\n",
            "  TAG\n", $tags, "  END_TAG\n",
            "  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n", $rungs,
            "    END_ROUTINE\n  END_PROGRAM\n",
            "  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 20, Priority := 5)\n",
            "    Safety_Main;\n  END_TASK\nEND_CONTROLLER\n"
        )
    };
    ($tags:literal, $rungs:literal) => { sample!(on "1756-L73S", "20"; $tags, $rungs) };
}

/// Declares the entry of a rule in the code table.
macro_rules! rule {
    ($(#[$doc:meta])* $id:literal, $severity:ident, $title:literal, $explanation:literal, $citation:literal, good: $good:expr, bad: $bad:expr) => {
        $(#[$doc])*
        pub static CODE: crate::diagnostic::Code = crate::diagnostic::Code {
            id: $id,
            severity: crate::diagnostic::Severity::$severity,
            title: $title,
            explanation: $explanation,
            citation: $citation,
            good: $good,
            bad: $bad,
        };

        #[cfg(test)]
        mod tests {
            #[test]
            fn rule_when_broken_then_fires_at_the_marked_place_only_and_when_kept_then_not() {
                crate::rules::testing::holds(&super::CODE);
            }
        }
    };
}

macro_rules! rules {
    ($($module:ident),* $(,)?) => {
        $(pub mod $module;)*

        /// The entries of all rules.
        pub static CODES: &[&crate::diagnostic::Code] = &[$(&$module::CODE,)*];
    };
}

#[cfg(test)]
mod testing;

rules! {
    admission,
    alias_across_classes,
    copy_length_constant,
    expression_operator,
    module_setting,
    pending_edits,
    preset,
    real,
    routine_language,
    safety_type,
    standard_tag,
    system_attribute,
    tag_map,
    uncertified,
}

use crate::diagnostic::Findings;
use crate::project::Project;

/// Applies every rule that looks at the project as a whole.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    pending_edits::check(project, findings);
    preset::check(project, findings);
    real::check(project, findings);
}
