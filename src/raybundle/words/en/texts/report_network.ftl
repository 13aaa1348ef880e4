report_network-title = Network

report_network-precision_title = Precision of the object points

report_network-no_statistics = Standard deviations were not computed (statistics are off).

report_network-all_held = All object points are held: they have no standard deviations.

report_network-weakest_list = The weakest points

report_network-weakest = Points with the largest standard deviations

# $axis = "X"
report_network-deviations = Standard deviations of { $axis }; the last column contains all larger ones.

report_network-views = Plan (XY), front view (XZ) below, side view (ZY) beside it.

# $points = 2000
# $of = 8742
# $images = 60
# $of_images = 60
report_network-drawn = Drawn: { $points } of { $of } points, { $images } of { $of_images } images.

# $n = 4
report_network-far_points = { $n } far { $n ->
        [one] point is
        *[other] points are
    } outside the frame.

# $n = 300
# $factor = 1000
report_network-ellipses = Error ellipses (1 sigma, probability 39 %) of { $n } { $n ->
        [one] point
        *[other] points
    }, enlarged { $factor } times.

report_network-symbols = Triangles: control points; circles: check points.

report_network-arbitrary_system = The coordinate system is arbitrary.

report_network-geometry_not_computed = Angles, base-to-depth ratios and coverage were not computed (statistics are off).

report_network-rays = rays per point (smallest … median … largest)

# $mean = 4.21
report_network-mean_rays = mean { NUM($mean, decimals: 2) }

report_network-stations = stations per point

report_network-stations_meaning = rays from distinct projection centres

report_network-largest_angle = largest intersection angle

# $n = 12
report_network-small_angles = { $n } { $n ->
        [one] point
        *[other] points
    } below 5°

report_network-distance = distance to the object

report_network-distance_meaning = median of each image

report_network-image_scale = image scale number S

report_network-image_scale_meaning = distance over camera constant

report_network-base_to_depth = base-to-depth ratio

# $n = 240
# $least = 6
report_network-pairs_with_points = { $n } { $n ->
        [one] pair
        *[other] pairs
    } with { $least } common points or more

report_network-coverage = coverage of the format

report_network-coverage_meaning = share of 10 × 10 cells with a point

report_network-parts = connected parts

report_network-q_meaning = σ = q S σ(xy) / √k, k: mean number of rays per point

report_network-q_stations = q by stations

report_network-q_stations_meaning = the same with the mean number of stations

report_network-efficiency = efficiency of the directions

# $bound = 0.61
report_network-efficiency_meaning = (bound / q)², bound { $bound } for rays from all directions

report_network-ray_histogram = Rays per object point.

report_network-angle_histogram = Largest intersection angle of each point.

# $ratio = 1.8
report_network-scale_histogram = Image scale numbers; the largest is { NUM($ratio, digits: 2) } times the smallest.

# $n = 240
# $most = 2
report_network-ratio_histogram = Base-to-depth ratio of { $n } image { $n ->
        [one] pair
        *[other] pairs
    }; the last column contains all above { $most }.

# $n = 12
report_network-roll = Roll about the viewing axis, the most frequent one up; { $n } { $n ->
        [one] image
        *[other] images
    } near ±90°.

report_network-not_rolled = Without rolled images, principal point and decentring distortion remain correlated.

# $least = 6
report_network-no_pairs = No two images have { $least } common points or more.

# $n = 300
# $of = 1200
report_network-pairs_shown = { $n } of { $of } pairs are shown.

report_network-pairs_order = Pairs by the number of their common points.

# $n = 70
# $of = 1200
report_network-pairs_chosen = { $n } of { $of } pairs, evenly chosen from the strongest to the weakest.

# $n = 1200
report_network-image_pairs = { $n } image { $n ->
        [one] pair
        *[other] pairs
    }

report_network-coverage_of_images = Coverage of the format by image points, each image.
