worker-cluster_or_shard = Genau eines von { OPTION("cluster", "FOLDER") } und { OPTION("shard", "I/N") } ist nötig.
    .do = Eines davon angeben.

worker-project_of_cluster = Ein Worker eines Clusters bearbeitet Aufgaben aller Projekte, nicht nur von { $project }.
    .do = Das Projekt weglassen oder einen Teil seiner Aufgaben bearbeiten: { OPTION("shard", "I/N") }.

worker-project_missing = Das Projekt des Teils ist nicht angegeben.
    .do = Seinen Ordner angeben.

worker-too_many_shards = { $share }: Höchstens { $most } Teile sind möglich.
    .do = Weniger Teile verwenden.

worker-shard_form = { $share } ist kein Teil (shard).
    .do = Teile ab 0 nummerieren: 0/4, 1/4, 2/4 und 3/4 von vier Jobs.
