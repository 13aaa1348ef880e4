object_frame-origin_missing = L'origine du repère objet manque.

object_frame-crs_missing = Un repère projeté demande son système de coordonnées.

object_frame-not_degrees = Longitude { $longitude_deg }, latitude { $latitude_deg } : degrés non valables.

object_frame-missing = Une scène satellite demande un repère objet de position connue.

object_frame-not_local = Les hauteurs sur une carte demandent un bloc en repère local.

object_frame-needs_metres = Le bloc { $block } a un [frame] avec système de coordonnées, mais des longueurs en { $unit }.

object_frame-far_from_origin = Bloc { $block } : des coordonnées près de { NUM($x_m, digits: 6) }, { NUM($y_m, digits: 6) } m ne conviennent pas à kind = "projected".

object_frame-needs_local = Bloc { $block } : { $tables } a besoin d'un repère local ; le bloc est en coordonnées de carte.
