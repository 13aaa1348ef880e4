scene-orientation_given = Image { $image } : scène satellite ; son orientation est dans le fichier de la scène.

scene-second_image = Caméra { $camera } : scène satellite, a déjà une image.

scene-size_unknown = Le fichier de la scène ne contient pas la taille de l'image.

scene-no_rpc = { $scene } n'a pas de RPC.

scene-no_rigorous_model = { $scene } n'a pas de modèle rigoureux pris en charge.

scene-file_gone = Caméra { $camera } : le fichier de sa scène ({ $scene }) manque ; le bloc ne peut être écrit.

scene-companion_gone = Caméra { $camera } : { $scene } renvoie à ce fichier, qui manque.

scene-length_unit = Les scènes satellitaires demandent length_unit = "m", pas "{ $unit }".

scene-file_elsewhere = { $name } n'est pas le nom d'un fichier dans le dossier de ce fichier.

scene-keys_exclusive = Cette clé et { $other } s'excluent.

scene-crs_superfluous = La table a longitude et latitude, qui n'exigent pas de système de coordonnées.

scene-crs_missing = Le système de coordonnées des positions X, Y, Z manque.

scene-format_unknown = Le format de la scène satellite est inconnu.

scene-pixel_count = { NUM($value, digits: 6) } n'est pas un nombre possible de pixels.

scene-position_count = Positions de l'orbite : { $n } ; il en faut au moins { $least }.

scene-attitude_count = Attitudes : { $n } ; il en faut au moins { $least }.

scene-not_an_orbit = Une position est à { NUM($distance_m, digits: 6) } m du centre de la Terre (limites { $least_m } à { $most_m } m).

scene-no_look_angles = Les directions de visée ({ $element }) manquent.

scene-no_picture = La scène n'a pas d'image.

scene-look_angle_count = Directions de visée : { $n } ; l'image a { $columns } colonnes.

scene-detector_order = Le détecteur { NUM($number, digits: 6) } n'est pas à sa place : la table a une lacune.

scene-same_time = Deux positions ont le même temps.

scene-models_contradict = { $scene } : le modèle rigoureux et le RPC diffèrent de { $meets ->
     [yes] { NUM($rms_px, digits: 4) } px (moyenne quadratique)
     *[no] plus que l'image
    }, limite { $limit_px } px.

scene-rpc_preferred = Seul le RPC est utilisé : le modèle rigoureux diffère de { $meets ->
     [yes] { NUM($rms_px, digits: 4) } px (moyenne quadratique)
     *[no] plus que l'image
    }, limite { $limit_px } px.

scene-no_geometry = Le fichier ne contient ni RPC ni modèle rigoureux utilisable.

scene-rpc_range_adapted = Le RPC a été récrit pour l'étendue de cette image, une partie de scène.

scene-one_band = La scène a { $n } bandes ; les directions de visée de la bande { $band } sont utilisées.

scene-model_missing = La scène n'a pas de { $model ->
        [rpc] RPC
       *[rigorous] modèle rigoureux
     }.

scene-none_here = Il n'y a pas de scène ici : ni image avec RPC, ni fichier de RPC.

scene-none_corrected = Aucune scène sur { $n } ne peut être corrigée :

scene-not_corrected = La scène { $scene } n'est pas corrigée :

scene-name_twice = Deux scènes s'appellent { $name }.

scene-rpc_missing = La scène n'a pas de RPC.

scene-height_range_missing = La plage d'altitudes est inconnue : la scène n'a pas de RPC.

scene-original_rpc = Le fichier des RPC d'origine existe déjà ; il n'est jamais écrasé.

scene-no_geotiff = Ce n'est pas un GeoTIFF ; des RPC ne s'écrivent que dans un GeoTIFF.

scene-rpc_of_no_picture = { OPTION("rpc") } va avec une image ; ceci n'en est pas une.

scene-object_without_rpc = Ni l'objet de type { $kind } ni son fichier n'ont de RPC.

scene-rpc_not_in_picture = Il n'y a pas de RPC dans cette image (étiquette 50844) ni à côté.

