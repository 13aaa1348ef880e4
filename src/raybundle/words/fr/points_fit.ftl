points_fit-apart = { $point } : écart de { $apart_mm } mm.

points_fit-names_exchanged = Avec les noms { $first } et { $second } échangés, les deux concordent.

points_fit-instead = Exclure plutôt { $names } explique aussi bien les écarts.
