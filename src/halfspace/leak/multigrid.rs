//! Networks of conductances between nodes, and their pressures by multigrid.

/// Part of the residual that one step of a coarser network may leave; of what is more it takes a second one.
const LEFT: f64 = 0.25;
/// Part of the strongest conductance of a node that one to a neighbour has to be for them to be joined.
const STRONG: f64 = 0.25;
/// Part of all conductances of a node that the strongest one has to be for the node to follow where that leads.
const BOUND: f64 = 0.7;
/// Part of the nodes beyond which a coarser network is no coarser one.
const COARSER: f64 = 0.9;

/// A conductance between two nodes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Link {
    pub ends: [usize; 2],
    pub conductance: f64,
}

/// Nodes, what flows between them under a difference of their pressures, and what flows off from each to a border where
/// the pressure is held.
///
/// A symmetric matrix whose off-diagonals are never positive, written by rows.
#[derive(Debug)]
pub(super) struct Network {
    /// Where the neighbours of each node begin, in rising order, and those that come after it.
    start: Vec<usize>,
    later: Vec<usize>,
    neighbour: Vec<usize>,
    conductance: Vec<f64>,
    /// To the borders.
    border: Vec<f64>,
    /// Sum of all conductances of a node.
    total: Vec<f64>,
}

impl Network {
    /// The network of these links, of which several may join the same nodes.
    pub fn new(border: Vec<f64>, links: &[Link]) -> Self {
        let nodes = border.len();
        let mut start = vec![0; nodes + 1];
        for end in links.iter().flat_map(|link| link.ends) {
            start[end + 1] += 1;
        }
        for node in 0..nodes {
            start[node + 1] += start[node];
        }
        let (mut free, mut row) = (start.clone(), vec![(0, 0.0); 2 * links.len()]);
        for link in links {
            let [one, other] = link.ends;
            for (from, to) in [(one, other), (other, one)] {
                row[free[from]] = (to, link.conductance);
                free[from] += 1;
            }
        }
        let mut network = Self {
            start: vec![0],
            later: Vec::with_capacity(nodes),
            neighbour: Vec::with_capacity(row.len()),
            conductance: Vec::with_capacity(row.len()),
            total: border.clone(),
            border,
        };
        for node in 0..nodes {
            network.append(&mut row[start[node]..start[node + 1]]);
        }
        network
    }

    /// Appends the row of the next node, conductances to the same neighbour in parallel.
    fn append(&mut self, row: &mut [(usize, f64)]) {
        row.sort_unstable_by_key(|&(to, _)| to);
        let (node, begin) = (self.start.len() - 1, self.neighbour.len());
        for &(to, conductance) in row.iter() {
            let known = self.neighbour[begin..].last() == Some(&to);
            match self.conductance.last_mut() {
                Some(last) if known => *last += conductance,
                _ => {
                    self.neighbour.push(to);
                    self.conductance.push(conductance);
                }
            }
        }
        self.total[node] += self.conductance[begin..].iter().sum::<f64>();
        let earlier = self.neighbour[begin..].partition_point(|&to| to < node);
        self.later.push(begin + earlier);
        self.start.push(self.neighbour.len());
    }

    pub fn nodes(&self) -> usize {
        self.border.len()
    }

    /// The neighbours of a node, with the conductances to them.
    fn around(&self, node: usize) -> impl Iterator<Item = (usize, f64)> {
        self.links(self.start[node], self.start[node + 1])
    }

    /// Those that come before it.
    fn earlier(&self, node: usize) -> impl Iterator<Item = (usize, f64)> {
        self.links(self.start[node], self.later[node])
    }

    /// Those that come after it.
    fn later(&self, node: usize) -> impl Iterator<Item = (usize, f64)> {
        self.links(self.later[node], self.start[node + 1])
    }

    fn links(&self, from: usize, until: usize) -> impl Iterator<Item = (usize, f64)> {
        self.neighbour[from..until].iter().copied().zip(self.conductance[from..until].iter().copied())
    }

    /// What flows out of each node under the pressures `p`, without pressure at the borders.
    pub fn outflow(&self, p: &[f64], out: &mut [f64]) {
        for (node, out) in out.iter_mut().enumerate() {
            *out = self.total[node] * p[node] - inflow(self.around(node), p);
        }
    }

    /// Σ T(Δp)² over the links between nodes.
    pub fn power(&self, p: &[f64]) -> f64 {
        let of = |node: usize| -> f64 { self.later(node).map(|(to, t)| t * (p[node] - p[to]).powi(2)).sum() };
        (0..self.nodes()).map(of).sum()
    }

    /// Takes each node to its own balance, in rising order from nothing: pressures, and the sources that they leave.
    fn relax_up(&self, source: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let mut p = vec![0.0; source.len()];
        for node in 0..p.len() {
            p[node] = (source[node] + inflow(self.earlier(node), &p)) / self.total[node];
        }
        let left = (0..p.len()).map(|node| inflow(self.later(node), &p)).collect();
        (p, left)
    }

    /// The same in falling order, from what is.
    fn relax_down(&self, source: &[f64], p: &mut [f64]) {
        for node in (0..p.len()).rev() {
            p[node] = (source[node] + inflow(self.around(node), p)) / self.total[node];
        }
    }

    /// The number of the aggregate of each node, and how many there are: pairs of nodes that are strongly joined; where
    /// these would be too few, of all that have a neighbour.
    fn aggregates(&self) -> (Vec<usize>, usize) {
        let (joined, count) = self.pairs(STRONG, BOUND);
        if count as f64 <= COARSER * self.nodes() as f64 { (joined, count) } else { self.pairs(0.0, 0.0) }
    }