scene-outside_map = La scène ne montre aucune partie de la zone de la carte.

scene-map_too_large = La carte a { $width_px } x { $height_px } px de { $bands } bandes, trop pour la mémoire.

scene-no_data_type = { OPTION("nodata", $value) } n'est pas une valeur de type { $type }, celui des pixels.

scene-single = Il y a une scène de satellite et aucune photographie ; il faut deux images du même terrain.

scene-no_tie_points = { $n } scènes utilisables sans points de liaison et sans points d'appui marqués.

scene-middle = Scène { $scene } : centre à { NUM($longitude_deg, decimals: 3) }° de longitude, { NUM($latitude_deg, decimals: 3) }° de latitude.

scene-control_far_away = Des points d'appui marqués dans cette scène sont loin en dehors.

scene-control_shifted = { $n } points d'appui marqués sont décalés de { NUM($dx_px, decimals: 0) }, { NUM($dy_px, decimals: 0) } px (limite { NUM($limit_x_px, decimals: 0) }, { NUM($limit_y_px, decimals: 0) } px).

scene-control_scattered = { $n } points d'appui marqués se dispersent de { NUM($spread_x_px, decimals: 1) }, { NUM($spread_y_px, decimals: 1) } px.

scene-pixels_not_supported = Les pixels des fichiers { $suffix } ne sont pas lus.

scene-other_size = L'image a { $width_px } x { $height_px } px, { $model } est pour { $model_width_px } x { $model_height_px } px.

scene-all_zero = L'image n'a aucune valeur de gris supérieure à 0.

scene-no_texture = L'image n'a pas de texture.

scene-outside_system = La scène à { NUM($longitude_deg, decimals: 4) }° de longitude, { NUM($latitude_deg, decimals: 4) }° de latitude est hors de { $system }.

scene-not_covered = La grille ne couvre pas la scène, à { NUM($longitude_deg, decimals: 5) }° de longitude, { NUM($latitude_deg, decimals: 5) }° de latitude.

scene-control_without_system = Les points d'appui n'ont pas de système de coordonnées, et { NUM($x, digits: 8) }, { NUM($y, digits: 8) } ne sont pas des degrés près des scènes.

scene-name_taken = Une autre scène porte le même nom.

scene-pair_shifted = { $n } points communs donnent un décalage de { NUM($shift_px, decimals: 0) } px (limite { NUM($limit_px, decimals: 0) } px).

scene-pair_scattered = { $n } points communs se dispersent de { NUM($spread_px, decimals: 0) } px (limite { $limit_px } px).

scene-pair_height = Les rayons de { $n } points communs se coupent à { NUM($height_m, decimals: 0) } m ; les RPC valent de { NUM($low_m, decimals: 0) } à { NUM($high_m, decimals: 0) } m.

scene-contradicts_other = La géométrie de cette scène ({ $model }) contredit la scène { $other }, qui s'accorde avec d'autres scènes.

scene-pair_contradicts = Les scènes { $first } et { $second } se contredisent ; laquelle est fausse est ambigu.

scene-no_place = { $name }, point { $point } : aucun des { $n } points n'a de position.

scene-no_ground_found = Aucun point au sol pour { $n } points image de la scène radar, à la hauteur { $height_m } m.

scene-range_too_short = La distance { $range_m } m du point image { $x_px }, { $y_px } n'atteint pas la hauteur { $height_m } m.

scene-several_in_folder = Le dossier contient plusieurs scènes : { $names }.

scene-radar_delays = Les retards de l'atmosphère et les marées terrestres restent au décalage de distance et d'horloge.

scene-orbit_noise = { $n } vecteurs d'état bruités ({ NUM($noise_m, digits: 2) } m, { NUM($noise_m_s, digits: 2) } m/s) remplacés par un polynôme ajusté.
    .why = L'interpolation amplifie leur bruit.

scene-bursts = { $n } bursts : des lignes sont prises deux fois, et aucun RPC ne décrit l'image entière.

