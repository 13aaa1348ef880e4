marked_lost = Le point marqué { $point } n'est pas dans le résultat : ses { $rays } rayons sont parallèles ou ne se coupent pas.
