joint-no_covariances = La compensation n'a pas de covariances.

joint-image_not_used = L'image { $image } n'est pas dans la compensation.

joint-point_not_used = Le point { $point } n'est pas dans la compensation.

joint-no_named_points = { $name } : aucun point compensé n'a de nom propre.

joint-too_many_points = { $name } : { $n } points ; une covariance conjointe est possible pour { $most }.

joint-unknown_point = Le point { $point } n'est pas dans le résultat.
