check_unseen = { $n } point(s) de contrôle ont moins de deux rayons et ne sont pas comparés : { $ids }.
