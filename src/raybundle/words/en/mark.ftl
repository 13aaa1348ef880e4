# $point = "P1"
# $image = "left.jpg"
mark-exists = Point { $point } is already marked in image { $image }.
    .do = Move the mark, or remove it first.

# $point = "P1"
# $to = "P2"
mark-name_taken = Point { $point } cannot be renamed to { $to }: this name is in use.
    .do = Choose another name, or delete the other point first.

# $point = "P1"
mark-point_of_block = Point { $point } is from the block; no mark of it is measured by hand.
    .do = Reject its image observations one by one.

# $start = "A"
# $end = "A"
mark-bar_same_ends = Scale bar { $start } - { $end }: both ends are the same point.
    .do = Give two different points.

# $start = "A"
# $end = "B"
# $sigma = 0.5
# $length = 1.0
# $ratio = 3
mark-bar_sigma = Scale bar { $start } - { $end }: the standard deviation { $sigma } is too large for a length of { $length }.
    .why = It must be at most the length divided by { $ratio }.
    .do = Correct the length or its standard deviation.

# $start = "A"
# $end = "B"
# $known = ["C - D"]
mark-no_bar = There is no scale bar { $start } - { $end }.
    .why = Measured are: { $known }.
    .do = Give the ends of a measured scale bar.

# $line_name = "edge"
# $known = ["L1"]
mark-no_line = There is no line { $line_name }.
    .why = Lines are: { $known }.
    .do = Correct the name.

# $line_name = "L1"
# $kind = "level"
# $n = 2
# $least = 3
mark-line_points = Line { $line_name } (kind { $kind }) has { $n } different points; { $least } are needed.
    .do = Give more points, each once.

# $point = "P1"
# $image = "left.jpg"
mark-no_observation = The block has no observation of point { $point } in image { $image }.
    .do = Remove a mark that was measured by hand; only observations of the block are rejected.

# $point = "P1"
# $image = "left.jpg"
mark-not_rejected = Point { $point } in image { $image } is not rejected by hand.
    .do = Choose an observation that is rejected by hand.

# $kind = "point"
# $name = "' P1'"
# $n = 3
# $most = 200
mark-bad_name = { $kind ->
        [line] Line
        [drawing] Drawing
        [layer] Layer
        [note] Note
        [mask] Mask
        [table] Table
       *[point] Point
     } { $name } has an invalid name ({ $n } characters).
    .why = A name has 1 to { $most } printable characters and no blank at its ends.
    .do = Choose another name.

# $point = "P1"
# $axis = "Z"
mark-sigma_without_coordinate = Point { $point } has a standard deviation of { $axis }, but no { $axis }.
    .do = Give the coordinate.

# $point = "P1"
# $role = "control"
mark-role_without_coordinate = Point { $point } is a { $role ->
        [check] check point
       *[control] control point
     } without coordinates.
    .do = Give at least one coordinate, or make it a tie point.

# $point = "P1"
# $axis = "Z"
mark-control_without_sigma = Control point { $point }: { $axis } has no standard deviation.
    .do = Give one; 0 fixes the coordinate.

# $point = "P9"
# $known = ["P1", "P2"]
# $n = 2
mark-unknown_point = Point { $point } is neither measured nor in the block.
    .why = { $n ->
        [0] No point is measured.
       *[other] Measured are: { $known }.
     }
    .do = Mark it in an image first, or correct its name.

# $point = "P1"
# $image = "left.jpg"
# $images_marked = ["right.jpg"]
# $n = 1
mark-not_marked = Point { $point } is not marked by hand in image { $image }.
    .why = { $n ->
        [0] It is marked in no image.
       *[other] It is marked in: { $images_marked }.
     }
    .do = Choose an image in which it is marked.

# $image = "left.jpg"
# $xy_px2 = 2.0
# $xx_px2 = 1.0
# $yy_px2 = 1.0
mark-covariance = Image { $image }: a covariance of { $xy_px2 } px² is impossible with variances of { $xx_px2 } and { $yy_px2 } px².
    .why = Its size must be below the root of their product.
    .do = Correct the covariance.

# $image = "'x.jpg'"
# $n = 2
# $known = ["left.jpg", "right.jpg"]
mark-unknown_image = Image { $image } is not one of the { $n } images.
    .why = They are { $known }.
    .do = Correct the name.

# $image = "left.jpg"
# $x_px = -5.0
# $y_px = 10.0
# $width_px = 6000
# $height_px = 4000
mark-outside_image = Image { $image }: x = { NUM($x_px, digits: 6) }, y = { NUM($y_px, digits: 6) } is outside its { $width_px } x { $height_px } px.
    .why = Pixels count from the upper left corner of the file as stored, to the right and down.
    .do = Correct the place.

# $mask = "sky"
# $n = 2
# $most = 1000
mark-mask_corners = Mask { $mask } has { $n } corners; 3 to { $most } are possible.
    .do = Draw the polygon again.

# $mask = "sky"
# $area_px2 = 0.2
# $least_px2 = 1.0
mark-mask_area = Mask { $mask }: its corners enclose { NUM($area_px2, digits: 2) } px², less than { $least_px2 } px².
    .do = Give corners that are not on one line.

# $mask = "'sky'"
# $known = ["wall"]
# $n = 1
mark-no_mask = There is no mask { $mask }.
    .why = { $n ->
        [0] No mask is drawn.
       *[other] Masks are: { $known }.
     }
    .do = Correct the name.

# $drawing = "edge"
# $n = 1
# $least = 2
# $most = 5000
mark-drawing_corners = { $drawing } has { $n } corners; { $least } to { $most } are possible.
    .do = Draw it again.

