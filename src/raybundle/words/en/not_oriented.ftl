not_oriented-not_connected = The image has no connection to the other images.
    .do = Measure points that this image has in common with two other images.

# $n = 4
not_oriented-no_second_image = The image has { $n } known { $n ->
        [one] point
        *[other] points
    }, and no second image has enough common points.
    .do = Measure more points that this image has in common with other images.

# $n = 4
# $least = 6
not_oriented-few_common = The image has { $n } { $n ->
        [one] point
        *[other] points
    } in common with the others; { $least } are needed.
    .do = Measure more common points, or add photographs with more overlap.

# $n = 40
# $share = 0.5
not_oriented-no_pose = The image has { $n } points in common with the others, but no orientation fits { PERCENT($share) } % of them.
    .do = Check point names, camera and coordinate axes of this image.

# $n = 3
not_oriented-contradicting_part = The points of this image and { $n } more, oriented together, contradict the other images.
    .do = Check point names and cameras of these images.

# $n = 40
# $axes = "mirrored"
not_oriented-axes = { $n } points of the image fit if { $axes ->
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
    .why = Both may be the same photograph; photographs from one place give no depth.
    .do = Delete one of two copies, or photograph from another position.

not_oriented-other_cameras = The image has no common points with the other cameras, and too few stations or turns join them.
    .do = Take more stations with all cameras, or measure points common to the cameras.

# $n = 4
# $images = 2
not_oriented-station = The station of the image has { $n } image { $n ->
        [one] point
        *[other] points
    } in { $images } { $images ->
        [one] image
        *[other] images
    }.
    .do = Measure more points in the images of this station.

not_oriented-contradicting_orientations = Relative orientations of the photograph contradict those of the other photographs.
    .do = Check whether the photograph shows a repeated structure or a moved object.

not_oriented-contradicting_points = Points of the photograph contradict those of the other photographs.
    .do = Check whether the photograph shows a repeated structure or a moved object.

# $least = 3
not_oriented-no_distance = Fewer than { $least } points of the photograph are in two others, so its distance is not determined.
    .do = Photograph with 60 % overlap or more.

# $n = 4
# $largest = 40
not_oriented-separate_part = The part of this photograph ({ $n } in all) has no connection to the largest part ({ $largest } photographs).
    .do = Add photographs between the two parts.

# $n = 12
# $angle_deg = 68.0
# $limit_deg = 55.0
not_oriented-wide_baseline = { $n } points of the photograph are seen from directions { NUM($angle_deg, decimals: 0) }° apart (median; limit { NUM($limit_deg, decimals: 0) }°).
    .why = Such matches are wrong.
    .do = Add photographs between.

# $n = 4
not_oriented-few_fit = Only { $n } { $n ->
        [one] point of the photograph fits
        *[other] points of the photograph fit
    } the other photographs.
    .do = Add photographs with more overlap.

# $other = "a.jpg"
not_oriented-same_picture = The photograph shows the same picture as { $other }.
    .do = If the photograph is no copy, take it again from another position.

not_oriented-mirrored = The photograph is mirrored against the others.
    .do = Exchange left and right in an image editor, or scan the slide from the other side.

not_oriented-alone = One photograph alone cannot be oriented; two are needed.
    .do = Add photographs of the same object from other positions.

not_oriented-not_joined = The scene has no connection to the photographs.
    .do = Mark three points in the scene and in two photographs, or give control for the photographs.

# $n = 3
# $least = 6
not_oriented-board = The photograph shows { $n } { $n ->
        [one] point
        *[other] points
    } of the board; { $least } are needed.
    .do = Photograph the whole board, sharp and evenly lit.

# $n = 3
# $least = 6
not_oriented-few_targets = { $n } named { $n ->
        [one] target was
        *[other] targets were
    } detected in the photograph; { $least } are needed.
    .do = Photograph more targets, sharp and large enough.

# $n = 30
# $points = 40
not_oriented-contradicting_share = { $n } of { $points } points of the photograph contradict the other photographs.
    .do = Check whether the photograph is mirrored, cropped or of another camera, or whether the zoom or the object was moved.
