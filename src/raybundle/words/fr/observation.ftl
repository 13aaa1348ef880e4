observation-covariance = La covariance { $sxy_px2 } px² est hors de ± { $limit_px2 } px², le produit sx · sy.

observation-sigma_out_of_range = Des écarts-types de { $sx_px } et { $sy_px } px ne sont pas plausibles.
