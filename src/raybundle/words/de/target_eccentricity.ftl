target_eccentricity = Die Mitten von { $n } runden Zielmarken wurden um ihre Exzentrizität korrigiert, bis zu { NUM($largest_px, digits: 2) } px.
