similarity-too_few_points = Une similitude demande trois points communs ; { $n } donné(s).

similarity-points_in_line = Les points communs de la similitude sont alignés.
