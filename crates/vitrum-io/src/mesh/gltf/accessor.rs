//! Accessors: typed numbers in buffers.

use std::collections::HashMap;

use super::buffers::Buffers;
use super::document::{Accessor, Document, Sparse};
use super::lookup::lookup;
use crate::error::{Error, Place, clip};
use crate::mesh::build::Builder;

/// The type of a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Component {
    I8,
    U8,
    I16,
    U16,
    U32,
    F32,
}

impl Component {
    fn new(code: u32) -> Option<Self> {
        Some(match code {
            5120 => Self::I8,
            5121 => Self::U8,
            5122 => Self::I16,
            5123 => Self::U16,
            5125 => Self::U32,
            5126 => Self::F32,
            _ => return None,
        })
    }

    fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::U32 | Self::F32 => 4,
        }
    }

    /// The number that starts `bytes`, which are enough.
    fn float(self, bytes: &[u8], normalized: bool) -> f32 {
        let (value, largest) = match self {
            Self::I8 => (f32::from(bytes[0] as i8), 127.0),
            Self::U8 => (f32::from(bytes[0]), 255.0),
            Self::I16 => (f32::from(i16::from_le_bytes([bytes[0], bytes[1]])), 32767.0),
            Self::U16 => (f32::from(u16::from_le_bytes([bytes[0], bytes[1]])), 65535.0),
            Self::U32 => (self.index(bytes) as f32, 1.0),
            Self::F32 => return f32::from_bits(self.index(bytes)),
        };
        if normalized { (value / largest).max(-1.0) } else { value }
    }

    /// The bits of the unsigned number that starts `bytes`, which are enough.
    fn index(self, bytes: &[u8]) -> u32 {
        match self.size() {
            1 => u32::from(bytes[0]),
            2 => u32::from(u16::from_le_bytes([bytes[0], bytes[1]])),
            _ => u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]),
        }
    }
}

/// An accessor whose bytes are there.
#[derive(Debug)]
pub(super) struct Values<'a> {
    pub count: u32,
    /// Numbers of an element.
    pub width: usize,
    component: Component,
    normalized: bool,
    /// The dense elements and the distance between two of them; an accessor without them has zeros.
    dense: Option<(&'a [u8], usize)>,
    /// The sparse elements, by index, which replace dense ones.
    sparse: HashMap<u32, &'a [u8]>,
}

/// A document and its buffers, in which accessors lie.
#[derive(Clone, Copy)]
pub(super) struct Files<'a> {
    pub document: &'a Document,
    pub buffers: &'a Buffers<'a>,
}

