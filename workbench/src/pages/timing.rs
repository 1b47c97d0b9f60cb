//! The timing diagram of a vector, as manuals draw it: one line for each operand and output, time from left to right, a
//! new section wherever something changes. It is not to scale: a mute of a second and a reset of 20 ms share one line.

use std::fmt::Write;

use twinrung_catalog::{Element, MemberRole, OperandKind};
use twinrung_safety_vectors::Vector;

use crate::diagram::{HIGH, LOW};
use crate::signal::Value;

/// What a run of a vector looks like.
#[derive(Debug, Clone, PartialEq)]
pub struct Timing {
    /// When each section begins, in ms.
    pub begins_ms: Vec<u32>,
    /// When the run ends, in ms.
    pub end_ms: u32,
    /// Operands that change, in neutral-text order.
    pub inputs: Vec<Line>,
    /// Members that change, in layout order.
    pub outputs: Vec<Line>,
    /// What keeps its value for the whole run.
    pub constant: Vec<Line>,
}

/// One line of a diagram.
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    /// The member of the backing tag.
    pub name: &'static str,
    /// Whether numbers of it are codes, which are written as manuals do: `16#4001`.
    pub code: bool,
    /// Its value in each section.
    pub values: Vec<Value>,
}

/// A value that changes in every scan tells nothing by where it changes.
fn begins_section(element: Element, code: bool) -> bool {
    element == Element::Bool || code
}

fn value(element: Element, raw: i32) -> Value {
    match element {
        Element::Bool => Value::Bool(raw != 0),
        Element::Real => Value::Real(f32::from_bits(raw as u32)),
        _ => Value::Integer(raw),
    }
}

/// A line before sections are known: its value in every scan.
struct Trace {
    line: Line,
    output: bool,
    marks: bool,
}

impl Timing {
    /// What a vector shows at its first period. Configuration operands are no part of it: they never change.
    pub fn of(vector: &Vector) -> Timing {
        let mut traces = traces(vector);
        let period_ms = vector.periods_ms.first().copied().unwrap_or(1);
        let mut replay = vector.replay(period_ms);
        let mut times: Vec<u32> = Vec::new();
        while let Some(scan) = replay.next_scan() {
            times.push(u32::try_from(scan.now_ms).unwrap_or(u32::MAX));
            for (place, element, trace) in &mut traces {
                let raw = match trace.output {
                    true => replay.expected().get(*place).copied().flatten(),
                    false => replay.operands().get(*place).copied(),
                };
                trace.line.values.push(value(*element, raw.unwrap_or_default()));
            }
        }
        let begins: Vec<usize> = (0..times.len())
            .filter(|scan| {
                let changes =
                    |trace: &Trace| trace.line.values.get(scan.wrapping_sub(1)) != trace.line.values.get(*scan);
                *scan == 0 || traces.iter().any(|(_, _, trace)| trace.marks && changes(trace))
            })
            .collect();
        let mut timing = Timing {
            begins_ms: begins.iter().filter_map(|scan| times.get(*scan).copied()).collect(),
            end_ms: vector.end_ms,
            inputs: Vec::new(),
            outputs: Vec::new(),
            constant: Vec::new(),
        };
        for (_, _, Trace { mut line, output, .. }) in traces {
            line.values = begins.iter().filter_map(|scan| line.values.get(*scan).copied()).collect();
            let changes = line.values.windows(2).any(|pair| pair[0] != pair[1]);
            match (changes, output) {
                (false, _) => timing.constant.push(line),
                (true, false) => timing.inputs.push(line),
                (true, true) => timing.outputs.push(line),
            }
        }
        timing
    }

