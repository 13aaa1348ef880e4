not_oriented-not_connected = It has no connection to the other images.

# $n = 4
not_oriented-no_second_image = { $n } known { $n ->
        [one] point
       *[other] points
    }, and no second image with enough common points.

# $n = 4
# $least = 6
not_oriented-few_common = { $n } { $n ->
        [one] point
       *[other] points
    } in common with the others; { $least } are needed.

# $n = 40
# $share = 0.5
not_oriented-no_pose = { $n } points in common with the others, but no orientation fits { PERCENT($share) } % of them.

# $n = 3
not_oriented-contradicting_part = Oriented with { $n } others, but their points contradict those of the other images.

# $n = 40
# $axes = "mirrored"
not_oriented-axes = { $n } of them fit if { $axes ->
        [mirrored] y is counted upward or x to the left
        [exchanged] x and y are exchanged
        [middle] the origin is the middle of the image
       *[middle_mirrored] the origin is the middle of the image and y is counted upward
    }.
    .do = Correct the image points: pixels count from the upper left corner, x to the right and y down.

# $first = "a.jpg"
# $second = "b.jpg"
# $angle_deg = 0.2
not_oriented-no_base = Images { $first } and { $second }: rays to common points are parallel within { NUM($angle_deg, decimals: 2) }°, without a base.
    .why = It may be the same photograph twice.

not_oriented-other_cameras = It has no points in common with the other cameras, and too few stations or turns join them.

# $n = 4
# $images = 2
not_oriented-station = Its station has { $n } image { $n ->
        [one] point
       *[other] points
    } in { $images } { $images ->
        [one] image
       *[other] images
    }.

not_oriented-contradicting_orientations = Its relative orientations contradict those of the other photographs.

not_oriented-contradicting_points = Its points contradict those of the other photographs.

# $least = 3
not_oriented-no_distance = Fewer than { $least } of its points are in two other photographs, so its distance is not determined.
    .do = Photograph with 60 % overlap or more.

# $n = 4
# $largest = 40
not_oriented-separate_part = It has no connection to the largest part ({ $largest } photographs); its own part has { $n }.

# $n = 12
# $angle_deg = 68.0
# $limit_deg = 55.0
not_oriented-wide_baseline = Its { $n } points are seen from directions { NUM($angle_deg, decimals: 0) }° apart (median; limit { NUM($limit_deg, decimals: 0) }°).
    .why = Such matches are wrong.
    .do = Add photographs between.

# $n = 4
not_oriented-few_fit = Only { $n } of its points { $n ->
        [one] fits
       *[other] fit
    } the others.

# $other = "a.jpg"
not_oriented-same_picture = It shows the same picture as { $other }.

not_oriented-alone = One photograph alone cannot be oriented; two are needed.

not_oriented-not_joined = It has no connection to the photographs.
    .do = Mark three points in it and in two photographs, or give control for the photographs.

# $n = 3
# $least = 6
not_oriented-board = It shows { $n } { $n ->
        [one] point
       *[other] points
    } of the board; { $least } are needed.

# $n = 3
# $least = 6
not_oriented-few_targets = { $n } named { $n ->
        [one] target was
       *[other] targets were
    } detected; { $least } are needed.

# $n = 30
# $points = 40
not_oriented-contradicting_share = { $n } of its { $points } points contradict the other photographs.
    .do = Check whether it is mirrored, cropped or of another camera, or whether the zoom or the object was moved.
