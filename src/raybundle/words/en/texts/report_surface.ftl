# $name = "wall"
report_surface-title = Surface of { $name }

report_surface-subtitle = Dense points with standard deviations

# $n = 18803
# $maps = 24
report_surface-points = { $n } { $n ->
        [one] point
        *[other] points
    } from { $maps } depth { $maps ->
        [one] map
        *[other] maps
    }.

# $sigma = 0.7
# $unit = "mm"
report_surface-median_sigma = Standard deviation of a point: { NUM($sigma, digits: 2) } { $unit } (median).

report_surface-no_scale = The scale is arbitrary: coordinates and standard deviations have no absolute unit.

# $n = 2
report_surface-photographs_lost = { $n } { $n ->
        [one] photograph
        *[other] photographs
    } of the adjustment could not be used.

# $n = 3
# $share = 0.3
report_surface-incomplete_maps = { $n } depth maps cover less than { PERCENT($share) } % of the photograph.

# $name = "c.jpg"
# $share = 0.2
report_surface-incomplete_map = The depth map of { $name } covers { PERCENT($share) } % of the photograph.

# $n = 1
report_surface-excluded = { $n } { $n ->
        [one] photograph or pair was
        *[other] photographs or pairs were
    } excluded.

report_surface-warnings = Warnings and remedies

report_surface-adjustment = Underlying adjustment

report_surface-files = Files

report_surface-contents = contents

# $file_name = "points_ply"
report_surface-file = { $file_name ->
        [points_ply] points with colours and standard deviations
        [points_las] points for programs that read LAS
        [map_las] points for programs that read LAS, in the coordinate system
        [heights_tif] grid of heights
        [heights_sigma_tif] standard deviations of the heights, by component
        [heights_toml] position and unit of the grid, restrictions of use
        [heights_orientation_npz] effect of the orientation on heights, for sums and differences
        [orthophoto_tif] true orthophoto
        [orthophoto_sigma_tif] standard deviation of the position of its pixels
        [orthophoto_toml] position of the orthophoto, photographs used
        [mesh_ply] mesh with standard deviations
        [mesh_obj] mesh with the orthophoto, for modelling programs
        [mesh_glb] the same in one file, for browsers
        [depths] depth maps of the photographs
        *[surface_3d_html] points and network in three dimensions
    }

# $thinned = true
# $length = 0.02
report_surface-earlier_points = points of an earlier run, { $thinned ->
        [yes] thinned by { $length }
        *[no] not thinned
    }

report_surface-sigma_of_point = standard deviation of a point

# $x = 0.3
# $y = 0.4
# $z = 0.5
# $unit = "mm"
report_surface-of_position = median of the root of the sum of squares: X { NUM($x, digits: 2) }, Y { NUM($y, digits: 2) }, Z { NUM($z, digits: 2) } { $unit }
    .why = In the datum of the result.

report_surface-sigma_along_ray = standard deviation along the ray

# $sigma_90 = 1.0
# $sigma_99 = 2.0
# $unit = "mm"
report_surface-quantiles = median; 90 % below { NUM($sigma_90, digits: 2) } { $unit }, 99 % below { NUM($sigma_99, digits: 2) } { $unit }

report_surface-photographs_per_point = photographs per point

# $share = 0.3
report_surface-by_two = mean; { PERCENT($share) } % from two

report_surface-grazing = grazing rays

report_surface-grazing_limit = points at less than 17 degrees to the surface

report_surface-excluded_name = excluded

report_surface-excluded_caption = Excluded photographs and pairs

# $n = 24
report_surface-of_maps = of { $n } depth { $n ->
        [one] map
        *[other] maps
    }

# $n = 24
# $of = 18803
report_surface-thinned_maps = of { $n } depth { $n ->
        [one] map
        *[other] maps
    }; thinned from { $of }

report_surface-heights = Heights

# $of = "map"
# $share = 0.83
report_surface-heights_shown = Heights { $of ->
        [map] in the coordinate system
        [plane] above the plane
        *[free] above the plane, no unit
    }; { PERCENT($share) } % of the cells have a height.

# $of = "map"
report_surface-heights_drawing = heights { $of ->
        [map] in the coordinate system
        [plane] above the plane
        *[free] above the plane, no unit
    }

report_surface-unmeasured_grey = Grey: not measured.

report_surface-sigma_of_height = standard deviation of a height

report_surface-sigma_of_heights = standard deviations of heights

report_surface-total_sigma = Standard deviations of the heights, all components together.

report_surface-profile = Profile through the middle of the heights, with the band of 1.96 standard deviations.

report_surface-orthophoto = Orthophoto

# $share = 0.7
report_surface-orthophoto_shown = True orthophoto; photographs cover { PERCENT($share) } % of its pixels. Grey: not covered.

# $sigma = 0.5
# $unit = "mm"
report_surface-orthophoto_sigma = Standard deviation of a position in plan: { NUM($sigma, digits: 2) } { $unit } (median).

report_surface-sources = sources

report_surface-points_given = points used

report_surface-depth_maps = Depth maps

# $of_part = false
report_surface-measured_share = measured: share of the pixels with a depth{ $of_part ->
        [yes] {""}, around the selected region
        *[no] {""}
    }.
    .why = { $of_part ->
            [yes] {""}
            *[no] Sky and places in one photograph alone have none.
        }

report_surface-map_sigma = sigma: along the ray, median.

report_surface-best_map = Of a point in several maps, the most precise depth is used.

# $share = 0.7
report_surface-map_measured = { PERCENT($share) } % measured

report_surface-standard_deviations = Standard deviations

report_surface-correlation = Stated correlation of the errors of two points, by their distance in the photograph.
    .why = By noise and roughness; errors of orientation and calibration extend over the whole object.

report_surface-components = Noise: scatter of grey values, measured in these photographs.

report_surface-roughness_meaning = Roughness: variation of the surface within the window of 7 x 7 pixels.

report_surface-orientation_meaning = Orientation: exterior and interior orientation, from their joint covariance.

report_surface-mean_of_points = Orientation limits the precision of means over many points. Sums of heights include it.

report_surface-common_errors = Not included: errors common to all photographs, as of reflections, water, glass and moving shadows.

# $part = "noise"
report_surface-component = { $part ->
        [noise] noise of grey values
        [roughness] roughness
        [orientation] orientation and calibration
        *[total] total
    }

report_surface-component_column = component

# $share = 90
report_surface-below = { $share } % below

report_surface-components_caption = Components of the standard deviations along the ray

report_surface-result = Result
