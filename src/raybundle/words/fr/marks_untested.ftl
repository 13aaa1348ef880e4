marks_untested = Pour { $n } marques, des erreurs jusqu'à { NUM($unseen_px, digits: 2) } px peuvent rester inaperçues (points : { LIST($points, most: 3) }).

marks_untested-open = { $n } marques ne sont pas contrôlées (points : { LIST($points, most: 3) }).
