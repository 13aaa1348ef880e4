instrument-name_taken = Der Name { $name } gehört schon zu { $other ->
        [camera] einer Kamera
        [antenna] einer Antenne
       *[imu] einer IMU
     }.
    .do = Der { $kind ->
        [camera] Kamera
        [antenna] Antenne
       *[imu] IMU
     } einen anderen Namen geben.
