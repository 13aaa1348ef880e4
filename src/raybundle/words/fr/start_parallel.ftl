start_parallel = { $n } points ont des rayons presque parallèles dans les valeurs approchées : { $ids }.
