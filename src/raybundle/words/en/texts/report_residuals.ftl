report_residuals-title = Residuals of the image observations

report_residuals-none = No image observation was used.

# $x_px = 0.31
# $y_px = 0.28
# $largest_px = 1.9
report_residuals-rms = Residuals (rms): { $x_px } px in x, { $y_px } px in y; the largest is { $largest_px } px.

report_residuals-definition = A residual is adjusted minus observed, in the pixel frame (y down).

# $symbol = "w / σ₀"
# $n = 12400
# $beyond = 21
# $expected = 12.4
# $kurtosis = 0.31
report_residuals-histogram = Normalised residuals { $symbol } of { $n } image coordinates, and the normal curve.
    .why = Beyond 3.29: { $beyond } (expected { NUM($expected, digits: 2) }); excess kurtosis { NUM($kurtosis, decimals: 2) }.

report_residuals-quantiles = Their quantiles against those of the normal distribution: on the line if errors are normal.
    .why = Steeper ends mean more large residuals than a normal distribution has.

# $camera = "1"
report_residuals-systematic_of = Systematic part, camera { $camera }

# $level = 0.05
# $white = true
report_residuals-cells = Mean residuals in cells of the format, with the number of points.
    .why = Shaded cells: the mean differs from zero ({ PERCENT($level) } % for all cells together; { $white ->
            [yes] residuals assumed uncorrelated
            *[no] from the scatter of single photographs
        }).

report_residuals-profile = Mean radial (outwards) and tangential residual in rings of equal number of points.
    .why = Bars: standard deviation of each mean. A trend is distortion that the model lacks.

report_residuals-too_few_points = There are too few points for means.

# $n = 3
# $of = 96
# $verdict = "small"
report_residuals-cell_tests = Mean residual differs from zero in { $n } of { $of } cells: { $verdict ->
        [none] no significant systematic part
        [systematic] systematic part after the camera model
        *[small] small systematic part in places
    }.

# $rms_px = 0.021
# $share = 0.08
# $largest_px = 0.06
report_residuals-cell_means = Cell means: rms { NUM($rms_px, digits: 2) } px ({ PERCENT($share) } % of the rms residual), largest { NUM($largest_px, digits: 2) } px.

report_residuals-images = Images

# $rms_px = 0.31
report_residuals-rms_of_images = Rms residual of each image; dashed: of all images, { $rms_px } px.

report_residuals-scale = Scale of the vectors.

# $n = 24
report_residuals-vectors = Residual vectors of { $n } { $n ->
        [one] image
        *[other] images
    }

report_residuals-table = Residuals of each image as a table

report_residuals-vectors_order = Residual vectors of each image with their rms, the largest rms first.

# $n = 120
# $of = 400
report_residuals-images_drawn = { $n } of { $of } images are drawn.

# $n = 300
report_residuals-vectors_drawn = At most { $n } vectors of an image are drawn, the largest included.

report_residuals-crossed = A cross marks a rejected point.

# $image = "DSC_0412"
# $rms_px = 0.312
# $n = 412
# $rejected = 3
report_residuals-vectors_of_image = { $image }, { NUM($rms_px, decimals: 3) } px rms of { $n } { $n ->
        [one] point
        *[other] points
    }{ $rejected ->
        [0] {""}
        *[other] ; { $rejected } rejected
    }

report_residuals-largest_w = largest |w| / σ₀

report_residuals-mean_r = mean r

report_residuals-differs = differs from the others

# $level = 0.01
report_residuals-differs_note = σ of an image marked “differs” is not that of the whole block (level { PERCENT($level) } % each).
