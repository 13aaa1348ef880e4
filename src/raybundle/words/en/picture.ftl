# $plane = "facade.toml"
# $world = "facade.jgw"
picture-no_scale = The scale of the picture is unknown: { $plane } and { $world } are missing beside it.
    .do = Rectify the photograph first, or add one of these files.

# $picture = "EPSG:25832"
# $block = "EPSG:25833"
picture-other_system = The picture is in { $picture }, the block in { $block }.
    .do = Transform the block: { OPTION("crs", "EPSG:25832") }.

# $photograph = "img_07"
# $offset = 0.12
# $pixel = 0.005
# $unit = "m"
picture-earlier_adjustment = The picture belongs to an earlier adjustment: photograph { $photograph } has moved by { $offset } { $unit }.
    .why = Points of this adjustment do not fit the picture (pixel { $pixel } { $unit }).
    .do = Rectify again.

# $known = [".jpg", ".tif"]
picture-suffix = The name of the picture has another ending than { LIST($known, most: 8) }.
    .do = Give a name with one of these endings.

# $detail = "Permission denied"
picture-not_geotiff = The picture cannot be written as GeoTIFF ({ $detail }).
    .do = Give a raster that GDAL reads, or write NAME_RPC.TXT, NAME.RPB or NAME.geom.
