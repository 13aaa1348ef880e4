flight_area-not_finite = Un sommet { $kind ->
        [zone] de la zone interdite { $name }
        [object] de l'objet
        [outline] du contour { $name }
       *[area] de la zone
     } n'a pas deux coordonnées finies.

flight_area-too_few_corners = { $kind ->
        [zone] La zone interdite { $name }
        [object] L'objet
        [outline] Le contour { $name }
       *[area] La zone
     } a { $n } sommets différents ; il en faut trois.

flight_area-crosses_itself = { $kind ->
        [zone] La zone interdite { $name }
        [object] L'objet
        [outline] Le contour { $name }
       *[area] La zone
     } se croise aux côtés partant des sommets { $first } et { $second }.

flight_area-no_area = { $kind ->
        [zone] La zone interdite { $name }
        [object] L'objet
        [outline] Le contour { $name }
       *[area] La zone
     } est sans étendue : tous ses sommets sont alignés.
