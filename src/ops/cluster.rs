//! `cluster`: places in a few disks.

use crate::ops::ground::Ground;
use crate::ops::spec::Varying;
use crate::ops::strategy::{not_negative, strategy};
use crate::ops::{Apply, Given, Pieces, Problem};
use crate::placement;
use crate::shape::Shape;
use crate::unit::Metres;

strategy! {
    /// Sets points in a few round clusters, each point clear of the others.
    ///
    /// Niese et al. 2022, §5.2: cluster (C). The centres lie anywhere where a plant may stand; a cluster is cut off
    /// at the edge of the shape. `place.cluster` says which.
    /// ```cga
    /// Park --> cluster(cluster_radius = 6, clusters = 4, radius = 1.6) { plant("birch") } Meadow
    /// ```
    "cluster" => pub struct Cluster {
        /// Radius of a cluster (κ), metres.
        cluster_radius: Metres [1.0, 20.0],
        /// How many clusters there are at most (π): a number is drawn for each shape.
        clusters: u32 [0.0, 5.0],
        /// Mean radius that a plant keeps for itself (μ), metres.
        radius: Varying<Metres> [1.0, 10.0],
        /// How many clusters there are at least.
        clusters_min: u32 = 1 => "1",
    }
}

impl Apply for Cluster {
    const LOOKS_AROUND: bool = true;

    fn apply(self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        let (shared, ground) = (self.shared(), Ground::of(shape)?);
        let radius = not_negative("cluster_radius", self.cluster_radius.0)?;
        let most = self.clusters as usize;
        let clusters = [self.clusters_min as usize, most];
        if clusters[0] > most.max(1) {
            let message = format!("`clusters_min` is {}, more than the {most} of `clusters`", clusters[0]);
            return Err(Problem { parameter: Some("clusters_min"), ..Problem::new(message) });
        }
        let clusters = [clusters[0].min(most), most];
        let radii = shared.radii(given.field("radius", self.radius.0.0))?;
        let site = shared.site(&ground, shape, given, &radii)?;
        let placed = placement::clusters(&site, radius, clusters, &radii, &shared.amount(given)?, given.seed);
        shared.pieces(&ground, shape, given, &radii, placed)
    }
}
