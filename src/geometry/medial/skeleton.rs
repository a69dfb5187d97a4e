//! A skeleton as a graph, and the branches that are left of it after pruning.

use crate::geometry::medial::Branch;
use glam::DVec2;

/// A point of the axis.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bead {
    pub point: DVec2,
    /// Its distance to the rim, metres.
    pub clearance: f64,
}

/// A piece of the axis between two nodes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Link {
    pub ends: [u32; 2],
    /// The range of its inner points in the skeleton's beads.
    pub inner: [u32; 2],
}

/// Nodes and the links between them.
#[derive(Clone, Debug, Default)]
pub(super) struct Skeleton {
    pub nodes: Vec<Bead>,
    pub links: Vec<Link>,
    pub beads: Vec<Bead>,
}

/// Links in a row, each with whether it is walked from its second end to its first.
struct Chain {
    ends: [u32; 2],
    steps: Vec<(u32, bool)>,
}

impl Skeleton {
    /// The branches that stay, numbered from `first` node on. Linear in each round of pruning.
    pub fn branches(&self, prune: f64, part: u32, first: u32) -> Vec<Branch> {
        let lengths: Vec<f64> = self.links.iter().map(|link| self.length(link)).collect();
        let mut alive = vec![true; self.links.len()];
        let mut web = Web::new(self, &alive);
        let mut lone: Vec<u32> = (0..self.nodes.len() as u32).filter(|node| web.degree(*node) == 0).collect();
        loop {
            let chains = web.chains(self, &alive);
            let doomed: Vec<&Chain> =
                chains.iter().filter(|chain| self.is_short(chain, &web, &lengths, prune)).collect();
            if doomed.is_empty() {
                let points = lone.iter().map(|node| self.point(*node, part, first));
                return chains.iter().map(|chain| self.branch(chain, part, first)).chain(points).collect();
            }
            doomed.iter().flat_map(|chain| &chain.steps).for_each(|(link, _)| alive[*link as usize] = false);
            let mut junctions: Vec<u32> = doomed.iter().map(|chain| web.junction(chain)).collect();
            junctions.sort_unstable();
            junctions.dedup();
            web = Web::new(self, &alive);
            // A junction that loses all its branches is what remains of them.
            lone.extend(junctions.into_iter().filter(|node| web.degree(*node) == 0));
        }
    }

    /// Whether a chain ends blindly at one side and is short for its junction at the other.
    fn is_short(&self, chain: &Chain, web: &Web, lengths: &[f64], prune: f64) -> bool {
        let [a, b] = chain.ends.map(|node| web.degree(node));
        if (a == 1) == (b == 1) {
            return false;
        }
        let length: f64 = chain.steps.iter().map(|(link, _)| lengths[*link as usize]).sum();
        length < prune * self.nodes[web.junction(chain) as usize].clearance
    }

    fn length(&self, link: &Link) -> f64 {
        let mut last = self.nodes[link.ends[0] as usize].point;
        let inner = self.beads[link.inner[0] as usize..link.inner[1] as usize].iter();
        inner.chain([&self.nodes[link.ends[1] as usize]]).fold(0.0, |sum, bead| {
            let step = last.distance(bead.point);
            last = bead.point;
            sum + step
        })
    }

    /// The axis that is a single point.
    fn point(&self, node: u32, part: u32, first: u32) -> Branch {
        let bead = self.nodes[node as usize];
        let nodes = [first + node; 2];
        Branch { points: vec![bead.point], clearances: vec![bead.clearance], nodes, part }
    }

    fn branch(&self, chain: &Chain, part: u32, first: u32) -> Branch {
        let start = self.nodes[chain.ends[0] as usize];
        let (mut points, mut clearances) = (vec![start.point], vec![start.clearance]);
        let mut push = |bead: &Bead| {
            points.push(bead.point);
            clearances.push(bead.clearance);
        };
        for (link, back) in &chain.steps {
            let link = &self.links[*link as usize];
            let inner = &self.beads[link.inner[0] as usize..link.inner[1] as usize];
            if *back {
                inner.iter().rev().for_each(&mut push)
            } else {
                inner.iter().for_each(&mut push)
            }
            push(&self.nodes[link.ends[usize::from(!*back)] as usize]);
        }
        Branch { points, clearances, nodes: chain.ends.map(|node| first + node), part }
    }
}

/// The living links of each node, in one buffer.
struct Web {
    starts: Vec<u32>,
    links: Vec<u32>,
}

impl Web {
    fn new(skeleton: &Skeleton, alive: &[bool]) -> Web {
        let living = || skeleton.links.iter().enumerate().filter(|(i, _)| alive[*i]);
        let mut starts = vec![0u32; skeleton.nodes.len() + 1];
        living().flat_map(|(_, link)| link.ends).for_each(|node| starts[node as usize + 1] += 1);
        for i in 1..starts.len() {
            starts[i] += starts[i - 1];
        }
        let mut links = vec![0; starts[skeleton.nodes.len()] as usize];
        let mut next = starts.clone();
        for (i, link) in living() {
            for node in link.ends {
                links[next[node as usize] as usize] = i as u32;
                next[node as usize] += 1;
            }
        }
        Web { starts, links }
    }

    fn of(&self, node: u32) -> &[u32] {
        &self.links[self.starts[node as usize] as usize..self.starts[node as usize + 1] as usize]
    }

    fn degree(&self, node: u32) -> usize {
        self.of(node).len()
    }

    /// The end of a chain that is not blind.
    fn junction(&self, chain: &Chain) -> u32 {
        if self.degree(chain.ends[0]) == 1 { chain.ends[1] } else { chain.ends[0] }
    }

    /// Every living link in a chain between nodes where not just two meet; loops without such a node come last.
    fn chains(&self, skeleton: &Skeleton, alive: &[bool]) -> Vec<Chain> {
        let mut free = alive.to_vec();
        let mut chains = Vec::new();
        let nodes = 0..skeleton.nodes.len() as u32;
        let ends = nodes.clone().filter(|node| self.degree(*node) != 2);
        for node in ends.chain(nodes) {
            for link in self.of(node) {
                if free[*link as usize] {
                    chains.push(self.walk(skeleton, &mut free, node, *link));
                }
            }
        }
        chains
    }

    fn walk(&self, skeleton: &Skeleton, free: &mut [bool], start: u32, first: u32) -> Chain {
        let mut steps = Vec::new();
        let (mut node, mut next) = (start, Some(first));
        while let Some(link) = next {
            free[link as usize] = false;
            let ends = skeleton.links[link as usize].ends;
            let back = ends[1] == node && ends[0] != ends[1];
            steps.push((link, back));
            node = ends[usize::from(!back)];
            let goes_on = self.degree(node) == 2 && node != start;
            next = self.of(node).iter().copied().find(|link| goes_on && free[*link as usize]);
        }
        Chain { ends: [start, node], steps }
    }
}