scene-burst_lines = { $n } bursts de { $lines } lignes ne font pas { $rows } lignes.

scene-no_ground_range = La table des distances au sol est vide.

scene-ground_range_origins = L'origine des distances au sol change dans l'image ; ce n'est pas pris en charge.

scene-wrong_side = La scène radar regarde à { $side ->
    [right] droite
   *[left] gauche
  } de sa trajectoire, mais les { $n } points se trouvent de l'autre côté.

scene-map_product = L'image de ce produit ({ $kind }) est une carte et non dans la géométrie du radar.
    .do = Obtenir le produit en distance oblique ou au sol, ou utiliser celui-ci comme orthophoto.

scene-burst_images = Les { $n } bursts de ce produit sont des images séparées qui se recouvrent.
    .do = Obtenir le produit en distance au sol.

scene-values_differ = Cet élément apparaît { $n } fois avec des valeurs différentes.
    .do = Obtenir le produit d'un seul faisceau ou d'une seule polarisation.

scene-line_order = Les temps de la première et de la dernière ligne (écart { $seconds } s) contredisent cet élément.
    .do = Obtenir le fichier de nouveau.

scene-range_extent = Les colonnes finissent à { NUM($reached_m, digits: 8) } m, le fichier indique { NUM($stated_m, digits: 8) } m.
    .do = Obtenir le fichier de nouveau.

scene-tie_points = Les { $n } points de liaison du fichier diffèrent de son orbite et de ses distances de { $meets ->
     [yes] { NUM($rms_px, digits: 4) } px (moyenne quadratique)
     *[no] plus que l'image
    }, limite { $limit_px } px.
    .do = Vérifier la scène par des points d'appui, ou obtenir le fichier de nouveau.

scene-rpc_only = Seul le RPC est utilisé : le fichier n'a pas { $path }.

scene-delays_applied = Les retards indiqués sont appliqués : { $range_m } m de distance, { $seconds } s de temps.

scene-delays_missing = Aucun retard indiqué (ANNOTATION/GEOREF.xml manque) : il reste à la distance et à l'horloge.

scene-image_formation = Les images formées par { $kind } n'ont pas de lignes d'un seul temps ; seul le Doppler nul (RMA, INCA) est lu.
    .do = Obtenir le produit en distance oblique à Doppler nul (RGZERO), ou un produit en distance au sol.

scene-times_curved = Les temps des colonnes s'écartent d'une droite de { $seconds } s, ce qui n'est pas pris en charge.
    .do = Utiliser le RPC de la scène.

scene-no_sicd = Aucune extension de données de ce NITF ne contient les métadonnées d'un SICD.
    .do = Obtenir le fichier de nouveau.

scene-is_map = { $what ->
     [landsat] Un produit Landsat
     [sentinel2] Un produit Sentinel-2
     [orthoimage] Une orthoimage (DIMAP)
    *[raster] Un raster géoréférencé
    } est déjà une carte, sans géométrie de capteur à compenser.

scene-no_orbit = L'image a { $n } points au sol, mais ni orbite ni RPC.

scene-product_not_read = { $what ->
     [aster] Les produits ASTER niveau 1A (HDF)
     [sentinel2] Les produits Sentinel-2 niveau 1B
     [ceos] Les répertoires de volume et les fichiers d'image CEOS
     [saocom] Les produits SAOCOM
     [kompsat5] Les fichiers XML auxiliaires de KOMPSAT-5
     [cphd] Les historiques de phase (CPHD)
    *[hdf] Les fichiers HDF
    } ne sont pas lus.

scene-record_missing = Le fichier n'a pas de { $name }.

scene-raw_product = { $kind } est un produit brut (niveau 0) : il contient des signaux, pas d'image.

scene-times_rounded = Les temps des lignes sont arrondis de { $seconds } s au plus ({ $n_px } lignes), ce que prend l'horloge.

scene-not_uniform = Les valeurs de cette table s'écartent de { $steps } pas d'un espacement égal (limite { $limit }).

scene-image_used = L'image { $name } est utilisée ; le fichier contient aussi { $others }.
