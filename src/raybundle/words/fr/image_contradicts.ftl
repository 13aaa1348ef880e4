image_contradicts = L'image { $image } contredit les autres : résidus { $ratio } fois les leurs (caméra { $camera } ; limite { $limit }).

image_contradicts-interior = L'image { $image } contredit les autres : elle a une orientation interne propre ({ NUM($rms_px, digits: 2) } px rms).

image_contradicts-rejected = { $images } image(s) : plus de { PERCENT($limit) } % des points image rejetés (médiane { PERCENT($median) } %) : { $ids }.

image_contradicts-without_it = L'image { $image } contredit les autres : sigma0 vaut { $sigma0 } sans elle, { $sigma0_with } avec elle.

image_contradicts-origin = { $n } image(s) ont des points image à gauche et au-dessus du format : { $names }.

image_contradicts-camera_constant = { $images } image(s) ont une autre constante de caméra, { NUM($ratio, digits: 5) } fois celle des autres : { $names }.

image_contradicts-matches = { $n } { $n ->
     [one] photographie contredit
     *[other] photographies contredisent
    } les autres : peu de correspondances s'accordent avec l'orientation : { LIST($names, most: 5) }.
