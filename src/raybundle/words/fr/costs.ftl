costs-measure_and_shipped = { OPTION("measure", "True") } et { OPTION("shipped", "True", flag: "no-measure") } s'excluent.

costs-no_photographs = Le nombre de photographies est inconnu.

costs-photographs_and_number = Des photographies et { OPTION("images", $n) } s'excluent.

costs-overlap_too_small = { OPTION("flight_overlap", $along, $across) } : un lieu figure sur { $n } photographies ; il en faut { $needed }.

costs-exceeded = { $what } : { $needed } nécessaires, { $given } disponibles.

costs-unread = Fichiers illisibles, non comptés : { $names }.
