excluded-undetermined = Les points restants ne déterminent pas l'orientation de l'image.

excluded-few_points = Les { $n } points restants ne déterminent pas l'orientation de l'image.

excluded-part = Une partie séparée de { $photographs } photographies n'est pas déterminée.

excluded-few_points_at_date = Trop peu de ses points ont un second rayon à sa date.
