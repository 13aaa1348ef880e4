camera_joined = Caméra { $camera } : { $n } des { $photographs } photographies ont la même orientation interne.

camera_joined-doubtful = Caméra { $camera } : la rotation de { $n } des { $photographs } photographies est ambiguë.

camera_joined-gimbal = { $n } photographies sont enregistrées à l'envers à côté des { $others } autres : { LIST($ids, most: 3) }.

camera_joined-half_turned = { $n } photographies ({ $first } à { $last }) sont enregistrées à l'envers à côté des { $others } autres.
