image_contradicts = L'image { $image } contredit les autres : résidus { $ratio } fois les leurs (caméra { $camera } ; limite { $limit }).

image_contradicts-interior = L'image { $image } contredit les autres : elle a une orientation interne propre ({ NUM($rms_px, digits: 2) } px rms).

image_contradicts-rejected = { $images } image(s) : plus de { PERCENT($limit) } % des points image rejetés (médiane { PERCENT($median) } %) : { $ids }.
