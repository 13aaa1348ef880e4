# $arc = true
# $angle = "direction"
drawn-along_against = residuals along the { $arc ->
        [yes] arc
        *[no] line
    } against { $angle ->
        [direction] direction
        *[elevation] elevation
    }

# $component = "east"
# $kind = "antenna"
# $name = "1"
drawn-along_line = observed minus adjusted, { $component }, along { $kind ->
        [antenna] antenna { $name }
        [positions] the positions
        *[attitudes] the attitudes
    }

drawn-balanced = balanced

drawn-base_to_depth = base-to-depth ratios

# $most = 320
drawn-common_points_to = 0 … { $most } common points

# $quantity = "height"
drawn-correction = correction of the { $quantity ->
        [position_along_track] position along track
        [position_across_track] position across track
        [height] height
        [attitude_about_x] attitude about x
        [attitude_about_y] attitude about y
        *[attitude_about_z] attitude about z
    } against time

# $camera = "d5100"
# $image = "a.jpg"
drawn-corrections = corrections over the format of camera { $camera } { $image }

drawn-correlation_by_distance = correlation by distance

# $camera = "d5100"
# $image = "a.jpg"
drawn-correlations = correlations of the interior orientation of camera { $camera } { $image }

drawn-coverage = coverage of the image format

# $name = "a.jpg"
drawn-depth_map = depth map of { $name }

# $axis = "X"
drawn-deviations_of = standard deviations of { $axis }

# $kind = "radial"
# $camera = "d5100"
# $image = "a.jpg"
drawn-distortion = { $kind ->
        [radial] radial
        *[decentring] decentring
    } distortion of camera { $camera } { $image }

# $camera = "d5100"
# $image = "a.jpg"
drawn-distortion_sigma = standard deviation of the radial distortion of camera { $camera } { $image }

drawn-exterior_correlations = correlations with exterior orientation

drawn-gaussian = Gaussian

# $n = 420
drawn-image_points = { $n } image { $n ->
        [one] point
        *[other] points
    }

drawn-image_scales = image scales

# $n = 12
drawn-images = { $n } { $n ->
        [one] image
        *[other] images
    }

# $most = 9
drawn-images_to = 0 … { $most } images

drawn-intersection_angles = intersection angles

drawn-its_sigma = its sigma

drawn-jitter = rigorous model minus its RPC along the lines

drawn-length_errors = errors of lengths over the lengths

# $point = "1001"
# $known = true
# $residual_px = 0.42
# $rejected = false
drawn-mark = { $point }: { $known ->
        [yes] { NUM($residual_px, digits: 2) } px
        *[no] no residual
    }{ $rejected ->
        [yes] , rejected
        *[no] {""}
    }

drawn-marks = marked points in their images with residuals

drawn-match_graph = images and the points that they share

drawn-match_matrix = common points of every two images

# $camera = "d5100"
drawn-mean_residuals = mean residuals of camera { $camera }

# $camera = "d5100"
drawn-mean_residuals_by_radius = mean residuals of camera { $camera } against the radius

# $kind = "velocity"
drawn-motion = { $kind ->
        [velocity] velocity
        *[rotation] rotation
    } during read-out

drawn-network_views = plan and side views of the network

drawn-no_observation = no observation

drawn-normalised_histogram = histogram of normalised residuals

drawn-normalised_quantiles = quantiles of normalised residuals

# $side = "above"
# $n = 1200
drawn-object = the object { $side ->
        [above] from above
        *[square] square to its best-fitting plane
    }, { $n } { $n ->
        [one] point
        *[other] points
    } coloured by standard deviation

# $plan = false
# $median = false
drawn-object_colours = Colour: standard deviation of a coordinate, rms of { $plan ->
        [yes] the plan
        *[no] X, Y and Z
    }{ $median ->
        [yes] ; median of neighbouring points
        *[no] {""}
    }.

# $side = "above"
# $n = 1200
drawn-object_points = The object { $side ->
        [above] from above
        *[square] square to its best-fitting plane
    }: { $n } object { $n ->
        [one] point
        *[other] points
    }.

# $outside = 2
drawn-object_stations = Small triangles: photographs{ $outside ->
        [0] {""}
        *[other] {" "}({ $outside } outside)
    }.

drawn-overlap = number of images at each place

# $first = "a.jpg"
# $second = "b.jpg"
# $n = 120
drawn-pair = { $first } – { $second }: { $n } common { $n ->
        [one] point
        *[other] points
    }

drawn-panorama = directions of the image points and eccentricity of the projection centre

drawn-precision_of_points = precision of points

drawn-profile = profile of heights

drawn-projection_uncertainty = standard deviation of projection over the format

drawn-radial = radial

drawn-ray_map = object points by number of rays

drawn-redundancy_histogram = histogram of redundancy numbers

# $camera = "d5100"
drawn-redundancy_map = redundancy numbers over the format of camera { $camera }

drawn-redundancy_of_images = mean redundancy number of each image

# $axis = "x"
drawn-residuals_along_track = residuals in { $axis } along the track

drawn-residuals_by_radius = residuals by radius

drawn-rms_of_images = rms residual of each image

drawn-rolls = rolls of the images

drawn-rpc_bias = bias of the RPC over the scene

# $angle_deg = 45
# $n = 12
drawn-spoke = { $angle_deg }°: { $n } { $n ->
        [one] image
        *[other] images
    }

drawn-tangential = tangential

drawn-vector_scale = scale of the vectors

# $kind = "deviations"
drawn-vectors = { $kind ->
        [displacements] displacements
        *[deviations] deviations from nominal
    }

# $kind = "deviations"
# $across = false
drawn-vectors_in = { $kind ->
        [displacements] Displacements
        *[deviations] Deviations from nominal
    } { $across ->
        [yes] across the best-fitting plane, seen from its lower edge
        *[no] in the best-fitting plane
    }, with their scale.

# $image = "a.jpg"
drawn-vectors_of_image = residual vectors of image { $image }

# $name = "IMG_3.jpg"
# $n = 1200
drawn-photograph_points = Photograph { $name } with its { $n } object { $n ->
        [one] point
        *[other] points
    } in the same colours.

# $name = "area 3"
drawn-displacement_over_time = displacement of { $name } over time
