report_photographs-title = Photographs

report_photographs-oriented = photographs oriented

# $not_oriented = 2
# $refused = 1
report_photographs-excluded = { $not_oriented ->
        [0] { $refused ->
            [0] all used
            *[other] {""}
        }
        *[other] { $not_oriented } without orientation{ $refused ->
            [0] {""}
            *[other] {", "}
        }
    }{ $refused ->
        [0] {""}
        [one] { $refused } file refused
        *[other] { $refused } files refused
    }

# $names = ["DJI FC6310"]
report_photographs-names = { LIST($names, most: 3) }

# $mean = 4.2
report_photographs-mean_rays = mean number of rays: { NUM($mean, decimals: 1) }

report_photographs-image_point = measured image point

report_photographs-image_point_meaning = standard deviation of a coordinate (rms), from the residuals

# $n = 40
report_photographs-count = { $n } { $n ->
        [one] photograph
        *[other] photographs
    }

report_photographs-size = size [px]

report_photographs-taken = date

report_photographs-position = position

report_photographs-in_three_images = in 3 images or more

report_photographs-neighbours = neighbours

report_photographs-rms_residual = rms residual

report_photographs-covered = format covered

report_photographs-p_wrong = P(wrong)

# $limit = 0.5
report_photographs-p_wrong_note = P(wrong): probability that the station is wrong; marked above { PERCENT($limit) } %.
    .why = Wrong: more than 1 % of the extent or 1° off.

# $least = 30
report_photographs-neighbours_note = Neighbours: photographs with { $least } common points or more.

report_photographs-covered_note = Format covered: share of 10 × 10 cells with an image point.

# $share = 0.25
report_photographs-marked_note = Marked: without orientation, without neighbours, or less than { PERCENT($share) } % covered.
    .why = Distortion is determined only where there are points.

report_photographs-refused = refused

report_photographs-refused_remedy = If it is a copy of another photograph, delete one of the two.
    .do = Otherwise export it again and repeat the command.

report_photographs-not_oriented = not oriented

report_photographs-not_oriented_remedy = Add photographs between it and its neighbours (60 % overlap or more), or exclude it.

report_photographs-excluded_heading = Photographs without part in the result

# $n = 4
report_photographs-matrix_cell = A cell stands for { $n } × { $n } images and shows their strongest pair.

# $oblique = false
# $strong = 100
# $weak = 30
report_photographs-graph = Images at their projection centres, { $oblique ->
        [yes] on the plane of the largest spread (axes are arbitrary)
        *[no] plan view (XY)
    }.
    .why = Lines connect images with common points, wider for more of them: blue from { $strong }, rust below { $weak }.

report_photographs-matrix = Common points of every two images.

report_photographs-connections = Connections between the photographs

report_photographs-compared = compared

# $n = 300
# $fit = 120
report_photographs-pairs_compared = { $n } { $n ->
        [one] pair
        *[other] pairs
    } of photographs; { $fit } of them match.

report_photographs-joined = connected

# $n = 120
# $median = 6
# $least = 30
report_photographs-pairs_joined = { $n } { $n ->
        [one] pair
        *[other] pairs
    } of images have common points in the result.
    .why = An image has { $median } neighbours (median) with { $least } common points or more.

report_photographs-weak = weak

# $names = ["DSC_0412", "DSC_0413"]
# $least = 30
report_photographs-weak_photographs = Fewer than 2 neighbours with { $least } common points: { LIST($names, most: 8) }.
    .why = Their orientation depends on one connection.
    .do = Add photographs from positions between theirs and the next.

report_photographs-loose = loose

# $n = 2
# $least = 30
report_photographs-loose_parts = Connections of { $least } common points or more leave { $n } separate parts; fewer points connect these.
    .do = Take photographs that show both sides of each gap.

# $kind = "planar"
report_photographs-geometry = { $kind }

# $kind = "planar"
report_photographs-geometry_meaning = { $kind ->
        [general] different positions
        [planar] a plane, or nearly one
        [rotation] rotation on the spot: no depth
        [watermark] the same marks at the same place: not used
        *[none] no match
    }

report_photographs-geometry_label = geometry

report_photographs-matches = matches (median)

report_photographs-of_candidates = of candidates

report_photographs-candidates = candidates

report_photographs-verified = verified

# $n = 300
report_photographs-compared_pairs = { $n } compared { $n ->
        [one] pair
        *[other] pairs
    }

report_photographs-no_coordinates = No object point has coordinates: there is no map.

report_photographs-coverage = Coverage and overlap

# $median = 6
# $share = 0.08
report_photographs-overlap = Half of the mapped area is in { $median } images or more; { PERCENT($share) } % of it in fewer than 3.

report_photographs-little_overlap = In fewer than 3 images a blunder is hardly visible, and depth is weak.
    .do = Add photographs so that every part is seen from 3 positions or more.

# $n = 8000
# $of = 8742
# $oblique = false
report_photographs-ray_map = { $n } of { $of } object points by number of rays; { $oblique ->
        [yes] plane of the largest spread
        *[no] plan view (XY)
    }.

report_photographs-overlap_map = Number of images with an object point in each cell, on the same map.

# $ratio = 4.2
report_photographs-start_differs = The estimate differs from its starting value by { NUM($ratio, decimals: 1) } standard deviations of the latter.
    .why = Causes: zoom or focus changed, photographs cropped or scaled, or a flat object photographed head-on.

report_photographs-start_source = source of the start

report_photographs-start_c = start c

report_photographs-estimated_c = estimated c

report_photographs-change = change

report_photographs-in_sigmas = in sigmas of the start

report_photographs-c_note = c: camera constant in pixel widths.

report_photographs-start = Cameras: start and estimate

report_photographs-stage = stage

report_photographs-processor_time = processor time

report_photographs-memory = memory

report_photographs-stored = from an earlier run

report_photographs-memory_note = Memory: maximum of the process up to the end of the stage.
    .why = The time of a stage from an earlier run is that of reading it.

report_photographs-all_stages = all stages of this run

report_photographs-all_processors = all processors

report_photographs-at_most = maximum

report_photographs-processing = Time and memory

report_photographs-settings_note = Settings that differ from the defaults, by their names in project.toml and Python.

# $name = "features"
# $other = "features"
report_photographs-stage_name = { $name ->
        [photographs] photographs
        [known] known positions
        [cameras] cameras
        [features] features
        [matching] matching
        [start] approximate values
        [precision] precise measurement
        [targets] targets
        [adjustment] adjustment
        [verdict] verdict
        [recognised] recognised targets
        [natural] natural points
        *[other] { $other }
    }

# $fix = "RTK"
# $sigma_m = 0.02
report_photographs-recorded_position = { $fix ->
        [none] GNSS
        *[other] { $fix } GNSS
    }{ $sigma_m ->
        [0] {""}
        *[other] , sigma { NUM($sigma_m, digits: 2) } m
    }
