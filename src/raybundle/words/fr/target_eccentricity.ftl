target_eccentricity = Les centres de { $n } cibles rondes ont été corrigés de leur excentricité, jusqu'à { NUM($largest_px, digits: 2) } px.
