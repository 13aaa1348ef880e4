# $names = ["'Ost'", "'Nord'"]
image_list-unknown_columns = These column names do not determine the coordinates: { $names }.
    .do = Use imagename or label; latitude and longitude, or X and Y; altitude, height or Z.

# $unit = "'ft'"
# $quantity = "length"
image_list-unit = The unit { $unit } is not supported.
    .do = { $quantity ->
        [height] Give metres above the ellipsoid, or a system of heights (# CoordinateSystem: EPSG:4326+5773)
        [angle] Give degrees
       *[length] Give metres
     }.

# $first = [48.2, 16.4]
image_list-order_unclear = Without column names, the order of the coordinates { $first } is ambiguous.
    .do = Add a first line of names, such as imagename,latitude,longitude,altitude.
