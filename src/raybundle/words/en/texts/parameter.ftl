parameter-affinity = affinity

parameter-angular_scale = angular scale: turn of the encoder over x / c, minus 1

parameter-bias_shift_x = shift of x

parameter-bias_shift_y = shift of y

parameter-bias_x_columns = change of x along the columns

parameter-bias_x_rows = change of x along the rows

parameter-bias_y_columns = change of y along the columns

parameter-bias_y_rows = change of y along the rows

parameter-camera_constant = camera constant

parameter-camera_constant_stereographic = camera constant of the stereographic projection

# $quantity = "along"
# $axis = "x"
# $curve = true
# $number = 3
parameter-correction = { $quantity ->
        [along] position along track
        [across] position across track
        [up] height of the position
        *[other] attitude about { $axis }
    }, { $curve ->
        [yes] coefficient { $number } in time
        *[no] power { $number } of the time
    }

parameter-decentring = decentring distortion

# $axis = "x"
parameter-detector_lever_arm = lever arm along the detector's { $axis } axis

parameter-drift_x = drift of X

parameter-drift_y = drift of Y

parameter-drift_z = drift of Z

parameter-eccentricity_across = eccentricity of the projection centre across the view

parameter-eccentricity_along = eccentricity of the projection centre along the view

parameter-fourfold = fourfold distortion

parameter-horizon = image of the horizon

# $first = 1
# $second = 3
parameter-knot_x = shift in x, knot { $first }, { $second }

# $first = 1
# $second = 3
parameter-knot_y = shift in y, knot { $first }, { $second }

parameter-knots_height = height of the field of knots: that of the format; held

parameter-knots_width = width of the field of knots: that of the format; held

parameter-lever_arm_backwards = lever arm backwards

parameter-lever_arm_right = lever arm to the right in the image

parameter-lever_arm_up = lever arm upwards in the image

parameter-line_inclination = inclination of the line along the view

parameter-line_place = place of the line in the focal plane, along the way

parameter-line_tilt = tilt of the line about the view

parameter-misalignment_viewing = misalignment about the viewing axis

parameter-misalignment_x = misalignment about the image's x axis

parameter-misalignment_y = misalignment about the image's y axis

parameter-motion_along = motion along the way

parameter-motion_backwards = motion backwards

parameter-motion_change_along = change of the motion along the way

parameter-motion_change_backwards = change of the motion backwards

parameter-motion_change_right = change of the motion to the right

parameter-motion_right = motion to the right

parameter-principal_point = principal point

parameter-principal_point_line = principal point on the line

parameter-radial = radial distortion

parameter-radial_denominator = radial distortion, denominator

parameter-radial_ideal = radial distortion at the ideal point

parameter-radial_line = radial distortion along the line

parameter-radial_numerator = radial distortion, numerator

parameter-read_out = read-out time over height of the format

parameter-rig_kappa = kappa of the camera against the rig

parameter-rig_omega = omega of the camera against the rig

parameter-rig_phi = phi of the camera against the rig

parameter-rig_x = offset of the projection centre, x of the rig

parameter-rig_y = offset of the projection centre, y of the rig

parameter-rig_z = offset of the projection centre, z of the rig

parameter-rotation_rate_viewing = rotation rate about the viewing axis

parameter-rotation_rate_x = rotation rate about the x axis

parameter-rotation_rate_y = rotation rate about the y axis

parameter-shear = shear

parameter-shift_x = shift of X

parameter-shift_y = shift of Y

parameter-shift_z = shift of Z

parameter-sphere_radius = radius of the sphere

parameter-range_offset = range offset: delay of the signal, clock

parameter-range_rate = change of the range offset along the range

parameter-thin_prism_x = thin prism in x

parameter-thin_prism_y = thin prism in y

parameter-threefold = threefold distortion

parameter-time_of_line = time of the trajectory minus that of the line

parameter-time_of_positions = time of the positions minus that of the exposures

parameter-time_offset = time of the tables minus that of the lines

parameter-tumbling_cosine = tumbling of the axis, cosine of twice the turn

parameter-tumbling_sine = tumbling of the axis, sine of twice the turn

parameter-turn_change_viewing = change of the turn about the viewing axis

parameter-turn_change_x = change of the turn about the x axis

parameter-turn_change_y = change of the turn about the y axis

parameter-turn_viewing = turn about the viewing axis

parameter-turn_x = turn about the x axis

parameter-turn_y = turn about the y axis

parameter-twofold = twofold distortion

parameter-velocity_backwards = velocity backwards

parameter-velocity_right = velocity to the right

parameter-velocity_up = velocity upwards in the image

parameter-zero_radius = radius at which the radial terms vanish; a definition, not estimated
