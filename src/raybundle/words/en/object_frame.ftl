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
