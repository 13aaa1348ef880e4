# $mend = "y_up"
images_mirrored-mend = { $mend ->
     [y_up] y of the image points is counted upwards
     [x_left] x of the image points is counted to the left
     [xy_negative] x and y of the image points are exchanged, with wrong signs
     *[xy] x and y of the image points are exchanged
    }

# $mend = "y_up"
# $misfit = 0.002
images_mirrored = The object is a mirror image of the given orientation, which fits mirrored to { NUM($misfit, digits: 2) } of its extent.
    .do = Correct observations.csv: x counts to the right, y down. Cause:
