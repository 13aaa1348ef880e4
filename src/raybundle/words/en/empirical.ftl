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
