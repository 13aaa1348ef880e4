contour-too_many_levels = Les altitudes couvrent { $n } niveaux de courbes ; { $most } au plus sont tracés.
