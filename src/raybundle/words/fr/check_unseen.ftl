check_unseen = { $n } point(s) de contrôle ont moins de deux rayons et ne sont pas comparés : { $ids }.

check_unseen-no_measurement = { $n } point(s) de contrôle sans mesure image utilisable : { $ids }.
