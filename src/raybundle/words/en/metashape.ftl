metashape-no_calibration = No sensor has a calibration.
    .do = Align the photographs in Metashape, then export again.

# $parameter = "p3"
metashape-p3_p4 = The distortion parameter { $parameter } is not supported.
    .do = Calibrate without p3 and p4.

# $width_px = 6000
# $height_px = 4000
# $sensor_width_px = 3000
# $sensor_height_px = 2000
metashape-sizes_differ = The calibration has { $width_px } x { $height_px } px, its sensor { $sensor_width_px } x { $sensor_height_px } px.
    .do = Calibrate with photographs of full size, and export again.

metashape-no_similarity = This is not a similarity: the scale must be positive, the rotation orthogonal.
    .do = Export the file again.

metashape-cameras_disabled = All cameras are disabled.
    .do = Enable the cameras to be used, and export again.

metashape-no_calibrated_camera = No camera has a calibrated sensor.
    .do = Align the photographs in Metashape, then export again.

metashape-unit_length = The length of the unit is not a positive number.
    .do = Correct the coordinate system of the chunk, and export again.