# $drawing = "edge"
# $surface = "'../etc'"
mark-drawing_surface = { $drawing }: { $surface } is no folder within the project.
    .do = Give the name of a surface folder, as surface.

# $drawing = "edge"
# $n = 1
# $known = ["pile"]
mark-no_drawing = There is no drawing { $drawing }.
    .why = { $n ->
        [0] Nothing is drawn.
       *[other] Drawings are: { $known }.
     }
    .do = Use one of these names.

mark-no_masks_at_all = No mask is drawn or read from a folder.
    .do = Draw one in the studio, or with raybundle mark mask.

# $point = "P1"
# $image = "old.jpg"
mark-image_not_in_block = Point { $point } is marked in image { $image }, which is not in the block.
    .why = It was measured in other photographs.
    .do = Remove the mark.

# $point = "P1"
# $distance = 1000000.0
# $unit = "m"
# $ratio = 20000.0
# $limit = 10000.0
mark-control_far_away = Control point { $point } is { $distance } { $unit } from the others, { $ratio } times their extent.
    .why = The limit is { $limit } times.
    .do = Check the decimal point and the unit of its coordinates.

# $image = "IMG_1.jpg"
# $x_px = 5000.0
# $y_px = 120.0
# $width_px = 4000
# $height_px = 3000
# $turned = false
# $orientation = 1
mark-outside_photograph = { NUM($x_px, digits: 6) }, { NUM($y_px, digits: 6) } is outside photograph { $image } ({ $width_px } x { $height_px } px).
    .do = Measure in the photograph at its full size{ $turned ->
     [yes] { "" } and as it is stored (viewers turn it by its EXIF orientation { $orientation })
     *[no] { "" }
    }.

# $point = "M7"
# $adjusted = true
# $folder = "facade-result-measured"
mark-not_in_result = Point { $point } is marked by hand, but is not in this result.
    .do = { $adjusted ->
        [yes] Use { $folder }, the result with the marked points
       *[no] Adjust it with the block first: raybundle mark adjust
     }.

# $limits = ["--residual", "--tau"]
mark-nothing_to_reject = Neither an image point nor one limit is given.
    .do = Give an image and a point, or one of { LIST($limits, most: 9) }.

# $point = "P12"
# $images = ["a.jpg"]
# $n = 1
# $tau = 7.4
# $size_px = 12.5
mark-contradicts = { $n ->
        [one] The mark of { $point } in { $images } contradicts the others{ $size_px ->
            [0] {""}
           *[other] {" "}by { NUM($size_px, digits: 2) } px
        }
       *[other] The marks of { $point } contradict each other: { $images }
    }{ $tau ->
        [0] .
       *[other] {" "}(test value { NUM($tau, decimals: 1) }).
    }
    .do = Check the mark.

# $point = "P12"
# $image = "a.jpg"
# $distance_px = 71.4
# $sigmas = 140
# $images = ["a.jpg"]
# $n = 3
mark-off = The mark of { $point } in { $image } lies { NUM($distance_px, digits: 2) } px ({ NUM($sigmas, digits: 2) } sigma) off.
    .why = The { $n } other { $n ->
        [one] observation sees
       *[other] observations see
    } the point elsewhere. Limit: four standard deviations.
    .do = Check the mark in { LIST($images, most: 4) }, the first one first.

# $point = "P12"
# $image = "a.jpg"
# $distance_px = 71.4
# $sigmas = 140
# $images = ["a.jpg"]
# $n = 3
mark-fits = { $point } fits: { NUM($distance_px, digits: 2) } px ({ NUM($sigmas, digits: 2) } standard deviations) from the others.

# $point = "P12"
# $image = "a.jpg"
# $distance_px = 71.4
# $sigmas = 140
# $images = ["a.jpg"]
# $n = 3
mark-open = { $point } is not tested yet: { NUM($distance_px, digits: 2) } px from the others, larger errors may be hidden.
    .do = Measure it in another photograph, from another direction.

# $point = "P12"
# $image = "a.jpg"
# $n = 900000
# $most = 200000
mark-tested_later = The mark of { $point } in { $image } is not tested yet.
    .why = The block has { $n } image observations; marks are tested at once up to { $most }.
    .do = `raybundle mark adjust` tests all marks.

# $n = 5
# $missed = 40.2
# $limit = 4.1
# $unit = "m"
# $exchanged = 3
mark-control_names = { $n } control points do not fit their marks: after a common shift they miss by { NUM($missed, digits: 2) } { $unit }.
    .why = This is the median; the photographs allow { NUM($limit, digits: 2) } { $unit }.{ $exchanged ->
        [0] { "" }
       *[other] { " " }With other names they fit:
    }
    .do = Check names, unit and order of the coordinates in the control table.

# $point = "P2"
# $at = "P1"
mark-control_named = The coordinates of { $point } are those of the marks of { $at }.

# $point = "P1"
# $distance = 142000
# $extent = 210
# $limit = 2100
# $unit = "m"
# $crs = "EPSG:25832"
mark-control_apart = The nearest control point, { $point }, is { NUM($distance, digits: 3) } { $unit } from the photographs.
    .why = The photographs and what they show extend over { NUM($extent, digits: 2) } { $unit }; { NUM($limit, digits: 2) } { $unit } are allowed.
    .do = Check coordinate system{ $crs ->
        [none] { "" }
       *[other] { "" } (the project has { $crs })
    }, unit and order of the coordinates.

# $n = 2
# $of = 5
# $points = ["C04", "C05"]
mark-control_unmarked = { $n } of { $of } control points are marked in no photograph: { LIST($points, most: 8) }.
    .do = Mark them under these names, or check the names.
