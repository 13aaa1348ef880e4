noise-singular_points = some image points do not determine their object points

# $n = 3
# $least = 10
noise-few_directions = the residuals determine { $n } directions of smooth errors only ({ $least } needed)

noise-no_statistics = statistics are off

noise-no_redundancy = there is no redundancy

noise-rig = images share the exterior orientation of a rig

# $models = ["rpc"]
noise-no_format = the sensor model { $models } has no plane format

# $n = 4
# $least = 5
noise-too_few_photographs = { $n } photographs are too few for smooth errors of their own (at least { $least } are needed)
