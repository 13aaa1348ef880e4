object_frame-origin_missing = L'origine du repère objet manque.

object_frame-crs_missing = Un repère projeté demande son système de coordonnées.

object_frame-not_degrees = Longitude { $longitude_deg }, latitude { $latitude_deg } : degrés non valables.

object_frame-missing = Une scène satellite demande un repère objet de position connue.

object_frame-not_local = Les hauteurs sur une carte demandent un bloc en repère local.
