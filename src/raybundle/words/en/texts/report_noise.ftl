report_noise-title = Noise of the image coordinates

report_noise-independent = The errors of the image coordinates are assumed to be independent; reason:

report_noise-smooth_errors = Errors of real photographs are smooth over hundreds of pixels and differ from image to image.
    .why = Stabilisers, focus, shutters and compression cause them.

report_noise-in_residuals = Residuals hardly show them; standard deviations that ignore them are too small.
    .why = The standard deviations of this report include them.

report_noise-estimates = Estimates, tests and minimal detectable biases suppose independent errors.

report_noise-common_errors = Errors common to all images, as those of a lens model, are not included.
    .why = Check points, scale bars or another camera model reveal them.

report_noise-fields = smooth errors of each image: standard deviation τ of a coefficient

report_noise-focus = varying focus: displacement at half the longer side

report_noise-share = share of smooth errors in the variances of the interior orientation

report_noise-floor = floor φ: variance of smooth sums of errors, in units of independent ones

report_noise-images = images, images with residuals used here

# $n = 12
report_noise-mean_square = mean square of residuals in { $n } smooth directions (1: independent errors)

# $kind = "interior"
report_noise-ratio = ratio to standard deviations of independent errors: { $kind ->
        [interior] interior orientation
        [centres] projection centres
        *[points] object points
    }

report_noise-sigma_independent = sigma, independent errors
