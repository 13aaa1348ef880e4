# $kind = "control"
observations-covariance_not_positive = Observations ({ observations-kind }): the covariance matrix is not positive definite.
    .do = Correct these covariances.

# $block = "facade"
# $kind = "distance"
observations-none_of_kind = Block { $block } has no observations of the kind { $kind }.
    .do = Add its table: block.having(table).

# $kind = "distance"
observations-without_partials = The observations of the kind { $kind } have no partial derivative by any unknown.
    .do = State the partial derivatives of the kind.

# $kind = "distances"
observations-kind = { $kind ->
        [image_observations] image points
        [camera] image points
        [control] control coordinates
        [distances] scale bars
        [stations] projection centres
        [attitudes] attitudes
        [planes] points on planes
        [straight_lines] points on straight lines
        [plumb_lines] points on plumb lines
        [levels] points at levels
        [coordinates_of_networks] coordinates of networks
        [deviations_of_single_images] deviations of single images
        [parameters] observed parameters
        [relations] relations of parameters
        [directions] horizontal directions
        [zenith_angles] zenith angles
        [slope_distances] slope distances
       *[other] { $kind }
     }

# $behind = 3
# $diverging = 1
# $rows = [7, 12, 40]
observations-astray = Image observations behind the camera: { $behind }; of points that diverge to infinity: { $diverging }.
    .why = They are in rows { LIST($rows, most: 5) } of the observations.
    .do = Check the point numbers, or leave these observations out.