    /// Joins each node with the strongest neighbour that is still alone, if that is `strong` of its strongest one, or with
    /// the aggregate of its strongest one, if that is `bound` of all. A node without neighbours stays alone.
    fn pairs(&self, strong: f64, bound: f64) -> (Vec<usize>, usize) {
        const ALONE: usize = usize::MAX;
        let (mut joined, mut count) = (vec![ALONE; self.nodes()], 0);
        for node in 0..self.nodes() {
            if joined[node] != ALONE {
                continue;
            }
            let stronger = |one: (usize, f64), other: (usize, f64)| if other.1 > one.1 { other } else { one };
            let strongest = self.around(node).reduce(stronger);
            let free = self.around(node).filter(|&(to, _)| joined[to] == ALONE).reduce(stronger);
            match (strongest, free) {
                (Some((_, most)), Some((to, conductance))) if conductance >= strong * most => joined[to] = count,
                (Some((to, most)), _) if joined[to] != ALONE && most >= bound * self.total[node] => {
                    joined[node] = joined[to];
                    continue;
                }
                _ => {}
            }
            joined[node] = count;
            count += 1;
        }
        (joined, count)
    }

    /// The network of aggregates of which each has one pressure.
    fn joined(&self, aggregate: &[usize], count: usize) -> Self {
        let mut border = vec![0.0; count];
        for (&to, conductance) in aggregate.iter().zip(&self.border) {
            border[to] += conductance;
        }
        let links: Vec<Link> = (0..self.nodes())
            .flat_map(|node| self.later(node).map(move |(to, conductance)| (node, to, conductance)))
            .filter(|&(node, to, _)| aggregate[to] != aggregate[node])
            .map(|(node, to, conductance)| Link { ends: [aggregate[node], aggregate[to]], conductance })
            .collect();
        Self::new(border, &links)
    }

    fn has_links(&self) -> bool {
        !self.neighbour.is_empty()
    }
}

/// A network, and which aggregate of the next one each of its nodes belongs to.
struct Level {
    network: Network,
    aggregate: Vec<usize>,
}

/// Ever coarser networks, of which the coarsest has no links, as a preconditioner: pairs of pairs of strongly joined
/// nodes, of which each level is solved by up to two steps of conjugate gradients (Notay, Electron. Trans. Numer. Anal.
/// 37 (2010) 123). The steps needed hardly grow with the network.
pub(super) struct Multigrid {
    finer: Vec<Level>,
    coarsest: Network,
}

impl Multigrid {
    pub fn new(network: Network) -> Self {
        let (mut finer, mut coarsest) = (Vec::new(), network);
        while coarsest.has_links() {
            let (pairs, count) = coarsest.aggregates();
            let paired = coarsest.joined(&pairs, count);
            let (again, count) = paired.aggregates();
            let next = paired.joined(&again, count);
            let aggregate = pairs.iter().map(|&pair| again[pair]).collect();
            finer.push(Level { network: std::mem::replace(&mut coarsest, next), aggregate });
        }
        Self { finer, coarsest }
    }

    /// The network that is to be solved.
    pub fn network(&self) -> &Network {
        self.finer.first().map_or(&self.coarsest, |level| &level.network)
    }

    /// Pressures that nearly balance the sources.
    pub fn precondition(&self, source: &[f64]) -> Vec<f64> {
        self.cycle(0, source)
    }

    fn at(&self, level: usize) -> &Network {
        self.finer.get(level).map_or(&self.coarsest, |level| &level.network)
    }

    /// Relaxed up, corrected by the coarser network, relaxed down.
    fn cycle(&self, level: usize, source: &[f64]) -> Vec<f64> {
        let network = self.at(level);
        let (mut p, left) = network.relax_up(source);
        let Some(Level { aggregate, .. }) = self.finer.get(level) else { return p };
        let mut gathered = vec![0.0; self.at(level + 1).nodes()];
        aggregate.iter().zip(left).for_each(|(&to, left)| gathered[to] += left);
        let correction = self.solve(level + 1, gathered);
        p.iter_mut().zip(aggregate).for_each(|(p, &from)| *p += correction[from]);
        network.relax_down(source, &mut p);
        p
    }

    /// One step of conjugate gradients, or two.
    fn solve(&self, level: usize, mut source: Vec<f64>) -> Vec<f64> {
        let mut first = self.cycle(level, &source);
        let network = self.at(level);
        if !network.has_links() {
            return first;
        }
        let mut image = vec![0.0; first.len()];
        network.outflow(&first, &mut image);
        let (slope, curvature, whole) = (dot(&first, &source), dot(&first, &image), dot(&source, &source));
        if curvature <= 0.0 {
            return first;
        }
        source.iter_mut().zip(&image).for_each(|(source, image)| *source -= slope / curvature * image);
        if dot(&source, &source) <= LEFT * LEFT * whole {
            first.iter_mut().for_each(|p| *p *= slope / curvature);
            return first;
        }
        let second = self.cycle(level, &source);
        let across = dot(&second, &image);
        network.outflow(&second, &mut image);
        let (rest, length) = (dot(&second, &source), dot(&second, &image) - across * across / curvature);
        let along = if length > 0.0 { rest / length } else { 0.0 };
        let back = (slope - across * along) / curvature;
        first.iter_mut().zip(&second).for_each(|(first, second)| *first = back * *first + along * second);
        first
    }
}

/// What flows into a node under the pressures `p` of its neighbours.
fn inflow(around: impl Iterator<Item = (usize, f64)>, p: &[f64]) -> f64 {
    around.map(|(to, conductance)| conductance * p[to]).sum()
}

pub(super) fn dot(one: &[f64], other: &[f64]) -> f64 {
    one.iter().zip(other).map(|(one, other)| one * other).sum()
}