    /// Draws it within so many columns; what has no room beside the rest goes on below it.
    pub fn draw(&self, columns: usize) -> String {
        let lines = || self.inputs.iter().chain(&self.outputs);
        let gutter = lines().map(|line| line.name.len()).max().unwrap_or(0).max(2) + 2;
        let plot = columns.saturating_sub(gutter).max(LEAST_PLOT);
        let mut widths: Vec<usize> = (0..self.begins_ms.len()).map(|section| self.least_width(section)).collect();
        self.spread(&mut widths, plot);
        let mut out = String::new();
        let mut begin = 0;
        while begin < widths.len() {
            let mut end = begin + 1;
            let mut used = widths[begin];
            while end < widths.len() && used + widths[end] <= plot {
                used += widths[end];
                end += 1;
            }
            if begin > 0 {
                out.push('\n');
            }
            self.band(&mut out, gutter, &widths, begin..end);
            begin = end;
        }
        if !self.constant.is_empty() {
            let words: Vec<String> = self.constant.iter().map(constant_words).collect();
            out.push('\n');
            let mut column = 0;
            for (at, word) in std::iter::once("Throughout:".to_owned()).chain(words).enumerate() {
                let text = if at == 0 || at == self.constant.len() { word } else { format!("{word},") };
                if column > 0 && column + 1 + text.len() > columns {
                    out.push('\n');
                    column = 0;
                } else if column > 0 {
                    out.push(' ');
                    column += 1;
                }
                column += text.len();
                out.push_str(&text);
            }
            out.push('\n');
        }
        out
    }

    /// Room for the time at which a section begins, and for the numbers that begin there.
    fn least_width(&self, section: usize) -> usize {
        let label = self.begins_ms[section].to_string().len() + 2;
        let number = |line: &Line| match (line.values.get(section), section.checked_sub(1).map(|at| line.values[at])) {
            (Some(Value::Bool(_)) | None, _) => 0,
            (Some(value), before) if before == Some(*value) => 0,
            (Some(value), _) => shown(*value, line.code).len() + 1,
        };
        let numbers = self.inputs.iter().chain(&self.outputs).map(number).max().unwrap_or(0);
        label.max(numbers).max(LEAST_SECTION)
    }

    /// Where everything fits side by side, longer sections get more of the room that is left.
    fn spread(&self, widths: &mut [usize], plot: usize) {
        let used: usize = widths.iter().sum();
        let Some(spare) = plot.min(WIDEST_PLOT).checked_sub(used) else { return };
        let lengths: Vec<u64> = (0..widths.len())
            .map(|section| {
                let end = self.begins_ms.get(section + 1).copied().unwrap_or(self.end_ms);
                u64::from(end.saturating_sub(self.begins_ms[section]))
            })
            .collect();
        let whole = lengths.iter().sum::<u64>().max(1);
        for (width, length) in widths.iter_mut().zip(lengths) {
            *width += usize::try_from(spare as u64 * length / whole).unwrap_or(0);
        }
    }

    fn band(&self, out: &mut String, gutter: usize, widths: &[usize], sections: std::ops::Range<usize>) {
        let _ = write!(out, "{:<gutter$}", "ms");
        for section in sections.clone() {
            let _ = write!(out, "|{:<width$}", self.begins_ms[section], width = widths[section] - 1);
        }
        out.truncate(out.trim_end().len());
        out.push('\n');
        for line in &self.inputs {
            draw_line(out, line, gutter, widths, sections.clone());
        }
        if !self.inputs.is_empty() && !self.outputs.is_empty() {
            out.push('\n');
        }
        for line in &self.outputs {
            draw_line(out, line, gutter, widths, sections.clone());
        }
    }
}

/// Narrowest plot that is still worth looking at.
const LEAST_PLOT: usize = 20;
/// Widest plot: beyond it an eye loses the line.
const WIDEST_PLOT: usize = 72;
/// Narrowest section.
const LEAST_SECTION: usize = 4;

fn traces(vector: &Vector) -> Vec<(usize, Element, Trace)> {
    let Some(declaration) = vector.declaration() else { return Vec::new() };
    let operands = vector.opcode.instruction().operands.iter().skip(1);
    let trace = |name, code, output, marks| Trace { line: Line { name, code, values: Vec::new() }, output, marks };
    let inputs = operands.zip(declaration.mirrored).enumerate().filter_map(|(place, (operand, name))| {
        let element = match operand.kind {
            OperandKind::SafetyBit { .. } => Element::Bool,
            OperandKind::SafetyInteger { .. } => Element::Dint,
            OperandKind::SafetyReal { .. } => Element::Real,
            _ => return None,
        };
        Some((place, element, trace(*name, false, false, true)))
    });
    let outputs = declaration.backing.members.iter().enumerate().filter_map(|(place, member)| {
        let code = matches!(member.name, "FaultCode" | "DiagnosticCode");
        let drawn = member.role == MemberRole::Output && member.name != "EnableOut";
        drawn.then(|| (place, member.element, trace(member.name, code, true, begins_section(member.element, code))))
    });
    inputs.chain(outputs).collect()
}

