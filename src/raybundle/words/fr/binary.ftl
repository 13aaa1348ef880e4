binary-ends_in_record = Le fichier s'arrête dans un enregistrement (octet { $byte }).

binary-number_not_finite = { $kind ->
        [camera] Caméra
        [image] Image
        [point] Point
        [rig] Rig
       *[frame] Frame
     } { $number } : un nombre n'est pas fini ou est trop grand (octet { $byte }).

binary-count_too_large = Le fichier annonce { $n } { $kind ->
        [cameras] caméras
        [images] images
        [image_points] points image
        [points] points
        [track_elements] éléments de trace
        [rigs] rigs
       *[frames] frames
     } ; il a de la place pour { $most } (octet { $byte }).

binary-name_too_long = Un nom dépasse { $most } octets (octet { $byte }).

binary-name_not_utf8 = Un nom n'est pas en UTF-8 (octet { $byte }).

binary-bytes_left = { $n } octets suivent le dernier enregistrement (octet { $byte }).
