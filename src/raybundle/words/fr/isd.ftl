isd-map_projected = L'image est projetée sur une carte ; ses lignes ne sont pas celles du balayage.

isd-line_times = La table des temps de ligne n'est pas monotone.

isd-line_times_contradict = La ligne { NUM($line_number, digits: 6) } commence avec { NUM($off_lines, decimals: 1) } temps de ligne d'écart.

isd-focal_plane = La transformation du plan focal aux pixels n'a pas d'inverse.

isd-coefficient_count = Coefficients de distorsion : { $n } ; { $most } au plus sont possibles.

isd-distortion_folds = La distorsion ({ $coefficients }) replie le plan focal à { $radius_mm } mm de l'axe.

isd-distortion_folds_detector = Le coefficient { $coefficient } replie un détecteur qui s'étend à { $detector_mm } mm de son milieu.

isd-distortion_no_inverse = La distorsion{ $n ->
     [0] { "" }
     *[other] { " " }({ $coefficients })
    } n'a pas d'inverse sur le détecteur.

isd-position_inside_body = Une position est à { NUM($distance_m, digits: 6) } m du centre d'un corps de rayon { NUM($radius_m, digits: 6) } m.

isd-time_count = La table a { $n } temps pour { $entries } entrées.

isd-time_order = Entrée { $entry } : le temps { NUM($time_s, digits: 6) } s suit { NUM($before_s, digits: 6) } s.

isd-quaternion_zero = { $n ->
     [0] Il n'y a pas de quaternions.
     *[other] Un quaternion est de longueur 0.
    }

isd-velocity_count = La table a { $n } vitesses pour { $positions } positions.

isd-no_model = Ce JSON n'est pas une description du Community Sensor Model : name_model manque.

isd-model_unknown = { $model } n'est pas un modèle de capteur qui est lu.

isd-no_aberration = Ni l'aberration ni la réfraction ne sont appliquées, comme dans USGSCSM.

isd-kilometres_assumed = L'unité des positions n'est pas donnée ; des kilomètres sont supposés, comme ALE les écrit.

isd-detector_turned = Le troisième axe du détecteur s'éloigne du corps ; il est inversé, comme dans USGSCSM.

isd-scan_reverses = Le balayage s'inverse à la ligne { LIST($lines, most: 6) } ; le terrain y est vu deux fois.

isd-distortion_unknown = La distorsion optique { $name } n'est pas prise en charge.

isd-attitude_gap = Les attitudes ont { $n } lacune(s), la plus large de { NUM($steps, decimals: 1) } pas, de { NUM($from_s, decimals: 3) } à { NUM($to_s, decimals: 3) } s.

isd-attitude_gap_bridged = { $n } lacune(s) des attitudes interpolée(s), la plus large de { NUM($steps, decimals: 1) } pas, de { NUM($from_s, decimals: 3) } à { NUM($to_s, decimals: 3) } s.

isd-framelets = Des sous-images de { NUM($height, digits: 4) } lignes toutes les { NUM($delay_s, digits: 4) } s, dont { NUM($overlap, digits: 3) } en recouvrement, ne remplissent pas une image de { $lines } lignes.
