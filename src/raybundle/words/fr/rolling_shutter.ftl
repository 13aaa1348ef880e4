rolling_shutter = Caméra { $camera } : affinité et cisaillement sont l'effet d'un obturateur déroulant.

rolling_shutter-possible = Caméra { $camera } : affinité et cisaillement sont peut-être l'effet d'un obturateur déroulant.
