worker-cluster_or_shard = Exactly one of { OPTION("cluster", "FOLDER") } and { OPTION("shard", "I/N") } is needed.
    .do = Give one of them.

# $project = "facade"
worker-project_of_cluster = A worker of a cluster does tasks of all projects, not of { $project } alone.
    .do = Leave the project out, or do a share of its tasks: { OPTION("shard", "I/N") }.

worker-project_missing = The project of the shard is not given.
    .do = Give its folder.

# $share = "'0/99999999'"
# $most = 99999
worker-too_many_shards = { $share }: at most { $most } shards are possible.
    .do = Use fewer shards.

# $share = "4/4"
worker-shard_form = { $share } is not a shard.
    .do = Number shards from 0: 0/4, 1/4, 2/4 and 3/4 of four jobs.
