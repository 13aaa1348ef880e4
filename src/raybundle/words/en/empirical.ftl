# $model = "projective"
# $names = ["K9"]
# $known = ["a1", "a2"]
# $n = 2
empirical-no_additional_parameter = { $model }: { $names } cannot be excluded.
    .do = { $n ->
        [0] Exclude no parameter of this model
       *[other] Exclude only { LIST($known, most: 20) }
     }.

# $model = "projective"
# $object = 5
# $image = 5
# $parameters = 11
# $least = 6
empirical-too_few_points = { $model }: { $object } object and { $image } image points; { $least } pairs are needed.
    .why = The model has { $parameters } parameters.
    .do = Measure more points, or use a model with fewer parameters.

# $model = "projective"
# $n = 11
empirical-not_determined = { $model }: these points do not determine its { $n } parameters.
    .why = They are too few, or lie in a plane or on a line.
    .do = Use a model with fewer parameters, or add points at other heights.

# $model = "projective"
# $n = 100
empirical-no_minimum = { $model }: no minimum after { $n } iterations.
    .why = The points may contain a blunder.
    .do = Check the points.

# $name = "'dlt9'"
# $known = ["affine", "projective"]
empirical-unknown_model = Empirical model { $name } is unknown.
    .do = Use one of { LIST($known, most: 20) }.

empirical-none_fitted = No empirical model can be fitted.
    .do = Add points, or use another model.

empirical-excluded_needs_model = { OPTION("without") } needs one model.
    .do = Give { OPTION("model", "dlt-brown") }.

# $model = "dlt"
empirical-no_redundancy = { $model } has no redundancy; the fit cannot be assessed.
    .why = A blunder in any point distorts the model without a residual.
    .do = Add points, or use a model with fewer parameters.

# $model = "affine"
# $x_px = 0.36
# $y_px = 0.12
# $sigma_px = 0.5
empirical-adequate = { $model }: residuals of { $x_px }, { $y_px } px (rms) agree with a sigma of { $sigma_px } px.
    .do = Use the model within the area and the heights of these points only.

# $model = "affine"
# $x_px = 0.36
# $y_px = 0.12
# $sigma_px = 0.5
# $ratio = 12.0
# $limit = 1.1
empirical-not_adequate = { $model } is not adequate for this scene: residuals of { $x_px }, { $y_px } px (rms).
    .why = They are { $ratio } times as large as a sigma of { $sigma_px } px explains (limit { $limit }).
    .do = Use the RPC or rigorous model of the scene, or a model with more parameters.

# $model = "dlt-brown"
# $left_out_px = 3.2
# $sigma_px = 0.5
empirical-none_adequate = No model is adequate; { $model } is the nearest: { $left_out_px } px (rms) at coordinates left out.
    .why = The stated sigma is { $sigma_px } px.
    .do = Look for blunders, or use a physical model.

# $model = "dlt-brown"
# $n = 13
# $left_out_px = 0.42
empirical-advised = { $model } is adequate with { $n } parameters: { $left_out_px } px (rms) at coordinates left out.
    .do = Use this model within the area and the heights of the points only.
