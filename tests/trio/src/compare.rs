//! What the evaluators hold after a scan, side by side.

use twinrung_bytecode::channel::{Channel, Place, ScanEnd, Status};
use twinrung_bytecode::index::{EventTaskIndex, ProgramIndex};
use twinrung_contest::cells::{plain_bits, plain_words};
use twinrung_contest::fuzz::Ended;
use twinrung_contest::{Signal, names};
use twinrung_judge::End;

use crate::disagreement::{Disagreement, LISTED};
use crate::trio::Trio;

impl Trio<'_> {
    pub(crate) fn compare(
        &self,
        scan: Option<u64>,
        ends: (ScanEnd, ScanEnd),
        judged: End,
    ) -> Result<Ended, Disagreement> {
        let same_path = self.took_one_path(ends);
        if same_path && self.is_alike(ends, judged) && self.is_observed_alike() {
            return Ok(ended(ends.0));
        }
        let mut values = Vec::new();
        let mut note = |name: String, found: [String; 3]| {
            if found[0] != found[1] || found[1] != found[2] {
                values.push((name, found));
            }
        };
        note("end".to_owned(), [end_words(ends.0), end_words(ends.1), judged_words(judged)]);
        let status = [status_words(&self.primary), status_words(&self.partner), self.judge_status_words()];
        note("status".to_owned(), status);
        for program in 0..self.subject.image.image().programs.len() {
            let index = ProgramIndex(program as u16);
            let found = [
                format!("{:?}", self.primary.fault_record(index).unwrap_or_default()),
                format!("{:?}", self.partner.fault_record(index).unwrap_or_default()),
                format!("{:?}", self.judge.fault_record(program)),
            ];
            note(format!("fault record of program {program}"), found);
        }
        for (task, name) in self.subject.image.image().event_tasks.iter().enumerate() {
            let index = EventTaskIndex(task as u16);
            let found = [self.primary.events(index), self.partner.events(index), self.judge.events(name)];
            note(format!("events of {name}"), found.map(|count| count.to_string()));
        }
        if !same_path {
            let paths =
                [self.primary.path_signature(), self.partner.path_signature()].map(|path| format!("16#{path:08x}"));
            values.push(("path of control".to_owned(), [paths[0].clone(), paths[1].clone(), "not kept".to_owned()]));
        }
        if !self.is_observed_alike() {
            values.push((
                "primary with an observer".to_owned(),
                ["differs from the primary without"; 3].map(str::to_owned),
            ));
        }
        self.compare_tags(&mut values);
        values.truncate(LISTED);
        if values.is_empty() {
            return Ok(ended(ends.0));
        }
        Err(Disagreement { scan, values })
    }

    /// Whether nothing at all differs: the same comparison as the one that lists what does, without a word of text.
    fn is_alike(&self, ends: (ScanEnd, ScanEnd), judged: End) -> bool {
        let records = self.subject.image.image();
        let (status, flags) = (self.primary.status(), self.judge.flags());
        let counts = (u64::from(status.minor_faults), status.executed, u64::from(status.cleared_faults));
        let same_record = |program: usize| {
            let index = ProgramIndex(program as u16);
            let record = self.primary.fault_record(index);
            record == self.partner.fault_record(index) && record == Some(self.judge.fault_record(program))
        };
        let same_events = |(task, name): (usize, &String)| {
            let index = EventTaskIndex(task as u16);
            let count = self.primary.events(index);
            count == self.partner.events(index) && count == self.judge.events(name)
        };
        let judged_end = match (ends.0, judged) {
            (ScanEnd::Completed, End::Completed) | (ScanEnd::BudgetExceeded, End::BudgetExceeded) => true,
            (ScanEnd::MajorFault(fault), End::MajorFault(judged)) => {
                fault.code == judged.code && place_numbers(fault.place) == judged.place
            }
            _ => false,
        };
        ends.0 == ends.1
            && judged_end
            && status == self.partner.status()
            && flags_of(status)
                == [flags.first_scan, flags.overflow, flags.zero, flags.negative, flags.carry, flags.minor_fault]
            && counts == (u64::from(flags.minor_faults), flags.executed, u64::from(flags.cleared_faults))
            && (0..records.programs.len()).all(same_record)
            && records.event_tasks.iter().enumerate().all(same_events)
            && self.tags.iter().all(|(tag, range)| {
                let (bits, words) = (plain_bits(&self.primary, range), plain_words(&self.primary, range));
                bits == plain_bits(&self.partner, range)
                    && words == plain_words(&self.partner, range)
                    && self.judge.holds(*tag, &bits, &words)
            })
    }

    /// REQ-SCAN-010. The judge knows no image, and so none of the numbers that are signed.
    fn took_one_path(&self, ends: (ScanEnd, ScanEnd)) -> bool {
        ends.0 == ScanEnd::BudgetExceeded || self.primary.path_signature() == self.partner.path_signature()
    }

    fn compare_tags(&self, values: &mut Vec<(String, [String; 3])>) {
        for (tag, range) in &self.tags {
            let Some((judged_bits, judged_words)) = self.judge.tag(*tag) else { continue };
            let (bits, words) = (plain_bits(&self.primary, range), plain_words(&self.primary, range));
            let (other_bits, other_words) = (plain_bits(&self.partner, range), plain_words(&self.partner, range));
            let same_bits = bits == judged_bits && other_bits == judged_bits;
            let same_words = words == judged_words && other_words == judged_words;
            if same_bits && same_words {
                continue;
            }
            for (name, signal) in names::values_of(&self.subject.image, range.tag) {
                let found = match signal {
                    Signal::Bit(cell) => {
                        let at = cell.position() - range.bit_cell as usize;
                        [bits[at], other_bits[at], judged_bits[at]].map(i32::from)
                    }
                    Signal::Word(cell, _) => {
                        let at = cell.position() - range.word_cell as usize;
                        [words[at], other_words[at], judged_words[at]]
                    }
                    _ => continue,
                };
                if found[0] != found[1] || found[1] != found[2] {
                    values.push((name, found.map(|value| format!("{value} (16#{value:08x})"))));
                }
                if values.len() >= LISTED {
                    return;
                }
            }
        }
    }

    fn judge_status_words(&self) -> String {
        let flags = self.judge.flags();
        words_of_status(
            [flags.first_scan, flags.overflow, flags.zero, flags.negative, flags.carry, flags.minor_fault],
            [u64::from(flags.minor_faults), flags.executed, u64::from(flags.cleared_faults)],
        )
    }

    /// Whether the primary that reports holds what the other one holds.
    fn is_observed_alike(&self) -> bool {
        self.observed.as_ref().is_none_or(|observed| {
            observed.bits() == self.primary.bits()
                && observed.words() == self.primary.words()
                && observed.status() == self.primary.status()
                && observed.path_signature() == self.primary.path_signature()
        })
    }
}

