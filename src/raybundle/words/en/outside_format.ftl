# $n = 3
# $point = "P7"
# $image = "IMG_1"
# $x_px = -30.5
# $y_px = 100.0
# $width_px = 4000
# $height_px = 3000
# $ids = ["IMG_1"]
outside_format = { $n } image { $n ->
        [one] point lies
       *[other] points lie
     } outside the format of { $ids }.
    .why = Farthest: point { $point } at { NUM($x_px, digits: 6) }, { NUM($y_px, digits: 6) } px in { $image } ({ $width_px } × { $height_px } px).
    .do = Check width_px and height_px of the camera, and unit and origin of the image points (outer corner of the first pixel, y down).
