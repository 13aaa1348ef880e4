# $kind = "camera"
# $name = "'d5100'"
# $where = "cameras.toml"
reference-unknown = { $kind ->
        [camera] Camera
        [image] Image
        [point] Point
       *[sensor] Sensor
     } { $name } is not in { $where }.
    .do = Correct the reference, or add it to { $where }.