fn shown(value: Value, code: bool) -> String {
    match value {
        Value::Integer(number) if code && number != 0 => format!("16#{number:04X}"),
        value => value.to_string(),
    }
}

fn constant_words(line: &Line) -> String {
    match line.values.first() {
        Some(Value::Bool(true)) => format!("{} on", line.name),
        Some(Value::Bool(false)) | None => format!("{} off", line.name),
        Some(value) => format!("{} {}", line.name, shown(*value, line.code)),
    }
}

fn draw_line(out: &mut String, line: &Line, gutter: usize, widths: &[usize], sections: std::ops::Range<usize>) {
    let _ = write!(out, "{:<gutter$}", line.name);
    let mut before: Option<Value> = None;
    for section in sections {
        let (width, value) = (widths[section], line.values[section]);
        match value {
            Value::Bool(level) => out.extend(std::iter::repeat_n(if level { HIGH } else { LOW }, width)),
            number if before == Some(number) => out.extend(std::iter::repeat_n('·', width)),
            number => {
                let text = shown(number, line.code);
                out.push_str(&text);
                out.extend(std::iter::repeat_n('·', width.saturating_sub(text.len())));
            }
        }
        before = Some(value);
    }
    out.push('\n');
}

#[cfg(test)]
mod tests {
    use super::*;
    use twinrung_catalog::Opcode;
    use twinrung_safety_vectors::parse;

    fn timing(steps: &'static str) -> Timing {
        Timing::of(&parse(Opcode::Crout, steps).unwrap()[0])
    }

    const RUN: &str = "vector X\nsource s\nmark decided\nperiod 10\nconfig FeedbackType=POSITIVE FeedbackReactionTime=200\n\
        0 InputStatus=1 OutputStatus=1 -> O1=0 O2=0 FP=0 FaultCode=0 DiagnosticCode=0\n\
        50 Actuate=1 -> O1=1 O2=1\n250 -> O1=0 O2=0 FP=1 FaultCode=16#5008\n260 end\n";

    #[test]
    fn timing_when_taken_from_a_vector_then_sections_begin_where_something_changes() {
        let timing = timing(RUN);
        assert_eq!(timing.begins_ms, [0, 50, 250]);
        let names = |lines: &[Line]| lines.iter().map(|line| line.name).collect::<Vec<_>>();
        assert_eq!(names(&timing.inputs), ["Actuate"]);
        assert_eq!(names(&timing.outputs), ["O1", "O2", "FP", "FaultCode"]);
        assert_eq!(timing.outputs[0].values, [Value::Bool(false), Value::Bool(true), Value::Bool(false)]);
    }

    #[test]
    fn timing_when_drawn_then_levels_are_bars_codes_are_hexadecimal_and_constants_are_named() {
        let drawn = timing(RUN).draw(31);
        let lines: Vec<&str> = drawn.lines().collect();
        assert_eq!(lines[0], "ms         |0  |50    |250");
        assert_eq!(lines[1], "Actuate    ▁▁▁▁███████████████");
        assert_eq!(lines[6], "FaultCode  0··········16#5008·");
        assert!(lines[8].starts_with("Throughout: Feedback1 off,"), "{drawn}");
    }

    const LONG: &str = "vector X\nsource s\nmark decided\nperiod 10\nconfig FeedbackType=POSITIVE FeedbackReactionTime=200\n\
        0 InputStatus=1 OutputStatus=1 -> O1=0 O2=0 FP=0 FaultCode=0 DiagnosticCode=0\n50 Actuate=1 -> O1=1 O2=1\n\
        60 Feedback1=1\n70 Feedback2=1\n80 Actuate=0 -> O1=0 O2=0\n90 Feedback1=0\n100 end\n";

    #[test]
    fn timing_when_it_does_not_fit_then_it_goes_on_below() {
        let drawn = timing(LONG).draw(20);
        let axes: Vec<&str> = drawn.lines().filter(|line| line.starts_with("ms ")).collect();
        assert_eq!(axes, ["ms         |0  |50 |60 |70 |80", "ms         |90"]);
    }
}
