# $degrees = true
object_frame-origin_missing = The origin of the object frame is missing.
    .do = { $degrees ->
        [yes] Give origin = [longitude_deg, latitude_deg, height_m]
       *[no] Give origin = [east, north, height]
     }.

object_frame-crs_missing = A projected frame needs its coordinate system.
    .do = Add, for example, crs = "EPSG:32633".

# $longitude_deg = 48.2
# $latitude_deg = 411.0
object_frame-not_degrees = Longitude { $longitude_deg }, latitude { $latitude_deg } are not valid degrees.
    .do = Give longitude first, then latitude.

object_frame-missing = A satellite scene needs an object frame with known location.
    .do = Add [frame] with kind = "local" and origin = [longitude_deg, latitude_deg, height_m].

object_frame-not_local = Heights above a map need a block in a local frame (east, north, up).
    .do = Give the block a [frame] with kind = "local".

# $block = "bridge"
# $unit = "mm"
object_frame-needs_metres = Block { $block } has a [frame] with a coordinate system, but lengths in { $unit }.
    .do = Give the block in metres: length_unit = "m".

# $block = "bridge"
# $system = "EPSG:25832"
# $x_m = 12.4
# $y_m = 8.1
# $origin_x_m = 534700.0
# $origin_y_m = 5338160.0
object_frame-far_from_origin = Block { $block }: coordinates near { NUM($x_m, digits: 6) }, { NUM($y_m, digits: 6) } m do not fit [frame] kind = "projected".
    .why = Such coordinates are those of { $system } itself, with the origin at { NUM($origin_x_m, digits: 10) }, { NUM($origin_y_m, digits: 10) } m.
    .do = If they are metres east, north and up from the origin, write kind = "local" with the same crs and origin.

# $block = "bridge"
# $tables = "attitudes"
object_frame-needs_local = Block { $block }: { $tables } need a local frame; the block is in map coordinates.
    .why = Their axes differ from place to place of a map.
    .do = Give the block with [frame] kind = "local", the same crs, and coordinates counted from the origin.
