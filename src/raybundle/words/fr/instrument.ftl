instrument-name_taken = Le nom { $name } appartient déjà à { $other ->
        [camera] une caméra
        [antenna] une antenne
       *[imu] une centrale inertielle
     }.
