limits-precision = Precision is not accuracy.

limits-independent_errors = Standard deviations describe independent random errors of image points.
    .why = Errors that many points share (distortion, eccentric targets, refraction, unstable camera) are not included.

limits-common_errors = Standard deviations include smooth errors that differ from image to image.
    .why = Errors that all images share (distortion, eccentric targets, refraction) are not included.

limits-small_sigma0 = A small σ₀ does not prove correct coordinates.

limits-hidden_blunders = A residual shows only the share r (redundancy number) of an error.
    .why = Blunders below the smallest detectable ones remain in the result.

# $component = "Z"
# $point = "104"
# $mdb = 3.2
# $unit = "mm"
limits-weakest_control = Weakest tested control coordinate: { $component } of { $point }. Every fifth error of { NUM($mdb, digits: 2) } { $unit } is missed.

limits-no_comparison = No independent check was made.

limits-own_accuracy = Without check points or independent lengths, only the precision of the network is known.

limits-datum = Standard deviations refer to this datum.

limits-datum_scaled = They describe the shape, not its position in another system.
    .why = Distances and angles do not depend on the datum.

limits-datum_unscaled = They describe the shape, not its position in another system, nor its size.
    .why = Angles and ratios of distances do not depend on the datum; distances do.

limits-no_scale = Lengths are not absolute.

limits-scale_chosen = The scale was chosen, not measured.
    .do = Give a scale bar or two control points.

limits-nominal_scale = The scale was given, not measured.

limits-nominal_length = An error in the given target length changes all lengths; no standard deviation includes it.

limits-held_control = Held control counts as free of error.

limits-control_sigma = Standard deviations do not include its uncertainty.
    .do = Give control with its standard deviation.

limits-held_interior = The interior orientation counts as free of error.

limits-interior_errors = Its errors propagate undetected into the object coordinates.

limits-rejection = Rejection makes the remaining observations look better.

limits-sigma0_after_rejection = σ₀ after data snooping is estimated from the accepted observations.
