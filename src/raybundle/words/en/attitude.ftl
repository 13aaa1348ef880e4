# $image = "img_07"
# $phi_deg = 89.8
attitude-phi_right_angle = Attitude of image { $image }: phi = { NUM($phi_deg, decimals: 2) }° is within 0.6° of 90°.
    .why = At 90°, omega and kappa rotate about the same axis and cannot be separated.
    .do = Leave this attitude out.

attitude-missing = There are no attitudes: neither { OPTION("positions") } nor the photographs have them.
    .do = Give a CSV with omega_deg, phi_deg, kappa_deg or roll_deg, pitch_deg, yaw_deg.

# $source = "ins.csv"
# $convention = "opk"
# $expected = "rpy-ned"
attitude-other_convention = The attitudes of { $source ->
     [gimbal] the gimbal
     *[other] { $source }
    } have convention { $convention }, not { $expected }.
    .do = Give { OPTION("attitudes", "auto") }.

# $source = "ins.csv"
attitude-no_sigma = The attitudes of { $source ->
     [gimbal] the gimbal
     *[other] { $source }
    } have no standard deviations.
    .do = Give { OPTION("attitude_sigma", "TILT", "HEADING") } in degrees.

# $source = "ins.csv"
attitude-no_sigma_unused = The attitudes of { $source ->
     [gimbal] the gimbal
     *[other] { $source }
    } are not used: they have no standard deviations.
    .do = Give { OPTION("attitude_sigma", "TILT", "HEADING") } in degrees to observe them.
