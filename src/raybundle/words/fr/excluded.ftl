excluded-undetermined = Les points restants ne déterminent pas son orientation.

excluded-few_points = Les { $n } points restants ne déterminent pas son orientation.

excluded-part = Une partie séparée de { $photographs } photographies n'est pas déterminée.
