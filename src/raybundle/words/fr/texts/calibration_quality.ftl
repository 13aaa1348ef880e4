calibration_quality-grade = { $grade ->
        [good] bon
        [usable] utilisable
        [weak] faible
        *[not_determinable] indéterminable
    }

calibration_quality-of_camera = Caméra { $camera } :

calibration_quality-head_not_determinable = Indéterminable : { $whole ->
        [yes] l'orientation interne
        *[no] { LIST($names, most: 8) }
    }.

calibration_quality-head_figures = Erreur de projection { NUM($typical_px, digits: 2) } px (médiane ; maximum { NUM($largest_px, digits: 2) }), points image { NUM($sigma_px, digits: 2) } px.

calibration_quality-head_weak = Faible : à utiliser comme valeurs approchées seulement.

calibration_quality-head_part = Valable jusqu'à { PERCENT($reach) } % de la distance aux coins.

calibration_quality-head_inside = Bon jusqu'à { PERCENT($reach) } % de la distance aux coins ({ NUM($inside_px, digits: 2) } px), utilisable au-delà.

calibration_quality-head_usable = Utilisable pour des mesures jusqu'à environ { NUM($px, digits: 2) } px.

calibration_quality-head_good = Bon : peut être fixé pour des mesures jusqu'à { NUM($px, digits: 2) } px.
