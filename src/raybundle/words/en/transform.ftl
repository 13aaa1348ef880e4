# $name = "rotation"
# $shape = [2, 3]
# $needed = [3, 3]
transform-wrong_shape = Array { $name } of a transformation: shape ({ $shape }), or values that are not finite.
    .do = Give finite numbers of shape ({ $needed }).
