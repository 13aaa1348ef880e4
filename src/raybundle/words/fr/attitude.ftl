attitude-phi_right_angle = Attitude de l'image { $image } : phi = { NUM($phi_deg, decimals: 2) }° est à moins de 0,6° de 90°.
