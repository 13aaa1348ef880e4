report_interior-title = Interior orientation

# $camera = "1"
# $image = ""
# $single = false
report_interior-name = camera { $camera }{ $single ->
        [yes] , image { $image }
        *[no] {""}
    }

# $camera = "1"
# $image = ""
# $single = false
report_interior-figures_of = Figures of { report_interior-name }

# $camera = "1"
# $image = ""
# $single = false
report_interior-tests_of = Tests and correlations of { report_interior-name }

# $camera = "1"
# $image = ""
# $single = false
# $model = "brown"
# $width_px = 6000
# $height_px = 4000
# $width_mm = 23.46
# $height_mm = 15.64
# $pixel_um = 3.91
report_interior-camera = Camera { $camera }{ $single ->
        [yes] , image { $image }
        *[no] {""}
    }: model { $model }, { $width_px } × { $height_px } px, { NUM($width_mm, digits: 4) } × { NUM($height_mm, digits: 4) } mm, pixel { NUM($pixel_um, digits: 4) } µm

# $noun = "IMU"
# $name = "imu1"
report_interior-instrument = { $noun ->
        [antenna] Antenna
        *[other] { $noun }
    } { $name }

# $names = ["scene1", "scene2"]
report_interior-scenes = For the parameters of scenes see their own section: { LIST($names, most: 8) }.

# $n = 6
# $of = 40
report_interior-figures_drawn = Figures are drawn for { $n } of { $of } interior orientations.

report_interior-determinability = determinability

report_interior-effect = effect

report_interior-effect_of_sigma = effect of sigma

report_interior-t_note = t: value over sigma.

report_interior-determinability_note = Determinability: 1 = independent of all other unknowns; near 0 = only together with them.

report_interior-effect_note = Effect: largest shift within the format, of the value and of one sigma.

# $n = 12
report_interior-further_parameters = { $n } further { $n ->
        [one] parameter is
        *[other] parameters are
    } in result.json.

# $status = "not_significant"
report_interior-status = { $status ->
        [held] held
        [estimated] estimated
        [observed] observed
        [not_significant] not significant
        *[not_determinable] not determinable
    }

report_interior-of_images = Interior orientation of each image

report_interior-tested_together = tested together

report_interior-probability = probability of a larger F by chance

report_interior-joint_tests = Joint tests: could all of these be zero?

report_interior-no_distortion = No distortion: all additional parameters are held at their defaults.

report_interior-correlations = Correlations between the parameters of the interior orientation.

report_interior-correlations_exterior = Largest |correlation| with the exterior orientation over all images of the camera.

# $infinite = false
# $distance = 12.0
# $unit = "m"
# $largest_px = 0.21
report_interior-uncertainty = Uncertainty of projection at { $infinite ->
        [yes] infinity
        *[no] a distance of { NUM($distance, digits: 2) } { $unit }
    }: { NUM($largest_px, digits: 2) } px at most.
    .why = Standard deviation of a ray's image by errors of the interior orientation, less what the exterior orientation absorbs.

report_interior-decentring = Decentring distortion: largest correction over all directions.

# $largest_px = 41.2
report_interior-corrections = All corrections over the format, from measured (dot) to ideal; the largest is { $largest_px } px.
    .why = The cross is the principal point.

# $reach_mm = 11.2
report_interior-extrapolated = Shaded: beyond { $reach_mm } mm there are no observations; the curve is extrapolated.

report_interior-radial = Radial correction, ideal minus measured.

# $share = 0.0123
report_interior-balanced = Balanced: the same distortion with the camera constant changed by { PERCENT($share, digits: 3) } %.

report_interior-radial_sigma = Its standard deviation, from the covariance of the radial parameters.

report_interior-band = Band: 1 sigma (may be thinner than the line).
