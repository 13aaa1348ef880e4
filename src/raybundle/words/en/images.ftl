# $parallel = 90
# $points = 100
# $limit_deg = 0.2
# $images = ["IMG_1", "IMG_2"]
images-no_base = The rays to { $parallel } of { $points } object points are parallel within { $limit_deg }°: { $images }.
    .why = These images have no base, are the same photograph, or have wrong orientations or point numbers.
    .do = Take images from different stations, or check the given values.
