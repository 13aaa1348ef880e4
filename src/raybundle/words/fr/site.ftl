site-limit_not_finite = Une limite de l'espace des stations n'est pas un nombre fini.

site-empty = L'espace des stations est vide : { $axis } de { $low_m } à { $high_m } m.