impl<'a> Files<'a> {
    /// An accessor of one of `kinds`, such as `VEC3`; `from` says who names it.
    pub fn values(self, builder: &Builder, index: usize, kinds: &[&str], from: &str) -> Result<Values<'a>, Error> {
        let report = builder.report;
        let accessor = lookup(report, &self.document.accessors, "accessors", index, || from.to_owned())?;
        let name = format!("accessors[{index}]");
        let wrong = |problem: String| report.invalid(Place::File, format!("{name} {problem}"), "correct the accessor");
        if !kinds.contains(&accessor.kind.as_str()) {
            return Err(wrong(format!(
                "is `{}`, not {}, as {from} asks for",
                clip(&accessor.kind),
                kinds.join(" or ")
            )));
        }
        let component = Component::new(accessor.component_type);
        let component = component.ok_or_else(|| wrong(format!("has the unknown type {}", accessor.component_type)))?;
        let width = if accessor.kind == "SCALAR" { 1 } else { usize::from(accessor.kind.as_bytes()[3] - b'0') };
        let count = u32::try_from(accessor.count).ok().filter(|&count| count > 0);
        let count = count.ok_or_else(|| wrong(format!("has {} elements, not 1 to {}", accessor.count, u32::MAX)))?;
        let mut values =
            Values { count, width, component, normalized: accessor.normalized, dense: None, sparse: HashMap::new() };
        let size = values.element_size();
        if let Some(view) = accessor.buffer_view {
            values.dense = Some(self.elements(builder, accessor, view, size, &name)?);
        }
        match &accessor.sparse {
            Some(sparse) => values.sparse = self.sparse(builder, sparse, &values, &name)?,
            None if accessor.buffer_view.is_none() => {
                return Err(wrong("has neither `bufferView` nor `sparse`".to_owned()));
            }
            None => {}
        }
        Ok(values)
    }

    /// Bytes from the first element on, enough for all, and the distance between elements.
    fn elements(
        self,
        builder: &Builder,
        accessor: &Accessor,
        view: usize,
        size: usize,
        name: &str,
    ) -> Result<(&'a [u8], usize), Error> {
        let bytes = self.buffers.view(builder, self.document, view, name)?;
        // `view` has found it there.
        let stride = self.document.buffer_views[view].byte_stride.unwrap_or(size as u64);
        let wrong =
            |problem| builder.report.invalid(Place::File, problem, "correct the accessor, or get the whole file");
        if stride < size as u64 {
            return Err(wrong(format!(
                "bufferViews[{view}].byteStride is {stride}, and {name} has elements of {size} bytes"
            )));
        }
        let needed =
            u128::from(accessor.byte_offset) + u128::from(accessor.count - 1) * u128::from(stride) + size as u128;
        if needed > bytes.len() as u128 {
            return Err(wrong(format!(
                "{name} needs {needed} bytes of bufferViews[{view}], which has {}",
                bytes.len()
            )));
        }
        // Both are below the length of `bytes`, the stride unless there is one element alone.
        Ok((&bytes[accessor.byte_offset as usize..], usize::try_from(stride).unwrap_or(usize::MAX)))
    }

    fn sparse(
        self,
        builder: &Builder,
        sparse: &Sparse,
        values: &Values,
        name: &str,
    ) -> Result<HashMap<u32, &'a [u8]>, Error> {
        let wrong = |problem: String| {
            builder.report.invalid(Place::File, format!("{name}.sparse {problem}"), "correct the accessor")
        };
        let types = [Component::U8, Component::U16, Component::U32];
        let index_type = sparse.indices.component_type.and_then(Component::new).filter(|one| types.contains(one));
        let index_type = index_type.ok_or_else(|| wrong("has indices of no unsigned type".to_owned()))?;
        let part = |part: &super::document::SparsePart, size: usize, what: &str| {
            let bytes =
                self.buffers.view(builder, self.document, part.buffer_view, &format!("{name}.sparse.{what}"))?;
            let rest =
                usize::try_from(part.byte_offset).ok().and_then(|offset| bytes.get(offset..)).unwrap_or_default();
            let fits = sparse.count.checked_mul(size as u64).is_some_and(|needed| needed <= rest.len() as u64);
            if fits {
                Ok(rest)
            } else {
                Err(wrong(format!("promises {} {what}, and {} bytes are there", sparse.count, rest.len())))
            }
        };
        let indices = part(&sparse.indices, index_type.size(), "indices")?;
        let elements = part(&sparse.values, values.element_size(), "values")?;
        // About what an entry takes.
        builder.budget.check(48 * sparse.count)?;
        let pairs = indices.chunks_exact(index_type.size()).zip(elements.chunks_exact(values.element_size()));
        pairs
            .take(sparse.count as usize)
            .map(|(index, element)| match index_type.index(index) {
                index if index < values.count => Ok((index, element)),
                index => Err(wrong(format!("names element {index} of {}", values.count))),
            })
            .collect()
    }
}

impl Values<'_> {
    fn element_size(&self) -> usize {
        self.width * self.component.size()
    }

    /// The bytes of an element; `None` where it is zeros.
    fn element(&self, index: u32) -> Option<&[u8]> {
        let sparse = if self.sparse.is_empty() { None } else { self.sparse.get(&index).copied() };
        sparse.or_else(|| self.dense.map(|(bytes, stride)| &bytes[index as usize * stride..][..self.element_size()]))
    }

    /// The first `COUNT` numbers of an element, which is below the count; `rest` where it has fewer.
    pub fn floats<const COUNT: usize>(&self, index: u32, rest: f32) -> [f32; COUNT] {
        let size = self.component.size();
        let element = self.element(index);
        std::array::from_fn(|number| match element {
            _ if number >= self.width => rest,
            Some(bytes) => self.component.float(&bytes[number * size..], self.normalized),
            None => 0.0,
        })
    }

    /// The elements as whole numbers; `None` where their type is signed or a float.
    pub fn indices(&self) -> Option<impl Iterator<Item = u32>> {
        let is_index = matches!(self.component, Component::U8 | Component::U16 | Component::U32);
        let index = |at| self.element(at).map_or(0, |bytes| self.component.index(bytes));
        is_index.then(|| (0..self.count).map(index))
    }
}
