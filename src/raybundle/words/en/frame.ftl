# $frame = 3
# $rig = 2
frame-unknown_rig = Frame { $frame } refers to rig { $rig }, which is missing.
    .do = Correct the number, or add the rig.

# $frame = 3
# $sensor = 5
# $rig = 2
frame-unknown_sensor = Frame { $frame } refers to sensor { $sensor }, which rig { $rig } does not have.
    .do = Correct the number, or add the sensor.
