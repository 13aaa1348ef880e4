# $unit = "m"
axis-across = across [{ $unit }]

# $arc = true
axis-along = { $arc ->
        [yes] along the arc
        *[no] along the line
    } [px]

# $unit = "m"
axis-along_object = along the object [{ $unit }]

axis-base_to_depth = base-to-depth ratio

# $unit = "µm"
axis-correction = correction [{ $unit }]

axis-coverage = coverage [%]

axis-distance = distance [px]

axis-distance_from_middle = distance from the middle / half diagonal

axis-error = error [mm]

axis-expected_quantile = expected quantile

axis-height = height

# $unit = "m"
axis-height_in = height [{ $unit }]

axis-image_scale = image scale number

axis-images_in_order = image, in the order of the block

axis-largest_intersection_angle = largest intersection angle [°]

axis-length = length [m]

axis-line = line [px]

axis-mean_redundancy = mean redundancy number

axis-mean_residual = mean residual [px]

# $kind = "velocity"
# $unit = "m/s"
axis-motion = { $kind ->
        [velocity] velocity
        *[rotation] rotation
    } [{ $unit }]

# $unit = "mm"
axis-observed_minus_adjusted = observed − adjusted [{ $unit }]

# $angle = "direction"
axis-panorama = { $angle ->
        [direction] direction
        *[elevation] elevation
    } [°]

axis-radius = radius from the principal point [mm]

axis-rays_per_point = rays per point

axis-redundancy_number = redundancy number

# $axis = "x"
axis-residual_in = residual in { $axis } [px]

axis-right = right

# $unit = "m"
axis-right_in = right [{ $unit }]

axis-rigorous_minus_rpc = rigorous − RPC [px]

axis-rms = rms [px]

axis-rms_residual = rms residual [px]

# $axis = "X"
# $unit = "mm"
axis-sigma = sigma { $axis } [{ $unit }]

# $unit = "mm"
axis-sigma_of_point = sigma of a point [{ $unit }]

# $unit = "µm"
axis-standard_deviation = standard deviation [{ $unit }]

axis-time = time [s]

axis-time_from_first_line = time from the first line [s]

axis-up = up

# $unit = "m"
axis-up_in = up [{ $unit }]

# $unit = "m"
axis-way_flown = way flown [{ $unit }]

axis-smallest_blunder = smallest detectable blunder [px]

axis-image_coordinates = image coordinates

axis-normalised_residual = normalised residual

axis-days = days

axis-displacement = displacement [mm]
