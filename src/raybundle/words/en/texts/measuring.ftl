# $n = 2
# $of = 4
measuring-oriented = { $n } of { $of } { $of ->
        [one] photograph
        *[other] photographs
    } oriented

# $kind = "common"
# $image = "old_3.jpg"
# $other = "old_1.jpg"
# $n = 4
measuring-next_step = { $kind ->
        [fiducials] { $image } needs { $n } more fiducial { $n ->
            [one] mark
            *[other] marks
        }
        [film] The fiducial marks of { $image } contradict each other
        [common] { $image } and { $other } need { $n } more common { $n ->
            [one] point
            *[other] points
        }
        [base] { $image } and { $other } were taken from one place
        [marks] { $image } has no point in common with another photograph
        [fit] No orientation fits the points of { $image }
        *[points] { $image } needs { $n } more { $n ->
            [one] point
            *[other] points
        }
    }

# $n = 60000
measuring-large_block = A block of { $n } image observations is adjusted on request only.

measuring-not_adjusted = The photographs are oriented but not adjusted.
    .do = Measure more points.

measuring-interior_held = The points do not determine the interior orientation; its approximate values are held.
    .do = Measure more points.

# $camera = "d5100"
# $c_px = 4600.0
measuring-constant_open = Camera { $camera }: the points do not determine its constant; { NUM($c_px, decimals: 0) } px is a guess.

# $camera = "d5100"
# $c_px = 4600.0
# $sigma_px = 35.0
measuring-constant_of_points = Camera { $camera }: constant { NUM($c_px, decimals: 0) } px, sigma { NUM($sigma_px, decimals: 0) } px, from the points alone.

# $image = "old_1.jpg"
# $marks = ["F6"]
measuring-suspect_fiducials = Scan { $image }: suspect fiducial marks: { $marks }.
    .do = Measure them again.

# $x = 120.0
# $y = -35.0
measuring-outside_scan = expected at { NUM($x, decimals: 0) }, { NUM($y, decimals: 0) }, outside the scan

# $x = 120.0
# $y = 135.0
measuring-nothing_found = nothing at { NUM($x, decimals: 0) }, { NUM($y, decimals: 0) }:

# $kind = "csv"
measuring-file_lacks = { $kind ->
        [csv] A CSV of points
        *[gcp_list] A gcp_list.txt
    } cannot hold all that was measured.
    .do = A block folder holds all.

# $what = "scale_bars"
# $n = 2
measuring-lost_thing = { $what ->
        [scale_bars] scale bars: { $n }
        [lines] lines: { $n }
        [datum] coordinate system by points
        [rejections] rejections: { $n }
        [names] new names of points of the block: { $n }
        [tie_points] tie points: { $n }
        [partial_points] points without all three coordinates: { $n }
        [check_roles] role of check points, which are read as control
        [point_sigmas] standard deviations of points
        *[mark_sigmas] standard deviations of marks
    }

# $n = 1
# $oriented = false
measuring-too_few_marks = { $n ->
        [0] not marked in any
        *[other] marked in one
    } { $oriented ->
        [yes] oriented image
        *[no] image
    }{ $n ->
        [0] {""}
        *[other] {" "}only
    }

# $role = "check"
# $oriented = false
measuring-unmarked_point = { $role ->
        [check] check point
        *[control] control point
    } that is not marked in any { $oriented ->
        [yes] oriented image
        *[no] image
    }

measuring-not_in_block = not in the block

# $point = "P7"
# $cause = "not in the block"
measuring-point_left_out = point { $point } is left out ({ $cause })

measuring-image_not_oriented = The image is not oriented.

measuring-point_outside = The point is behind the image, or far outside its format.

measuring-image_not_adjusted = An image takes no part in the adjustment: there is no covariance.

measuring-no_other_mark = The point is not marked in another oriented image.

# $image = "old_1.jpg"
measuring-ray_outside = Its ray from { $image } passes outside the format at all likely depths.

measuring-seen_once = Marked in one image: the depth is unknown.

measuring-no_statistics = The adjustment was made without statistics: there are no covariances.

measuring-block_not_adjusted = The block is not adjusted: orientations count as free of error.

# $extent = 0.12
# $quantity = "plane"
measuring-expected_extent = With this precision { NUM($extent, digits: 2) } is expected of a perfect { $quantity ->
        [plane] plane
        *[line] line
    }.

measuring-no_scale = No scale is defined: the value has no unit, and its sigma holds within the network.

measuring-free_datum = The datum is free: sigma holds within the network.

measuring-minimal_datum = Sigma refers to the fewest coordinates held; these may differ from those of the result's tables.

measuring-near_zero = A distance not well above its sigma is not normally distributed.

# $n = 3
measuring-masks_written = { $n } { $n ->
        [one] mask is
        *[other] masks are
    } written.

# $n = 2
measuring-photographs_not_found = { $n } { $n ->
        [one] photograph is
        *[other] photographs are
    } not at the place that the project records: without masks.
