//! The order of the image's tables, and which entry of the project each of their entries is.

use twinrung_bytecode::image::{TypeKind, TypeReference};
use twinrung_bytecode::index::{AddOnIndex, ProgramIndex, RoutineIndex, TagIndex, TypeIndex};

use crate::names::compare;
use crate::project::{
    AddOnId, Call, Program, ProgramId, Project, Routine, RoutineId, RoutineOwner, Tag, TagClass, TagId, TagScope,
};

/// Tables of the image as lists of the project's entries, and back.
#[derive(Debug)]
pub(crate) struct Order {
    /// Types in the order of the image.
    pub types: Vec<TypeIndex>,
    type_index: Vec<Option<TypeIndex>>,
    /// Add-On Instructions in the order of the image.
    pub add_ons: Vec<AddOnId>,
    add_on_index: Vec<Option<AddOnIndex>>,
    /// Programs in the order of the image.
    pub programs: Vec<ProgramId>,
    program_index: Vec<ProgramIndex>,
    /// Tags in the order of the image.
    pub tags: Vec<TagId>,
    tag_index: Vec<Option<TagIndex>>,
    /// Routines in the order of the image.
    pub routines: Vec<RoutineId>,
    routine_index: Vec<Option<RoutineIndex>>,
}

impl Order {
    pub fn of(project: &Project) -> Order {
        let programs = programs(project);
        let mut program_index = vec![ProgramIndex(0); programs.len()];
        for (index, program) in programs.iter().enumerate() {
            program_index[program.position()] = ProgramIndex(index as u16);
        }
        let add_ons = add_ons(project);
        let add_on_index =
            inverse(project.add_ons.len(), add_ons.iter().map(|id| id.position()), |at| AddOnIndex(at as u16));
        let tags = tags(project, &program_index);
        let tag_index = inverse(project.tags.len(), tags.iter().map(|id| id.position()), |at| TagIndex(at as u32));
        let routines = routines(project, &program_index, &add_on_index);
        let routine_index =
            inverse(project.routines.len(), routines.iter().map(|id| id.position()), |at| RoutineIndex(at as u32));
        let types = types(project, &tags);
        let type_index = inverse(project.types.records().len(), types.iter().map(|index| index.position()), |at| {
            TypeIndex(at as u16)
        });
        Order {
            types,
            type_index,
            add_ons,
            add_on_index,
            programs,
            program_index,
            tags,
            tag_index,
            routines,
            routine_index,
        }
    }

    pub fn type_reference(&self, reference: TypeReference) -> TypeReference {
        match reference {
            TypeReference::Element(element) => TypeReference::Element(element),
            TypeReference::Structure(index) => TypeReference::Structure(self.type_index(index)),
        }
    }

    /// Every type that something in the image uses has an index; the verifier refuses what has none.
    pub fn type_index(&self, index: TypeIndex) -> TypeIndex {
        self.type_index.get(index.position()).copied().flatten().unwrap_or(TypeIndex(u16::MAX))
    }

    pub fn add_on(&self, id: AddOnId) -> AddOnIndex {
        self.add_on_index.get(id.position()).copied().flatten().unwrap_or(AddOnIndex(u16::MAX))
    }

    pub fn program(&self, id: ProgramId) -> ProgramIndex {
        self.program_index.get(id.position()).copied().unwrap_or(ProgramIndex(u16::MAX))
    }

    pub fn tag(&self, id: TagId) -> TagIndex {
        self.tag_index.get(id.position()).copied().flatten().unwrap_or(TagIndex(u32::MAX))
    }

    pub fn routine(&self, id: RoutineId) -> RoutineIndex {
        self.routine_index.get(id.position()).copied().flatten().unwrap_or(RoutineIndex(u32::MAX))
    }
}

fn inverse<I: Copy>(length: usize, order: impl Iterator<Item = usize>, index: impl Fn(usize) -> I) -> Vec<Option<I>> {
    let mut list = vec![None; length];
    for (at, position) in order.enumerate() {
        list[position] = Some(index(at));
    }
    list
}

fn programs(project: &Project) -> Vec<ProgramId> {
    let mut list: Vec<(&Program, ProgramId)> =
        project.programs.iter().enumerate().map(|(at, program)| (program, ProgramId(at as u16))).collect();
    list.sort_by(|left, right| compare(&left.0.name, &right.0.name));
    list.into_iter().map(|(_, id)| id).collect()
}

/// Controller scope first, then program by program, each in the order of the names.
fn tags(project: &Project, program_index: &[ProgramIndex]) -> Vec<TagId> {
    let scope = |tag: &Tag| match tag.scope {
        TagScope::Controller => 0,
        TagScope::Program(program) => 1 + u32::from(program_index[program.position()].0),
        TagScope::StandardProgram(_) => u32::MAX,
    };
    let mut list: Vec<(u32, String, TagId)> = project
        .tags
        .iter()
        .enumerate()
        .filter(|(_, tag)| tag.class == TagClass::Safety && tag.type_reference.is_some())
        .map(|(at, tag)| (scope(tag), tag.image_name().to_ascii_lowercase(), TagId(at as u32)))
        .collect();
    list.sort();
    list.into_iter().map(|(_, _, id)| id).collect()
}

