held_not_determinable-cameras = Les points ne déterminent pas l'orientation interne de { $ids } ; ses valeurs approchées sont fixées.
