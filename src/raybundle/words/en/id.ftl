# $kind = "image"
# $number = 3
# $n = 10
id-empty = { $kind ->
        [camera] Camera
        [image] Image
        [point] Point
        [position] Position
       *[instrument] Instrument
     } { $number } of { $n } has an empty id; nothing is written.
    .do = Give it an id.

# $kind = "image"
# $first = 3
# $second = 7
# $id = "img_07"
id-twice = { $kind ->
        [camera] Cameras
        [image] Images
        [point] Points
        [position] Positions
       *[instrument] Instruments
     } { $first } and { $second } have the same id { $id }; nothing is written.
    .do = Give each its own id.
