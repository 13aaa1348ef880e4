stations-no_crs = Les stations sur une carte demandent le système de coordonnées du bloc.
