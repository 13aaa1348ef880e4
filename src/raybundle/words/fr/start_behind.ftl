start_behind = { $n } points ont des rayons qui se coupent derrière une caméra dans les valeurs approchées : { $ids }.
