transform-wrong_shape = Tableau { $name } d'une transformation : forme ({ $shape }), ou valeurs non finies.
