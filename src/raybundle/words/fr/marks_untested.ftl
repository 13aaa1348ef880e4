marks_untested = { $n } marques ne sont pas contrôlées (points : { LIST($points, most: 3) }).
