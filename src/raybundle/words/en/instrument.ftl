# $name = "gnss"
# $kind = "antenna"
# $other = "camera"
instrument-name_taken = The name { $name } already belongs to { $other ->
        [camera] a camera
        [antenna] an antenna
       *[imu] an IMU
     }.
    .do = Give the { $kind ->
        [camera] camera
        [antenna] antenna
       *[imu] IMU
     } another name.
