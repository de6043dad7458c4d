//! The nodes of a scene, from its roots down.

use glam::DAffine3;

use super::accessor::Files;
use super::buffers::Buffers;
use super::document::Document;
use super::lookup::lookup;
use super::transform::of_node;
use crate::error::{Error, Place};
use crate::mesh::build::Builder;

/// Putting all meshes of the scene into one.
pub(super) struct Assembly<'a, 'b> {
    pub files: Files<'a>,
    pub builder: &'a mut Builder<'b>,
    /// For each material of the document, its index in the mesh; the last entry is the index of the material for triangles without one.
    pub materials: Vec<Option<u32>>,
    /// Primitives of points and lines, or without positions.
    pub left_out: u64,
    pub joints: u64,
    pub targets: bool,
}

impl<'a, 'b> Assembly<'a, 'b> {
    pub fn new(document: &'a Document, buffers: &'a Buffers<'a>, builder: &'a mut Builder<'b>) -> Self {
        let materials = vec![None; document.materials.len() + 1];
        let files = Files { document, buffers };
        Self { files, builder, materials, left_out: 0, joints: 0, targets: false }
    }

    pub fn assemble(mut self) -> Result<(), Error> {
        let report = self.builder.report;
        let document = self.files.document;
        let mut stack = self.roots()?;
        // Nodes are a forest. One that is reached twice is in a cycle, or has two parents.
        let mut reached = vec![false; document.nodes.len()];
        while let Some((index, from, parent)) = stack.pop() {
            let node = lookup(report, &document.nodes, "nodes", index, || from.describe())?;
            if std::mem::replace(&mut reached[index], true) {
                return Err(report.invalid(
                    Place::File,
                    format!("nodes[{index}] is reached twice: it is its own ancestor, or has two parents"),
                    "make the nodes a tree",
                ));
            }
            let transform = parent * of_node(node);
            if let Some(mesh) = node.mesh {
                self.add_mesh(mesh, &transform, || format!("nodes[{index}].mesh"))?;
            }
            // The first child is the next to be popped.
            stack.extend(node.children.iter().rev().map(|&child| (child, Origin::Node(index), transform)));
        }
        self.note();
        Ok(())
    }

    /// The nodes to start from.
    fn roots(&mut self) -> Result<Vec<(usize, Origin, DAffine3)>, Error> {
        let document = self.files.document;
        let with = |nodes: &[usize], origin| {
            nodes.iter().rev().map(|&node| (node, origin, DAffine3::IDENTITY)).collect::<Vec<_>>()
        };
        if !document.scenes.is_empty() || document.scene.is_some() {
            let index = document.scene.unwrap_or(0);
            let scene = lookup(self.builder.report, &document.scenes, "scenes", index, || "scene".to_owned())?;
            if document.scenes.len() > 1 {
                let note = format!("of {} scenes, number {index}, counted from 0, was read", document.scenes.len());
                self.builder.assumptions.push(note);
            }
            return Ok(with(&scene.nodes, Origin::Scene(index)));
        }
        if document.nodes.is_empty() {
            for mesh in 0..document.meshes.len() {
                self.add_mesh(mesh, &DAffine3::IDENTITY, String::new)?;
            }
            self.builder.assumptions.push("there are no scenes and nodes: each mesh was read once".to_owned());
            return Ok(Vec::new());
        }
        let mut is_child = vec![false; document.nodes.len()];
        for &child in document.nodes.iter().flat_map(|node| &node.children) {
            // Others are told where they are reached.
            if let Some(is_child) = is_child.get_mut(child) {
                *is_child = true;
            }
        }
        let roots: Vec<_> = (0..is_child.len()).filter(|&node| !is_child[node]).collect();
        if roots.is_empty() {
            let problem = "each node is the child of another: they go round in a circle";
            return Err(self.builder.report.invalid(Place::File, problem, "make the nodes a tree"));
        }
        self.builder.assumptions.push("there are no scenes: all nodes were read".to_owned());
        Ok(with(&roots, Origin::Scene(0)))
    }

    fn add_mesh(&mut self, index: usize, transform: &DAffine3, from: impl FnOnce() -> String) -> Result<(), Error> {
        let mesh = lookup(self.builder.report, &self.files.document.meshes, "meshes", index, from)?;
        for (number, primitive) in mesh.primitives.iter().enumerate() {
            self.targets |= !primitive.targets.is_empty();
            self.add_primitive(primitive, transform, &format!("meshes[{index}].primitives[{number}]"))?;
        }
        Ok(())
    }

    fn note(&mut self) {
        let document = self.files.document;
        let notes = &mut self.builder.assumptions;
        if self.left_out > 0 {
            notes.push(format!(
                "{} primitives that are points, lines or without positions were left out",
                self.left_out
            ));
        }
        notes.extend(crate::mesh::strip::joints_note(self.joints));
        let mut note = |is_there: bool, what: &str| {
            if is_there {
                notes.push(format!("{what} were left out: meshes are as they are stored"));
            }
        };
        note(!document.textures.is_empty(), "textures");
        note(!document.skins.is_empty(), "skins");
        note(!document.animations.is_empty(), "animations");
        note(self.targets, "morph targets");
    }
}

/// Who names a node.
#[derive(Debug, Clone, Copy)]
enum Origin {
    Scene(usize),
    Node(usize),
}

impl Origin {
    fn describe(self) -> String {
        match self {
            Self::Scene(index) => format!("a node of scenes[{index}]"),
            Self::Node(index) => format!("a child of nodes[{index}]"),
        }
    }
}
