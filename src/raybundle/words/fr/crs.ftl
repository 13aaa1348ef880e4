crs-outside_area = { NUM($x, decimals: 2) }, { NUM($y, decimals: 2) } ne sont pas des coordonnées de { $system }.

crs-beyond_circle = { NUM($x, decimals: 2) }, { NUM($y, decimals: 2) } : hors de { $system }, limite { $limit }.

crs-undulation_of_ellipsoid = { $system } a déjà des hauteurs ellipsoïdales.

crs-other_datum = { $own } et { $system } diffèrent par plus que la projection.

crs-incomplete = Le système de coordonnées est incomplet.

crs-geoid_missing = { $heights } demande un géoïde qui n'est pas installé.

crs-coordinate_shape = Il faut des coordonnées de forme (n, 3), non ({ $shape }).

crs-not_transformed = Point { $number } en { NUM($x, decimals: 2) }, { NUM($y, decimals: 2) } : hors de { $system }.

crs-unknown = { $text } n'est pas un système de coordonnées connu.

crs-heights_of_proj_string = { $text } après une chaîne PROJ n'est pas pris en charge.

crs-utm_zone = La zone UTM { $zone } n'est pas entre 1 et 60.

crs-not_on_earth = { $text } n'a pas de position sur la Terre.

crs-heights_twice = { $system } définit déjà ses hauteurs.

crs-no_local_frame = { NUM($x, digits: 10) }, { NUM($y, digits: 10) } n'a pas de repère local dans { $system }.

crs-origin_height_unknown = L'altitude de l'origine est inconnue ; 0 est supposé.

crs-heights_above_geoid = Référence d'altitude : non définie par { $system } ; altitudes en { $unit } au-dessus d'un géoïde à { $undulation_m } m supposées.

crs-heights_assumed = Référence d'altitude : non définie par { $system } ; altitudes ellipsoïdales en { $unit } supposées.

crs-undulation_added = { $heights } : altitudes au-dessus du géoïde ; une ondulation constante de { $undulation_m } m est ajoutée{ $older ->
     [yes] { "" } (WGS 84)
     *[no] { "" }
    }.

crs-outside_use = { $table } : { NUM($x, digits: 10) }, { NUM($y, digits: 10) } est hors du domaine d'emploi de { $system }.

crs-needed_by_settings = { OPTION("frame_origin") } et { OPTION("undulation") } demandent un système de coordonnées.

crs-not_projected = { $system } n'est pas un système de coordonnées projeté.

crs-plane_needed = { OPTION("crs", $system) } n'est pas un système de coordonnées plan ; une carte en demande un.
