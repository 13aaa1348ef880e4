# $image = "IMG_1"
# $part = "X"
unknown-image = Image { $image }: { $part ->
        [rotation_x] the rotation about x
        [rotation_y] the rotation about y
        [rotation_z] the rotation about z
        *[other] coordinate { $part } of the projection centre
    } is not determined.

# $symbol = "c"
# $camera = "d5100"
unknown-parameter = Parameter { $symbol } of camera { $camera } is not determined.

# $point = "P7"
# $axis = "X"
unknown-point = Point { $point }: coordinate { $axis } is not determined.

# $number = 12
unknown-other = Unknown { $number } is not determined.
