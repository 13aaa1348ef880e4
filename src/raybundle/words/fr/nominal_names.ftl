nominal_names = Les points nominaux et mesurés ne concordent pas : seulement { $agree } sur { $n }.
