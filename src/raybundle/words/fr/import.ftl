import-camera_fitted = La caméra { $camera } est lue comme modèle { $model }, ajusté sur le format : écart maximal { $deviation_px } px.

import-not_read = { $n } élément(s) du fichier non lu(s) : { LIST($kinds, most: 6) }.

import-repeated_observations = { $n } observation(s) répétant un point dans la même image écartée(s).

import-sigma_assumed = Écart-type des observations image : absent du format ; { $sigma_px } px supposé.

import-sensors_without_pose = { $n } image(s) ont un capteur sans orientation dans le montage ; les orientations des images sont utilisées.

import-rig_poses_differ = Les orientations externes de { $n } images sur { $total } diffèrent entre images et montages ; celles des montages sont utilisées.

import-points_without_object = { $n } points image sur { $total } n'appartiennent à aucun point objet et sont écartés.

import-format_assumed = { $format } ne contient ni format ni taille de pixel ; un format autour des points image et { $pixel_mm } mm sont supposés.

import-control_sigma_assumed = { $n } point(s) d'appui sans écart-type ; { $plan_m } m en plan et { $height_m } m en altitude supposés.

import-orientation_convention = Les orientations sont lues comme { $reading ->
     [pok_gon] phi, omega, kappa en gon
     [opk_gon] omega, phi, kappa en gon
     [opk_deg] omega, phi, kappa en degrés
     [object_to_image] rotations des axes objet aux axes image
     *[image_to_object] rotations des axes image aux axes objet
    }.

import-not_oriented = { $n } photographies sur { $total } n'ont pas d'orientation externe.

import-focal_length_contradicts = { $name } ({ NUM($used_px, digits: 6) } px) et { $other } ({ NUM($other_px, digits: 6) } px) se contredisent ; { $name } est utilisé.

import-no_observations = Le format ne contient pas d'observations image.

import-first_reconstruction = Le fichier a { $n } reconstructions ; la première est lue.

import-no_tracks = Il n'y a pas de pistes ({ $name }) ; aucune observation image n'est lue.

import-system_of_file = Les coordonnées sont en { $system }.

import-processing_frame = Les coordonnées sont dans le repère de traitement du projet, décalées de { LIST($shift, most: 3) }.

import-elements_left_out = { $n } élément(s) du fichier écarté(s) ; raison du premier :

import-elements_disabled = { $n } { $kind ->
     [disabled_marker] marqueur(s) désactivé(s)
     *[disabled_camera] caméra(s) désactivée(s)
    } non utilisé(s).

import-one_chunk = Le fichier a { $n } chunks ; le chunk { $number } est lu.

import-chunk_disabled = Le chunk est désactivé ; aucun autre n'a de caméras.

import-sensor_without_calibration = Le capteur { $sensor } n'a pas de calibrage et est écarté avec ses images.

import-no_object_space = Le chunk n'a pas de transformation vers l'espace objet ; ses coordonnées n'ont pas d'échelle.

import-components_apart = { $n } image(s) lue(s) sans orientation : leur composante n'a pas de transformation vers le reste.

import-geocentric = Le chunk est géoréférencé : ses coordonnées sont géocentriques (X, Y, Z de la Terre).

import-marker_sigma_assumed = { $n } marqueur(s) sans précision ; l'écart-type du chunk de { LIST($sigma_m, most: 3) } est supposé.

import-system_not_read = Le système de coordonnées du chunk ne peut être lu :

import-markers_converted = Les coordonnées des marqueurs sont converties de { $unit } en mètres (1 { $unit } = { $length_m } m).
