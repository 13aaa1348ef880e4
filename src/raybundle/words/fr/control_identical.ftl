control_identical = { $pairs } paire(s) de points d'appui aux mêmes coordonnées sont des points différents : { $ids }.

control_identical-alike = { $pairs } paire(s) de points d'appui ont les mêmes coordonnées à leur écart-type près : { $ids }.

control_identical-pair = Une paire est formée par { $first } et { $second }.

control_identical-pair_apart = { $first } et { $second } : { NUM($apart_px, decimals: 0) } px d'écart dans l'image { $image }
