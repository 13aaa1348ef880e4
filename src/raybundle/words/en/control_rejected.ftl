# $point = "A"
# $w = 6.1
# $ids = ["A"]
control_rejected = Control point { $point } contradicts the other observations (|w| { NUM($w, decimals: 1) }) and takes no part.
    .do = Check its coordinates and its number in the images.
