observation-covariance = Die Kovarianz { $sxy_px2 } px² liegt außerhalb ± { $limit_px2 } px², dem Produkt sx · sy.
    .do = Sie berichtigen oder leer lassen.

observation-sigma_out_of_range = Standardabweichungen von { $sx_px } und { $sy_px } px sind nicht plausibel.
    .do = Sie in px angeben.
