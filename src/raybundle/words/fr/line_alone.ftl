line_alone = { $n } trajectoire(s) avec des lignes d'une seule direction de visée : { $ids }.
