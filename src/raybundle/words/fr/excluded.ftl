excluded-undetermined = Les points restants ne déterminent pas l'orientation de l'image.

excluded-few_points = Les { $n } points restants ne déterminent pas l'orientation de l'image.

excluded-part = Une partie séparée de { $photographs } photographies n'est pas déterminée.
