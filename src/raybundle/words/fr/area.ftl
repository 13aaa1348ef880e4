area-none = Le fichier n'a ni polygone, ni ligne, ni point.

area-too_many_points = Le contour a { $n } points ; { $most } au plus sont lus.

area-no_position = { $text } n'est pas longitude,latitude.

area-not_readable = Le fichier n'est pas lisible comme lignes ou surfaces ({ $detail }).

area-damaged = Une géométrie du fichier est endommagée.

area-no_utm = La zone est à { NUM($latitude_deg, decimals: 1) }° de latitude, hors de l'UTM.

area-not_degrees = { NUM($x, decimals: 2) }, { NUM($y, decimals: 2) } ne sont pas longitude et latitude en degrés.

area-outside_system = { NUM($x, decimals: 2) }, { NUM($y, decimals: 2) } : hors de { $system }.
