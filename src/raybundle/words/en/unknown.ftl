# $image = "IMG_1"
# $part = "X"
unknown-image = Exterior orientation of image { $image }: { $part ->
        [rotation_x] rotation about x
        [rotation_y] rotation about y
        [rotation_z] rotation about z
       *[other] { $part }
     }

# $symbol = "c"
# $camera = "d5100"
unknown-parameter = { $symbol } of camera { $camera }

# $point = "P7"
# $axis = "X"
unknown-point = Point { $point }: { $axis }

# $number = 12
unknown-other = Unknown { $number }
