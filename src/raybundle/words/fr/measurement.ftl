measurement-unknown_points = { $name } n'a pas de point { $points }.

measurement-shapes = { $name } : { $n } noms, coordonnées de forme ({ $xyz }), covariance de forme ({ $covariance }).

measurement-point_twice = { $name } contient deux fois le point { $point }.
