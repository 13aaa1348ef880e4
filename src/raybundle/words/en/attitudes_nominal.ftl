# $sigma_deg = 1.0
attitudes_nominal = The rotation of the block about the line of its positions rests on the attitudes alone.
    .why = The mounting of the camera is assumed to be as stated to { $sigma_deg }°.
    .do = Fly a line across, or give control.
