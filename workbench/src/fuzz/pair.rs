//! The two channels against each other, compared as the controller compares them.

use std::marker::PhantomData;

use twinrung_bytecode::channel::{Channel, ScanEnd, ScanInputs};
use twinrung_bytecode::observer::Silent;
use twinrung_controller::compare;

use crate::cells;
use crate::difference;
use crate::generate::Random;
use crate::signal::{Signal, Value};

use twinrung_contest::fuzz::{Contest, Ended, Evaluators, Executions, Subject, system_samples};

/// The contest between two channels.
#[derive(Debug, Clone, Copy, Default)]
pub struct Pairs<A, B>(PhantomData<(A, B)>);

/// Two channels with one program. They take turns in reporting what they execute, since a channel may execute on another
/// way when nobody listens: that way is to be compared as well.
pub struct Pair<'s, A, B> {
    subject: &'s Subject,
    first: A,
    second: B,
    executions: Executions,
    system_values: Vec<i32>,
    budget: u64,
    second_reports: bool,
}

impl<A: Channel, B: Channel> Contest for Pairs<A, B> {
    type Evaluators<'s> = Pair<'s, A, B>;

    fn load(subject: &Subject, budget: u64) -> Pair<'_, A, B> {
        Pair {
            subject,
            first: A::load(&subject.image).unwrap_or_else(|error| panic!("the first channel: {error}")),
            second: B::load(&subject.image).unwrap_or_else(|error| panic!("the second channel: {error}")),
            executions: Executions::new(subject),
            system_values: vec![0; subject.image.image().system_values_length()],
            budget,
            second_reports: false,
        }
    }
}

impl<A: Channel, B: Channel> Pair<'_, A, B> {
    fn judged(&self, ends: (ScanEnd, ScanEnd)) -> Result<Ended, String> {
        match compare(self.subject.image.image(), &self.first, &self.second, ends) {
            Some(found) => Err(difference::words(&self.subject.image, found)),
            None => Ok(match ends.0 {
                ScanEnd::Completed => Ended::Completed,
                ScanEnd::MajorFault(fault) => Ended::Fault(fault.code),
                ScanEnd::BudgetExceeded => Ended::BudgetExceeded,
            }),
        }
    }
}

impl<A: Channel, B: Channel> Evaluators for Pair<'_, A, B> {
    fn set(&mut self, values: &[(Signal, Value)]) {
        self.executions.set(values);
        for (signal, value) in values {
            cells::write(&mut self.first, *signal, cells::held(*value));
            cells::write(&mut self.second, *signal, cells::held(*value));
        }
    }

    fn set_system_values(&mut self, random: &mut Random) {
        for sample in system_samples(&self.subject.image, random) {
            let first = sample.record.first as usize;
            self.system_values[first..first + sample.values.len()].copy_from_slice(&sample.values);
        }
    }

    fn prescan(&mut self, now_ms: i64) -> Result<Ended, String> {
        let inputs = ScanInputs { now_ms, budget: self.budget, system_values: &self.system_values };
        let (first, second, executions) = (&mut self.first, &mut self.second, &mut self.executions);
        let ends = match self.second_reports {
            true => (first.prescan(inputs, &mut Silent), second.prescan(inputs, executions)),
            false => (first.prescan(inputs, executions), second.prescan(inputs, &mut Silent)),
        };
        self.judged(ends)
    }

    fn scan(&mut self, now_ms: i64) -> Result<Ended, String> {
        let inputs = ScanInputs { now_ms, budget: self.budget, system_values: &self.system_values };
        self.second_reports = !self.second_reports;
        let (first, second, executions) = (&mut self.first, &mut self.second, &mut self.executions);
        let ends = match self.second_reports {
            true => (first.scan(inputs, &mut Silent), second.scan(inputs, executions)),
            false => (first.scan(inputs, executions), second.scan(inputs, &mut Silent)),
        };
        self.judged(ends)
    }

    fn executed(&self) -> u64 {
        self.first.status().executed
    }

    fn cleared_faults(&self) -> u64 {
        u64::from(self.first.status().cleared_faults)
    }

    fn executions(&self) -> &Executions {
        &self.executions
    }
}
