# $image = "img_07"
# $phi_deg = 89.8
attitude-phi_right_angle = Attitude of image { $image }: phi = { NUM($phi_deg, decimals: 2) }° is within 0.6° of 90°.
    .why = At 90°, omega and kappa rotate about the same axis and cannot be separated.
    .do = Leave this attitude out.
