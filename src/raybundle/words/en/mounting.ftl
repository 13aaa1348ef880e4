mounting-no_attitudes = No image has both an adjusted orientation and an attitude.
    .do = Give attitudes of the oriented images.

mounting-no_positions = No image has both an adjusted orientation and a position.
    .do = Give positions of the oriented images.

# $n = 1
mounting-lever_arm = { $n } { $n ->
        [one] image has
       *[other] images have
     } an orientation and a position; a lever arm needs two.
    .do = Give more positions of oriented images.
