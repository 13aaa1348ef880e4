worker-cluster_or_shard = Il faut exactement l'un de { OPTION("cluster", "FOLDER") } et { OPTION("shard", "I/N") }.

worker-project_of_cluster = Un worker de grappe exécute les tâches de tous les projets, pas du seul { $project }.

worker-project_missing = Le projet du lot n'est pas donné.

worker-too_many_shards = { $share } : { $most } lots au plus sont possibles.

worker-shard_form = { $share } n'est pas un lot.
