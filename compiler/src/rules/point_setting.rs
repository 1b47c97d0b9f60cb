//! Settings of points and test outputs. 1734-UM013 Tables 18 to 21.

use twinrung_catalog::modules;
use twinrung_catalog::points::{Points, SettingValue};
use twinrung_grammar::tree::PointKind;

use crate::diagnostic::{Finding, Findings};
use crate::names::closest;
use crate::project::module::point_number;
use crate::project::{Module, Point, Project, Setting};

rule! {
    /// A point, a key or a value that the module does not have.
    "S0403", Error, "a point or its setting does not exist, or its value is out of range",
    "The points of a module, what can be set on them, the words, the ranges and the increments are those of the I/O manual: delays of 0 to 126 ms in steps of 6, discrepancy and latch times of 0 to 65,530 ms in steps of 10. A value between two steps would be rounded by the module.",
    "1734-UM013 Tables 18 to 21",
    good: sample!(modules "  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n  MODULE Doors (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002)\n    POINT I00 (Mode := SAFETY, OffOn := 12, OnOff := 126);\n  END_MODULE\n"; "    Run : BOOL (Class := Safety);\n", "      N: XIC(Doors:I.Pt00Data)OTE(Run);\n"),
    bad: sample!(modules "  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n  MODULE Doors (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002)\n    POINT I00 (Mode := <<SAFE>>, OffOn := <<10>>, OnOff := <<132>>, <<Delay>> := 6);\n    POINT <<I08>> (Mode := SAFETY);\n  END_MODULE\n"; "    Run : BOOL (Class := Safety);\n", "      N: XIC(Doors:I.Pt00Data)OTE(Run);\n")
}

/// Every point of every module whose points are known.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    for module in &project.modules {
        let known = module.known_points();
        if known.is_empty() {
            continue;
        }
        for point in &module.points {
            judge(module, known, point, findings);
        }
    }
}

fn judge(module: &Module, known: &[&'static Points], point: &Point, findings: &mut Findings) {
    let test = point.kind == PointKind::Test;
    let kind = point_number(&point.name).and_then(|(letter, number)| {
        known.iter().find(|kind| kind.letter == letter && kind.test == test && number < kind.count)
    });
    let Some(kind) = kind else {
        let message = format!("the {} has no {} `{}`", module.catalog_number, word(test), point.name);
        let ranges: Vec<String> = known.iter().map(|kind| range(kind)).collect();
        findings.push(Finding::new(&CODE, point.span, message).help(format!("it has {}", ranges.join(", "))));
        return;
    };
    for setting in &point.settings {
        match kind.settings.iter().find(|one| one.key.eq_ignore_ascii_case(&setting.key)) {
            Some(declared) => value(declared.key, declared.value, setting, findings),
            None => {
                let message = format!("`{}` is not set on {}", setting.key, range(kind));
                let finding = Finding::new(&CODE, setting.key_span, message);
                let keys = || kind.settings.iter().map(|one| one.key);
                findings.push(match closest(&setting.key, keys()) {
                    Some(like) => finding.help(format!("did you mean {like}?")),
                    None => finding.help(format!("one of: {}", keys().collect::<Vec<_>>().join(", "))),
                });
            }
        }
    }
}

fn word(test: bool) -> &'static str {
    if test { "test output" } else { "point" }
}

fn range(kind: &Points) -> String {
    let last = kind.count - 1;
    let keyword = if kind.test { "TEST" } else { "POINT" };
    match kind.letter {
        'I' | 'O' => format!("{keyword} {0}00 to {0}{last:02}", kind.letter),
        letter => format!("{keyword} {letter}0 to {letter}{last}"),
    }
}

fn value(key: &str, declared: SettingValue, setting: &Setting, findings: &mut Findings) {
    match declared {
        SettingValue::Word(words) => {
            if words.iter().any(|word| setting.value.eq_ignore_ascii_case(word)) {
                return;
            }
            let finding = Finding::new(&CODE, setting.value_span, format!("{key} is not `{}`", setting.value));
            findings.push(match closest(&setting.value, words.iter().copied()) {
                Some(like) => finding.help(format!("did you mean {like}?")),
                None => finding.help(format!("one of: {}", words.join(", "))),
            });
        }
        SettingValue::Number { least, greatest, step, unit } => {
            let number = setting.value.parse::<i64>().ok();
            if number.is_some_and(|number| (least..=greatest).contains(&number) && number % step == 0) {
                return;
            }
            let steps = if step == 1 { String::new() } else { format!(" in steps of {step}") };
            let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
            let message = format!("{key} is {least} to {greatest}{unit}{steps}, not {}", setting.value);
            let help = match number {
                Some(number) => {
                    let near = number.clamp(least, greatest) / step * step;
                    format!("{near} is the nearest below")
                }
                None => "write a whole number".to_owned(),
            };
            findings.push(Finding::new(&CODE, setting.value_span, message).help(help));
        }
    }
}

impl Module {
    /// What is known of its points.
    pub(crate) fn known_points(&self) -> &'static [&'static Points] {
        modules::Module::by_catalog_number(&self.catalog_number).map_or(&[], |known| known.points)
    }
}
