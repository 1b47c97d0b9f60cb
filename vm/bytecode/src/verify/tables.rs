//! What every check looks things up in.

use alloc::vec::Vec;

use twinrung_catalog::{Controller, Element, PredefinedType};

use crate::image::{Image, TypeKind, TypeRecord, TypeReference};
use crate::index::{AddOnIndex, TypeIndex};
use crate::layout::TypeLayout;

/// The image, the layouts of its types, and what follows from the controller.
pub(super) struct Tables<'a> {
    pub(super) image: &'a Image,
    pub(super) layouts: &'a [TypeLayout],
    /// The controller; a library may leave it open.
    pub(super) controller: Option<&'static Controller>,
    /// For each type its declaration in the catalog, where it is predefined.
    pub(super) predefined: Vec<Option<&'static PredefinedType>>,
    /// For each tag whether the map copies a standard tag to it.
    pub(super) mapped: Vec<bool>,
    /// For each controller tag whether a program has a tag of that name.
    pub(super) hidden: Vec<bool>,
}

impl<'a> Tables<'a> {
    /// Whether safety data may be REAL.
    pub(super) fn has_real(&self) -> bool {
        self.controller.is_none_or(Controller::has_real)
    }

    pub(super) fn layout(&self, index: TypeIndex) -> Option<&'a TypeLayout> {
        self.layouts.get(index.position())
    }

    /// Whether a type is REAL or holds one.
    pub(super) fn holds_real(&self, type_reference: TypeReference) -> bool {
        match type_reference {
            TypeReference::Element(element) => element == Element::Real,
            TypeReference::Structure(index) => self.layout(index).is_some_and(|layout| layout.holds_real),
        }
    }

    /// Whether a type backs a call, or holds one that does.
    pub(super) fn holds_backing(&self, type_reference: TypeReference) -> bool {
        match type_reference {
            TypeReference::Element(_) => false,
            TypeReference::Structure(index) => self.layout(index).is_some_and(|layout| layout.holds_backing),
        }
    }

    /// Bytes of one element of a type in the Logix memory layout; `None` where it has none of its own.
    pub(super) fn bytes(&self, type_reference: TypeReference) -> Option<u32> {
        match type_reference {
            TypeReference::Element(Element::Bool) => None,
            TypeReference::Element(element) => Some(element.bytes()),
            TypeReference::Structure(index) => self.layout(index).map(|layout| layout.bytes).filter(|bytes| *bytes > 0),
        }
    }

    /// The Add-On Instruction whose instances have this type.
    pub(super) fn instance_of(&self, type_reference: TypeReference) -> Option<AddOnIndex> {
        let TypeReference::Structure(index) = type_reference else { return None };
        match self.image.types.get(index.position())?.kind {
            TypeKind::AddOn(add_on) => Some(add_on),
            TypeKind::Predefined | TypeKind::User => None,
        }
    }

    /// The declaration of a predefined structure.
    pub(super) fn predefined(&self, index: TypeIndex) -> Option<&'static PredefinedType> {
        self.predefined.get(index.position()).copied().flatten()
    }

    /// Whether a type is this predefined structure.
    pub(super) fn is_predefined(&self, type_reference: TypeReference, predefined: &'static PredefinedType) -> bool {
        match type_reference {
            TypeReference::Element(_) => false,
            TypeReference::Structure(index) => {
                self.predefined(index).is_some_and(|known| known.name == predefined.name)
            }
        }
    }
}

/// For each type its declaration in the catalog, where it is predefined.
pub(super) fn predefined(image: &Image) -> Vec<Option<&'static PredefinedType>> {
    let known = |record: &TypeRecord| match record.kind {
        TypeKind::Predefined => PredefinedType::by_name(&record.name),
        TypeKind::User | TypeKind::AddOn(_) => None,
    };
    image.types.iter().map(known).collect()
}
