fiducial-one_coordinate = Le repère de fond de chambre { $name } de l'image { $image } n'a qu'une coordonnée.

fiducial-not_measured = Le repère de fond de chambre { $name } n'est pas mesuré dans l'image { $image }.

fiducial-too_few = Scan { $image } : { $n } repères de fond de chambre sont mesurés ; il en faut { $least }.

fiducial-unknown_model = model = { $model } est inconnu.

fiducial-not_calibrated = Le repère de fond de chambre { $name } n'a pas de position étalonnée.

fiducial-no_film = Ces photos ne sont pas des scans de film : aucun repère n'a de position étalonnée.

fiducial-no_scans = Les photographies ne sont pas des numérisations de film et n'ont pas de repères de fond de chambre.