fn ended(end: ScanEnd) -> Ended {
    match end {
        ScanEnd::Completed => Ended::Completed,
        ScanEnd::MajorFault(fault) => Ended::Fault(fault.code),
        ScanEnd::BudgetExceeded => Ended::BudgetExceeded,
    }
}

fn flags_of(status: Status) -> [bool; 6] {
    [status.first_scan, status.overflow, status.zero, status.negative, status.carry, status.minor_fault]
}

fn place_numbers(place: Place) -> [u32; 4] {
    [u32::from(place.program.0), place.routine.0, place.rung, place.element]
}

fn status_words(channel: &impl Channel) -> String {
    let status = channel.status();
    words_of_status(
        flags_of(status),
        [u64::from(status.minor_faults), status.executed, u64::from(status.cleared_faults)],
    )
}

fn words_of_status(flags: [bool; 6], counts: [u64; 3]) -> String {
    let flags: Vec<&str> = ["FS", "V", "Z", "N", "C", "MINOR"]
        .into_iter()
        .zip(flags)
        .filter(|(_, on)| *on)
        .map(|(name, _)| name)
        .collect();
    let [minor, executed, cleared] = counts;
    format!("[{}] minor {minor} executed {executed} cleared {cleared}", flags.join(" "))
}

fn end_words(end: ScanEnd) -> String {
    match end {
        ScanEnd::Completed => "completed".to_owned(),
        ScanEnd::BudgetExceeded => "budget exceeded".to_owned(),
        ScanEnd::MajorFault(fault) => fault_words(fault.code, place_numbers(fault.place)),
    }
}

fn judged_words(end: End) -> String {
    match end {
        End::Completed => "completed".to_owned(),
        End::BudgetExceeded => "budget exceeded".to_owned(),
        End::MajorFault(fault) => fault_words(fault.code, fault.place),
    }
}

fn fault_words(code: u16, place: [u32; 4]) -> String {
    let [program, routine, rung, element] = place;
    format!("fault 4/{code} at program {program}, routine {routine}, rung {rung}, element {element}")
}