/// Owner by owner, in the order of the names.
fn routines(project: &Project, programs: &[ProgramIndex], add_ons: &[Option<AddOnIndex>]) -> Vec<RoutineId> {
    let owner = |routine: &Routine| match routine.owner {
        RoutineOwner::Program(program) => (0, programs[program.position()].0),
        RoutineOwner::AddOn(add_on) => (1, add_ons[add_on.position()].map_or(u16::MAX, |index| index.0)),
    };
    let mut list: Vec<((u8, u16), String, RoutineId)> = project
        .routines
        .iter()
        .enumerate()
        .map(|(at, routine)| (owner(routine), routine.name.as_str().to_ascii_lowercase(), RoutineId(at as u32)))
        .collect();
    list.sort();
    list.into_iter().map(|(_, _, id)| id).collect()
}

/// Each after those that it calls; by name where that leaves a choice.
fn add_ons(project: &Project) -> Vec<AddOnId> {
    let mut calls: Vec<Vec<AddOnId>> = vec![Vec::new(); project.add_ons.len()];
    for routine in &project.routines {
        let RoutineOwner::AddOn(owner) = routine.owner else { continue };
        for rung in &routine.rungs {
            rung.visit(&mut |instruction| {
                if let Call::AddOn(called) = instruction.call {
                    calls[owner.position()].push(called);
                }
            });
        }
    }
    let name = |at: usize| project.add_ons[at].name.as_str();
    for list in &mut calls {
        list.sort_by(|left, right| compare(name(left.position()), name(right.position())));
        list.dedup();
    }
    let mut roots: Vec<usize> = (0..project.add_ons.len()).collect();
    roots.sort_by(|left, right| compare(name(*left), name(*right)));
    let next = |at: usize| calls[at].iter().map(|id| id.position()).collect::<Vec<_>>();
    after_what_they_need(project.add_ons.len(), &roots, next).into_iter().map(|at| AddOnId(at as u16)).collect()
}

/// Types that tags and Add-On Instructions use, each after those of its members; by name where that leaves a choice.
fn types(project: &Project, tags: &[TagId]) -> Vec<TypeIndex> {
    let mut roots: Vec<usize> = Vec::new();
    let mut add = |reference: Option<TypeReference>| {
        if let Some(TypeReference::Structure(index)) = reference {
            roots.push(index.position());
        }
    };
    for id in tags {
        add(project.tag(*id).type_reference);
    }
    for add_on in &project.add_ons {
        add(add_on.instance_type.map(TypeReference::Structure));
        add_on.parameters.iter().for_each(|parameter| add(parameter.type_reference));
    }
    roots.sort_unstable();
    roots.dedup();
    let records = project.types.records();
    let name = |at: usize| records[at].name.as_str();
    roots.sort_by(|left, right| compare(name(*left), name(*right)));
    let next = |at: usize| {
        let mut members: Vec<usize> = records[at]
            .members
            .iter()
            .filter_map(|member| match member.type_reference {
                TypeReference::Structure(index) => Some(index.position()),
                TypeReference::Element(_) => None,
            })
            .collect();
        members.sort_by(|left, right| compare(name(*left), name(*right)));
        members.dedup();
        members
    };
    after_what_they_need(records.len(), &roots, next).into_iter().map(|at| TypeIndex(at as u16)).collect()
}

/// Depth first from each root, an entry after everything that it needs. What needs itself is listed once.
fn after_what_they_need(count: usize, roots: &[usize], next: impl Fn(usize) -> Vec<usize>) -> Vec<usize> {
    let mut seen = vec![false; count];
    let mut list = Vec::new();
    for root in roots {
        let mut stack: Vec<(usize, Vec<usize>)> = Vec::new();
        if !std::mem::replace(&mut seen[*root], true) {
            stack.push((*root, next(*root)));
        }
        while let Some((entry, pending)) = stack.last_mut() {
            if pending.is_empty() {
                list.push(*entry);
                stack.pop();
                continue;
            }
            let inner = pending.remove(0);
            if !std::mem::replace(&mut seen[inner], true) {
                stack.push((inner, next(inner)));
            }
        }
    }
    list
}

/// The kind of a type, with the image's numbers.
pub(super) fn kind(order: &Order, kind: TypeKind) -> TypeKind {
    match kind {
        TypeKind::AddOn(add_on) => TypeKind::AddOn(order.add_on(AddOnId(add_on.0))),
        other => other,
    }
}
