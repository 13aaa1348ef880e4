# $source = "ins.csv"
# $reading = "opk"
# $scatter_deg = 12.5
# $sigma_deg = 0.05
# $other = true
attitudes_contradict = The attitudes of { $source ->
     [gimbal] the gimbal
     *[other] { $source }
    } contradict the photographs and are left out.
    .why = After the best mounting of the camera they scatter by { NUM($scatter_deg, decimals: 2) }° (median); their standard deviation is { NUM($sigma_deg, digits: 2) }°.
    .do = { $other ->
     [yes] Name the columns for the convention that fits:
     *[no] Check their convention ({ $reading }), the times of exposure, and whether the rows belong to these photographs.
    }

# $off_deg = 30.0
attitudes_contradict-mounting = The mounting is { NUM($off_deg, decimals: 0) }° off a whole number of quarter turns.

# $reading = "rpy"
# $scatter_deg = 0.05
attitudes_contradict-reading = { $reading ->
     [opk] Omega, phi, kappa
     [phi_primary] Omega, phi, kappa with phi as primary angle
     [opk_inverse] Omega, phi, kappa of the inverse rotation (camera to object)
     [opk_omega_phi_reversed] Omega, phi, kappa with omega and phi of opposite sign
     [opk_kappa_reversed] Omega, phi, kappa with kappa of opposite sign
     [rpy] Roll, pitch, yaw against north, east, down
     [rpy_roll_reversed] Roll, pitch, yaw with roll of opposite sign
     [rpy_pitch_reversed] Roll, pitch, yaw with pitch of opposite sign
     [rpy_roll_pitch_reversed] Roll, pitch, yaw with roll and pitch of opposite sign
     [pry] Pitch, roll, yaw (the first two exchanged)
     [rpy_yaw_from_east] Roll, pitch, yaw with yaw counted from east, counterclockwise
     [gimbal] Yaw, pitch, roll of the camera (gimbal)
     [ypr] Yaw, pitch, roll of the aircraft
     *[gimbal_rpy] Roll, pitch, yaw of the camera (gimbal)
    }: scatter { NUM($scatter_deg, decimals: 2) }°
