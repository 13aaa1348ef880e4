# $n = 7
# $least = 8
fundamental-too_few_points = { $n } corresponding points are given; a fundamental matrix needs { $least }.
    .do = Measure more corresponding points.

fundamental-one_point = All points of the first image are identical.
    .do = Measure others.

# $n = 6
# $total = 40
# $least = 8
# $sigma_px = 0.5
fundamental-too_few_inliers = { $n } of { $total } corresponding points agree with one fundamental matrix; { $least } are needed.
    .why = The standard deviation is { $sigma_px } px.
    .do = Check the correspondences and the standard deviation.

# $share = 0.97
# $limit = 0.9
fundamental-homography = A homography explains { PERCENT($share) } % of the corresponding points (limit { PERCENT($limit) } %).
    .why = The object is a plane, or both images are from one station.
    .do = Measure points of different depth, or use another image.
