film-mark_outside_camera = { $x_mm }, { $y_mm } mm : hors de toute caméra (maximum { $largest_mm } mm).

film-mark_not_calibrated = La marque { $mark } n'a pas de position étalonnée.

film-position_outside_scan = { $x_px }, { $y_px } px : hors de tout scan (maximum { $largest_px } px).

film-pixel_size = Image { $image } : un pixel de scanner de { $pixel_mm } mm est impossible.

film-too_few_marks = Image { $image } : { $n } marques ; la transformation { $model } en demande { $needed }.

film-marks_in_line = Image { $image } : les marques sont alignées ou confondues.

film-too_few_crosses = Le réseau a { $n } croix ; il en faut { $needed }.

film-no_marks = Image { $image } : des points, mais aucune marque.

film-marks_implausible = Image { $image } : aucun film n'a la déformation indiquée par ces marques.

film-no_transformation = Image { $image } : aucune transformation { $model } ne convient aux marques.

film-residuals = Les résidus des repères de cliché atteignent { $worst_mm } mm après la transformation (limite { $limit_mm } mm).

film-stretch = Le film serait étiré { $ratio } fois plus selon un axe que selon l'autre (limite { $limit }).

film-shear = Les repères cisailleraient le film : les axes s'écartent de { $shear_deg }° de l'angle droit (limite { $limit_deg }°).

film-marks_exchanged = Les noms de deux marques sont probablement intervertis : { $pairs }.

film-wrong_mark = La marque { $mark } est à { $offset_mm } mm de la position donnée par les autres.

film-several_wrong_marks = Plus d'une marque est fausse.

film-camera_missing = Des films numérisés demandent une caméra étalonnée.

film-scans_not_transformed = Numérisations qui ne peuvent pas être transformées : { $n }. Rien n'est écrit.

film-one_camera = Caméras données : { $n } ; des numérisations de film en demandent exactement une.

film-as_many_marks = Autant de repères que d'inconnues : un repère faux n'est pas décelé.

film-mirrored = L'image { $image } est inversée.

film-shrinkage = Image { $image } : le film aurait rétréci de plus de { PERCENT($limit) } %.

film-residuals_enlarged = Image { $image } : les résidus des repères valent { NUM($sigma0, digits: 3) } fois ce qui est indiqué.

film-suspects = Image { $image } : repères peut-être faux : { $marks }.
