variance_groups = Chacun des { $n } groupes d'observations a son propre facteur de variance.

variance_groups-unsettled = Des groupes d'observations se contredisent ; leurs facteurs de variance ne convergent pas.

variance_groups-group = { observations-kind } ({ $group }) : écarts-types × { NUM($factor, digits: 3) } ({ $count } valeurs, redondance { NUM($redundancy, digits: 3) })

variance_groups-as_given = { observations-kind } ({ $group }) : écarts-types comme donnés ({ $count } valeurs, redondance { NUM($redundancy, digits: 3) })
