approximate_scale = Les barres d'échelle rendent le bloc { NUM($factor, digits: 5) } fois plus grand que les valeurs approchées.
