station-velocity_unknown = Le décalage de temps dt demande la vitesse de chaque image ; elle manque pour { $images }.
