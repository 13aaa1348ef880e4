# $name = "axes.csv"
# $n = 6
# $rms_mm = 0.12
# $rotation_mrad = 0.037
# $largest_mm = 1.6e-05
axes_fitted = The axes of { $name } fit { $n } points to { NUM($rms_mm, digits: 2) } mm rms.
    .why = Their rotation is known to { NUM($rotation_mrad, digits: 2) } mrad ({ NUM($largest_mm, digits: 2) } mm at the largest displacement), contained in the standard deviations.
