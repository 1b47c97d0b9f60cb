//! Defects as mutants of the functions that they lie in, so that one build holds many.

use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use twinrung_mutants::{Function, Mutant, Place, Span};

use crate::{Defect, Misfit};

/// A defect as a mutant of the innermost function around it.
///
/// # Errors
///
/// What keeps it from being put into this text.
pub fn mutant(defect: &Defect, text: &str) -> Result<Mutant, Misfit> {
    defect.applied(text)?;
    let at = text.find(&defect.find).ok_or(Misfit::Stands(0))?;
    let span = Span { start: Place::of(text, at), end: Place::of(text, at + defect.find.len()) };
    let mut around = Around { span, innermost: None };
    // What is no Rust, as the ladder half of the library, has no functions.
    if let Ok(file) = syn::parse_file(text) {
        around.visit_file(&file);
    }
    Ok(Mutant {
        name: defect.name.clone(),
        file: defect.file.clone(),
        function: around.innermost.map(|span| Function { span }),
        span,
        replacement: defect.replace.clone(),
    })
}

/// Looks for the innermost function around a part of a file.
struct Around {
    span: Span,
    innermost: Option<Span>,
}

impl Around {
    /// Functions are visited from the outer to the inner.
    fn function(&mut self, item: &impl Spanned) {
        let (start, end) = (item.span().start(), item.span().end());
        let place = |at: proc_macro2::LineColumn| Place { line: at.line, column: at.column + 1 };
        let whole = Span { start: place(start), end: place(end) };
        if whole.start <= self.span.start && self.span.end <= whole.end {
            self.innermost = Some(whole);
        }
    }
}

impl<'ast> Visit<'ast> for Around {
    fn visit_item_fn(&mut self, item: &'ast syn::ItemFn) {
        self.function(item);
        visit::visit_item_fn(self, item);
    }

    fn visit_impl_item_fn(&mut self, item: &'ast syn::ImplItemFn) {
        self.function(item);
        visit::visit_impl_item_fn(self, item);
    }

    fn visit_trait_item_fn(&mut self, item: &'ast syn::TraitItemFn) {
        self.function(item);
        visit::visit_trait_item_fn(self, item);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn defect(find: &str) -> Defect {
        let [name, file, why] = ["a", "vm/primary/src/a.rs", "no"].map(str::to_owned);
        Defect { name, file, find: find.to_owned(), replace: "0".to_owned(), why }
    }

    const TEXT: &str = "const A: u8 = 1;\n\nimpl B {\n    /// Says ä.\n    fn c() -> u8 {\n        fn d() -> u8 { 2 }\n        d() + 3\n    }\n}\n";

    #[test]
    fn defect_when_it_lies_in_functions_then_it_is_a_mutant_of_the_innermost() {
        let function = |find: &str| {
            let mutant = mutant(&defect(find), TEXT).unwrap();
            let bytes = mutant.function.and_then(|function| function.span.bytes(TEXT));
            (&TEXT[mutant.span.bytes(TEXT).unwrap()], bytes.map(|bytes| &TEXT[bytes]))
        };
        let (inner, outer) = (function("2"), function("d() + 3"));
        assert_eq!(inner, ("2", Some("fn d() -> u8 { 2 }")));
        assert_eq!(outer.0, "d() + 3");
        assert!(outer.1.is_some_and(|text| text.starts_with("/// Says ä.\n") && text.ends_with("d() + 3\n    }")));
        assert_eq!(function("1"), ("1", None));
    }

    #[test]
    fn defect_when_its_file_is_no_rust_then_it_lies_in_no_function() {
        assert!(mutant(&defect("XIC(A)"), "N: XIC(A)OTE(B);").unwrap().function.is_none());
    }

    #[test]
    fn defect_when_its_text_stands_twice_then_it_is_no_mutant() {
        assert_eq!(mutant(&defect("u8"), TEXT).unwrap_err(), Misfit::Stands(3));
    }
}
