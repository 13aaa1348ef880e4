# $image = "IMG_1"
# $distance = 333.6
# $ids = ["IMG_1"]
position_left_out = The position of { $image } contradicts the others by { $distance } m and is not used.
    .do = Check its coordinates, its name and the fix of the receiver.
