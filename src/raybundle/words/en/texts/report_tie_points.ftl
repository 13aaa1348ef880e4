report_tie_points-title = Tie points

report_tie_points-none = No object point has a used ray.

report_tie_points-arbitrary_scale = The scale is arbitrary: only ratios of these numbers have a meaning.

report_tie_points-ray_histogram = Number of rays of each point.

report_tie_points-deviations = Standard deviation of position, √(σX² + σY² + σZ²); the last column contains all larger ones.

report_tie_points-no_deviations = Standard deviations of points are unknown (statistics are off, or all points are held).

# $share = 0.2
report_tie_points-relief = Relief within the matching window more than doubles the standard deviation of { PERCENT($share) } % of the points.

report_tie_points-roughness = A tie point is the mean of the surface in this window (column roughness of points.csv).

report_tie_points-radius = Residuals of a coordinate against the distance of the image point from the format's centre.

# $sigma_px = 0.31
report_tie_points-sigma = Over the whole format, sigma of an image coordinate is { NUM($sigma_px, digits: 2) } px (rms).

# $ratio = 2.4
report_tie_points-outer_residuals = The largest residual outside is { NUM($ratio, digits: 2) } times the smallest inside.
    .do = Check the mean residuals over the format for distortion that the model lacks.

report_tie_points-sigma_note = sigma: standard deviation of position.

# $share = 0.4
report_tie_points-two_rays = { PERCENT($share) } % of the points have 2 rays: a wrong match along the line of sight remains hidden.

report_tie_points-median_sigma = median sigma

report_tie_points-rms_sigma = rms sigma
