//! The judge: a third evaluator that walks the checked tree.
