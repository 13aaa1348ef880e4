label-accuracy = Accuracy

label-adjusted = Adjusted

label-adjusted_minus_given = adjusted minus given

label-block = block

label-blunders = Blunders

label-camera = camera

label-cameras = Cameras

label-check_points = check points

label-control = Control

label-coordinate = coordinate

label-correlation = correlation

label-cross_validation = cross-validation

label-datum = datum

label-fit = Fit

label-format = format

label-given = given

label-image_observations = image observations

label-image_points = image points

label-images = images

label-known_lengths = Known lengths

label-leave_one_out = leave-one-out

label-length = length

label-object_points = object points

label-observations = observations

label-parameter = parameter

label-photographs = photographs

label-point = point

label-point_standard_deviation = standard deviation of object points

label-precision = Precision

label-projection_uncertainty = uncertainty of projection

label-quantity = quantity

label-redundancy = redundancy

label-relative_precision = relative precision

label-role = role

label-standard_deviation = standard deviation

label-unknowns = unknowns

label-value = value
