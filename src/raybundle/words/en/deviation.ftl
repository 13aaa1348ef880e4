# $image = "img_07"
# $parameter = "c"
deviation-parameter_not_free = Image { $image } in deviations.csv: { $parameter } is not estimated per image.
    .do = Add it to per_image and estimate of the camera, or set interior = "per_image".
