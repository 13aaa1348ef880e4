maxar-no_line_times = La table des temps de ligne est vide.

maxar-entry_count = Entrées { $name } : { $n } ; NUMPOINTS est { $announced }.

maxar-gap = L'entrée { NUM($entry, digits: 6) } suit l'entrée { NUM($before, digits: 6) } : la table a une lacune.

maxar-camera_backwards = La caméra regarde vers l'arrière : son troisième axe est négatif.

maxar-no_band = DETECTOR_MOUNTING ne contient aucune bande.

maxar-no_rigorous_model = Le fichier ne contient ni éphéméride, ni attitude, ni caméra ; seul son RPC est utilisé.

maxar-distortion_not_supported = La distorsion optique n'est pas 0, ce qui n'est pas pris en charge ; le modèle rigoureux n'est pas utilisé.

maxar-radians_by_rpc = DETROTANGLE { $angle } est en radians : modèle rigoureux moins RPC donne { $rms_px } px.

maxar-radians_by_axis = DETROTANGLE { $angle } est en radians : le milieu de la barrette est à { NUM($off_px, digits: 4) } px de l'axe optique.

maxar-degrees_assumed = L'unité de DETROTANGLE { $angle } n'est pas donnée ; des degrés sont supposés.
