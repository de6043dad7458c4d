//! Strongly connected components of a directed graph.
//!
//! Tarjan, "Depth-First Search and Linear Graph Algorithms", SIAM Journal on Computing 1 (1972).

use std::collections::BTreeSet;

/// The sets of nodes that reach each other along `arrows`, each in ascending order. Every node is in one of them.
pub fn components(nodes: usize, arrows: &BTreeSet<(usize, usize)>) -> Vec<Vec<usize>> {
    let mut search = Search {
        arrows,
        order: vec![None; nodes],
        lowest: vec![0; nodes],
        open: Vec::new(),
        found: Vec::new(),
        next: 0,
    };
    for node in 0..nodes {
        if search.order[node].is_none() {
            search.visit(node);
        }
    }
    search.found
}

/// A depth-first search in progress.
struct Search<'a> {
    arrows: &'a BTreeSet<(usize, usize)>,
    /// When a node was first visited.
    order: Vec<Option<usize>>,
    /// The earliest visited node that a node reaches among the open ones.
    lowest: Vec<usize>,
    /// Visited nodes whose component is not complete.
    open: Vec<usize>,
    found: Vec<Vec<usize>>,
    next: usize,
}

impl Search<'_> {
    /// Visits a node and all that it reaches. The depth is at most the number of files of a crate.
    fn visit(&mut self, node: usize) {
        self.order[node] = Some(self.next);
        self.lowest[node] = self.next;
        self.next += 1;
        self.open.push(node);
        for &(_, to) in self.arrows.range((node, 0)..(node + 1, 0)) {
            match self.order[to] {
                None => {
                    self.visit(to);
                    self.lowest[node] = self.lowest[node].min(self.lowest[to]);
                }
                Some(order) if self.open.contains(&to) => self.lowest[node] = self.lowest[node].min(order),
                Some(_) => {}
            }
        }
        if Some(self.lowest[node]) == self.order[node] {
            let start = self.open.iter().position(|&other| other == node).unwrap_or(0);
            let mut component = self.open.split_off(start);
            component.sort_unstable();
            self.found.push(component);
        }
    }
}
