//! Text in, a loaded partner out; tags by their names.
#![allow(dead_code)]

pub mod random;

use twinrung_bytecode::AdmittedImage;
use twinrung_bytecode::channel::{Channel, ScanEnd, ScanInputs, Status};
use twinrung_bytecode::image::{Image, TypeReference};
use twinrung_bytecode::index::{BitCell, ProgramIndex, WordCell};
use twinrung_bytecode::observer::{Observer, Silent};
use twinrung_catalog::Element;
use twinrung_compiler::{Completion, check, compile};
use twinrung_grammar::tree::Sources;
use twinrung_partner::Partner;

/// An observer that only wants everything to be reported.
pub struct Watching;

impl Observer for Watching {}

/// A loaded partner and its image.
pub struct Rig {
    pub admitted: AdmittedImage,
    pub partner: Partner,
    pub system_values: Vec<i32>,
    pub budget: u64,
    pub watched: bool,
}

/// Compiles a whole file.
pub fn admit(text: &str) -> AdmittedImage {
    let mut sources = Sources::new();
    let reading = twinrung_grammar::read(&mut sources, "test.rll", text.as_bytes().to_vec());
    let checked = check(&reading, &Completion::default());
    let findings: Vec<String> = checked
        .findings
        .iter()
        .filter(|finding| finding.is_error())
        .map(|finding| format!("{} {}", finding.code.id, finding.message))
        .collect();
    let project = checked.project.unwrap_or_else(|| panic!("{findings:?}\n{text}"));
    let compiled = compile(&project).unwrap_or_else(|finding| panic!("{finding:?}\n{text}"));
    twinrung_bytecode::admit(&compiled.bytes).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// A project with one program.
pub fn project(declarations: &str, tags: &str, program: &str) -> String {
    format!(
        "CONTROLLER Test (ProcessorType := \"1756-L73S\", Major := 20)\n{declarations}\nTAG\n{tags}\nEND_TAG\n\
         PROGRAM Main_Program (Class := Safety, MAIN := \"Main\"{program}\nEND_PROGRAM\n\
         TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 10, Watchdog := 10, Priority := 5)\n\
         Main_Program;\nEND_TASK\nEND_CONTROLLER\n"
    )
}

/// Tags with class Safety: `name : TYPE [:= value]` each.
pub fn tags(list: &[&str]) -> String {
    list.iter()
        .map(|tag| {
            let (head, value) =
                tag.split_once(":=").map_or((*tag, String::new()), |(head, value)| (head, format!(" :={value}")));
            format!("{} (Class := Safety){value};\n", head.trim_end())
        })
        .collect()
}

/// A partner with one routine of these rungs.
pub fn rungs(tag_list: &[&str], rungs: &[&str]) -> Rig {
    let body: String = rungs.iter().map(|rung| format!("N: {rung};\n")).collect();
    Rig::new(&project("", &tags(tag_list), &format!(")\nROUTINE Main\n{body}END_ROUTINE")))
}

/// The code of the major fault that ended a scan.
pub fn fault_code(end: ScanEnd) -> Option<u16> {
    match end {
        ScanEnd::MajorFault(fault) => Some(fault.code),
        _ => None,
    }
}

impl Rig {
    /// Compiles and loads a project.
    pub fn new(text: &str) -> Rig {
        let admitted = admit(text);
        let partner = Partner::load(&admitted).unwrap_or_else(|error| panic!("{error}"));
        Rig { admitted, partner, system_values: vec![0; 64], budget: u64::MAX, watched: false }
    }

    /// The same, observed: every rung is walked.
    pub fn watched(mut self) -> Rig {
        self.watched = true;
        self
    }

    fn inputs(&self, now_ms: i64) -> (ScanInputs<'static>, Vec<i32>) {
        (ScanInputs { now_ms, budget: self.budget, system_values: &[] }, self.system_values.clone())
    }

    pub fn prescan(&mut self, now_ms: i64) -> ScanEnd {
        let (inputs, values) = self.inputs(now_ms);
        let inputs = ScanInputs { system_values: &values, ..inputs };
        match self.watched {
            true => self.partner.prescan(inputs, &mut Watching),
            false => self.partner.prescan(inputs, &mut Silent),
        }
    }

    pub fn scan(&mut self, now_ms: i64) -> ScanEnd {
        let (inputs, values) = self.inputs(now_ms);
        let inputs = ScanInputs { system_values: &values, ..inputs };
        match self.watched {
            true => self.partner.scan(inputs, &mut Watching),
            false => self.partner.scan(inputs, &mut Silent),
        }
    }

    pub fn status(&self) -> Status {
        self.partner.status()
    }

    pub fn record(&self) -> [i32; 11] {
        self.partner.fault_record(ProgramIndex(0)).unwrap()
    }

    fn place(&self, name: &str) -> (Element, u32) {
        place(self.admitted.image(), self.admitted.layouts(), name)
    }

    pub fn set(&mut self, name: &str, value: i32) {
        match self.place(name) {
            (Element::Bool, cell) => self.partner.set_bit(BitCell(cell), value != 0),
            (_, cell) => self.partner.set_word(WordCell(cell), value),
        }
    }

    pub fn get(&self, name: &str) -> i32 {
        match self.place(name) {
            (Element::Bool, cell) => i32::from(!self.partner.bits()[cell as usize]),
            (_, cell) => !self.partner.words()[cell as usize] as i32,
        }
    }

    pub fn real(&self, name: &str) -> f32 {
        f32::from_bits(self.get(name) as u32)
    }

    /// Several tags at once.
    pub fn row(&self, names: &[&str]) -> Vec<i32> {
        names.iter().map(|name| self.get(name)).collect()
    }
}

/// Type and cell of `Tag`, `Tag.Member...` or `Tag[index]...`.
fn place(image: &Image, layouts: &[twinrung_bytecode::layout::TypeLayout], name: &str) -> (Element, u32) {
    let mut steps = name.split(['.', '[', ']']).filter(|step| !step.is_empty());
    let root = steps.next().unwrap();
    let tag = image.tags.iter().find(|tag| tag.name.eq_ignore_ascii_case(root)).unwrap_or_else(|| panic!("{name}"));
    let (mut type_reference, mut bit, mut word) = (tag.type_reference, tag.bit_cell, tag.word_cell);
    for step in steps {
        if let Ok(index) = step.parse::<u32>() {
            let (bits, words) = twinrung_bytecode::layout::cells(layouts, type_reference).unwrap();
            bit += index * bits;
            word += index * words;
            continue;
        }
        let TypeReference::Structure(structure) = type_reference else { panic!("{name}") };
        let members = &image.types[structure.position()].members;
        let number = members.iter().position(|member| member.name.eq_ignore_ascii_case(step)).unwrap();
        bit += layouts[structure.position()].members[number].bit_cell;
        word += layouts[structure.position()].members[number].word_cell;
        type_reference = members[number].type_reference;
    }
    match type_reference {
        TypeReference::Element(Element::Bool) => (Element::Bool, bit),
        TypeReference::Element(element) => (element, word),
        TypeReference::Structure(_) => panic!("{name} is a structure"),
    }
}
