# $correlation = 0.32
# $factor = 2.1
# $least_images = 8
# $usual_low = 2.4
# $usual_high = 6.0
# $few = false
# $ids = ["IMG_1"]
residual_structure = Residuals of neighbouring image points are correlated ({ NUM($correlation, decimals: 2) }, most in { $ids }).
    .why = Standard deviations are too small by a factor of { NUM($factor, decimals: 1) } at least{ $few ->
        [yes] ; sets of { $least_images } photographs or more usually show { $usual_low } to { $usual_high }
       *[no] { "" }
     }. The interior orientation may have changed between images (stabilised lens, refocusing, zoom).
    .do = Fix lens and focus when photographing, and check the residuals in the report.

# $tau_px = 0.32
# $focus_px = 0.1
# $phi = 20.0
# $ratio_interior = 20.0
# $ratio_points = 3.1
# $largest = 20.0
residual_structure-shared = Image points share slowly varying errors; standard deviations are up to { NUM($largest, digits: 2) } times too small.
    .why = The standard deviations assume independent errors.
    .do = Adjust with { OPTION("noise", "fields") }.

# $tau_px = 0.32
residual_structure-fields = Smooth errors that differ from image to image amount to { NUM($tau_px, digits: 2) } px.

# $focus_px = 0.1
residual_structure-focus = Errors by varying focus amount to { NUM($focus_px, digits: 2) } px.

# $phi = 20.0
residual_structure-neighbours = Errors that neighbouring points share amount to { NUM($phi, digits: 2) } times the variance.

# $object = "interior"
# $factor = 20.0
residual_structure-times = Standard deviations of the { $object ->
        [interior] interior orientation
        *[points] object points
    } are { NUM($factor, digits: 2) } times too small (median).

# $images = 40
residual_structure-sample = These figures are estimated from a part of the block: { $images } images, adjusted separately.

residual_structure-with_fields = With noise fields ({ OPTION("noise", "fields") }, as in `orient`) standard deviations contain these errors.
