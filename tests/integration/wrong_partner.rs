//! The partner with a defect that a test puts into it: what the comparison and the fuzzer are there to find.

use std::marker::PhantomData;

use twinrung_bytecode::channel::{Channel, Representation, ScanEnd, ScanInputs, Status};
use twinrung_bytecode::image::Image;
use twinrung_bytecode::index::{BitCell, EventTaskIndex, ProgramIndex, WordCell};
use twinrung_bytecode::observer::Observer;
use twinrung_bytecode::signature::seal;
use twinrung_bytecode::{AdmittedImage, admit};
use twinrung_partner::Partner;

/// A defect.
pub trait Defect {
    /// What the channel executes instead of the image.
    fn change(records: &mut Image) {
        let _ = records;
    }

    /// What its clock says, in ms, when an observer listens and when none does.
    fn clock(now_ms: i64, observed: bool) -> i64 {
        let _ = observed;
        now_ms
    }
}

/// The partner with a defect.
pub struct WrongPartner<D>(Partner, PhantomData<D>);

impl<D: Defect> Channel for WrongPartner<D> {
    type LoadError = <Partner as Channel>::LoadError;
    const REPRESENTATION: Representation = Partner::REPRESENTATION;

    fn load(image: &AdmittedImage) -> Result<Self, Self::LoadError> {
        let mut records = image.image().clone();
        D::change(&mut records);
        let wrong = seal(&records).expect("the wrong program has a text");
        Partner::load(&admit(&wrong).expect("it is a valid program")).map(|partner| WrongPartner(partner, PhantomData))
    }

    fn reset(&mut self) {
        self.0.reset();
    }

    fn prescan<O: Observer>(&mut self, inputs: ScanInputs<'_>, observer: &mut O) -> ScanEnd {
        self.0.prescan(ScanInputs { now_ms: D::clock(inputs.now_ms, O::ACTIVE), ..inputs }, observer)
    }

    fn scan<O: Observer>(&mut self, inputs: ScanInputs<'_>, observer: &mut O) -> ScanEnd {
        self.0.scan(ScanInputs { now_ms: D::clock(inputs.now_ms, O::ACTIVE), ..inputs }, observer)
    }

    fn set_bit(&mut self, cell: BitCell, value: bool) {
        self.0.set_bit(cell, value);
    }

    fn set_word(&mut self, cell: WordCell, value: i32) {
        self.0.set_word(cell, value);
    }

    fn bits(&self) -> &[u8] {
        self.0.bits()
    }

    fn words(&self) -> &[u32] {
        self.0.words()
    }

    fn status(&self) -> Status {
        self.0.status()
    }

    fn events(&self, task: EventTaskIndex) -> u32 {
        self.0.events(task)
    }

    fn fault_record(&self, program: ProgramIndex) -> Option<[i32; 11]> {
        self.0.fault_record(program)
    }

    fn path_signature(&self) -> u32 {
        self.0.path_signature()
    }
}
