//! Building blocks by themselves: one kernel that maps a function over a buffer, so that every function can be held against the other
//! backend over millions of inputs (conformance tier T0).

pub mod apply_function;
pub mod functions;
