stored_turned = { $n } fichier(s) photo enregistré(s) tourné(s) de { $turned_deg }° : { $ids }.

stored_turned-size = { $n } fichier(s) photo de taille { $width_px } × { $height_px } px, autre que celle de la caméra { $camera } : { $ids }.
