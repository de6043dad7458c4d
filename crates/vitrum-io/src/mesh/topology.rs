//! Topology of a mesh: edges, boundaries and connected parts.

use super::Mesh;
use super::weld::Weld;

/// Counts of a mesh's points, edges and parts. Vertices at equal positions are one point; a triangle that has a point twice joins no
/// points and is not counted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Topology {
    /// Distinct positions, those that no triangle uses among them.
    pub points: usize,
    /// Distinct pairs of points that are a triangle's edge.
    pub edges: usize,
    /// Edges of one triangle.
    pub boundary_edges: usize,
    /// Edges of three triangles and more.
    pub non_manifold_edges: usize,
    /// Edges that triangles follow more often in one direction than in the other: edges of the boundary, and edges between neighbours
    /// that face opposite ways. A mesh without such edges encloses a volume.
    pub unpaired_edges: usize,
    /// Sets of triangles that are joined by common points.
    pub parts: usize,
}

impl Topology {
    /// Whether each edge belongs to exactly two triangles, which follow it in opposite directions.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.edges > 0 && self.boundary_edges == 0 && self.non_manifold_edges == 0 && self.unpaired_edges == 0
    }
}

impl Mesh {
    /// Counts edges and parts; takes time and memory of the order of a sort of the edges.
    #[must_use]
    pub fn topology(&self) -> Topology {
        let mut weld = Weld::default();
        let points: Vec<u32> = self.positions.iter().map(|&position| weld.number(position).0).collect();
        let mut parts = Parts::new(weld.len());
        let mut uses = Vec::with_capacity(3 * self.triangles.len());
        for triangle in &self.triangles {
            let [a, b, c] = triangle.map(|vertex| points[vertex as usize]);
            if a == b || b == c || c == a {
                continue;
            }
            parts.join(a, b);
            parts.join(b, c);
            // The direction is the last bit, so that the uses of an edge are neighbours once sorted.
            uses.extend([(a, b), (b, c), (c, a)].map(|(from, to)| (from.min(to), from.max(to), from < to)));
        }
        uses.sort_unstable();
        let mut topology = Topology {
            points: weld.len(),
            edges: 0,
            boundary_edges: 0,
            non_manifold_edges: 0,
            unpaired_edges: 0,
            parts: parts.count(uses.iter().map(|&(point, ..)| point)),
        };
        for edge in uses.chunk_by(|one, next| (one.0, one.1) == (next.0, next.1)) {
            topology.edges += 1;
            topology.boundary_edges += usize::from(edge.len() == 1);
            topology.non_manifold_edges += usize::from(edge.len() > 2);
            let forward = edge.iter().filter(|(.., forward)| *forward).count();
            topology.unpaired_edges += usize::from(2 * forward != edge.len());
        }
        topology
    }

    /// Whether each edge belongs to exactly two triangles, which follow it in opposite directions.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.topology().is_closed()
    }
}

/// Sets of joined points: a forest whose trees are the sets.
struct Parts(Vec<u32>);

impl Parts {
    fn new(points: usize) -> Self {
        Self((0..points as u32).collect())
    }

    fn root(&mut self, mut point: u32) -> u32 {
        while self.0[point as usize] != point {
            let parent = self.0[point as usize];
            self.0[point as usize] = self.0[parent as usize];
            point = parent;
        }
        point
    }

    fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.root(a), self.root(b));
        // The smaller number stays root, so that the forest does not depend on the order of the two.
        self.0[a.max(b) as usize] = a.min(b);
    }

    /// Sets that hold any of the points.
    fn count(&mut self, points: impl Iterator<Item = u32>) -> usize {
        let mut roots: Vec<u32> = points.map(|point| self.root(point)).collect();
        roots.sort_unstable();
        roots.dedup();
        roots.len()
    }
}
