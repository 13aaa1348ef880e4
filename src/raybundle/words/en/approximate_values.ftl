# $n = 2
# $images = ["IMG_1", "IMG_2"]
approximate_values-images = { $n } { $n ->
        [one] image has
       *[other] images have
     } no exterior orientation: { LIST($images, most: 10) }.
    .do = Give approximate values.

# $n = 2
# $points = ["P1", "P2"]
approximate_values-points = { $n } { $n ->
        [one] point has
       *[other] points have
     } no coordinates: { LIST($points, most: 10) }.
    .do = Give approximate values.

# $n = 2
# $images = ["IMG_1", "IMG_2"]
approximate_values-images_beside_scenes = { $n } { $n ->
        [one] image has
       *[other] images have
     } no exterior orientation beside satellite scenes: { $images }.
    .do = Adjust the photographs separately and give their result, in the frame of the block, as approximate values.

# $n = 2
# $points = ["P1", "P2"]
approximate_values-points_beside_scenes = { $n } { $n ->
        [one] point has
       *[other] points have
     } no coordinates and no rays of two scenes: { $points }.
    .do = Adjust the photographs separately and give their result, in the frame of the block, as approximate values.
