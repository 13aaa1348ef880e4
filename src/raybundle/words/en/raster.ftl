# $unit = "US survey foot"
raster-height_unit_missing = The unit of the heights is unknown; the coordinates are in { $unit }.
    .do = Write it into the file, for example with gdal_edit.py -units m.

# $unit = "US survey foot"
raster-dem_unit_missing = The unit of the heights is unknown; the coordinates are in { $unit }.
    .do = Give { OPTION("dem_unit", "m") }, { OPTION("dem_unit", "ft") } or { OPTION("dem_unit", "us-ft") }.

# $system = "WGS 84"
raster-ellipsoidal_heights = The heights are already ellipsoidal ({ $system }).
    .do = Omit { OPTION("undulation") }.

raster-geoid_and_undulation = A geoid and an undulation exclude each other.
    .do = Give { OPTION("geoid") } or { OPTION("undulation") }.

# $geoid = "EPSG:1"
raster-geoid_unknown = { $geoid } is not a known vertical system.
    .do = Give EPSG:5773 (EGM96), EPSG:3855 (EGM2008) or that of the country.

# $own = "DHHN2016 height"
# $geoid = "EGM96 height"
raster-geoid_differs = The heights of the file are { $own }, not { $geoid }.
    .do = Omit { OPTION("geoid") }, or correct the file.

# $system = "WGS 84"
raster-degrees = The raster is in degrees ({ $system }); a plane system is needed.
    .do = Give { OPTION("crs", "EPSG:CODE") }.

raster-no_system = The raster has no coordinate system.
    .do = Write it into the file, for example with gdal_edit.py -a_srs EPSG:CODE.

# $n = 1
# $band = 3
raster-band_missing = The raster has no band { $band }; it has { $n }.
    .do = Choose an existing band.

# $unit = "'fathom'"
raster-unit_unknown = The unit { $unit } of the heights is unknown.
    .do = Write m, ft or us-ft into the file.

# $own = "ft"
# $unit = "m"
raster-unit_differs = The heights of the file are in { $own }, not in { $unit }.
    .do = Correct { OPTION("dem_unit") }, or the file.

# $n = 2000000000
# $most = 100000000
raster-too_many_cells = The area has { $n } cells; at most { $most } are read.
    .do = Reduce the raster, for example with gdalwarp -tr 5 5.

# $covered = [0.0, 0.0, 1000.0, 1000.0]
# $wanted = [5000.0, 5000.0, 6000.0, 6000.0]
raster-no_overlap = The raster does not cover the area.
    .why = It covers { $covered } of its own system; needed is { $wanted } (west, south, east, north).
    .do = Check that it is the right raster.

raster-no_height = The raster has no height in the area: all its cells there are void.
    .do = Give another raster.

# $lowest_m = -9999.0
# $highest_m = 412.0
# $height_m = -9999.0
raster-impossible_heights = A height of { $height_m } m does not occur on earth (heights { $lowest_m } to { $highest_m } m).
    .do = If it marks void cells, run gdal_edit.py -a_nodata VALUE.

# $detail = "not recognized as a supported format"
raster-not_readable = The raster cannot be read ({ $detail }).
    .do = Check that the file is complete and of a supported format.

# $name = "dsm.tif"
# $system = "degrees"
# $target = "EPSG:32632"
# $cell_m = 83.1
raster-transformed = { $name } is in { $system ->
        [degrees] degrees
        *[other] { $system }
    }; its heights are transformed to { $target }, cells of { $cell_m } m.

# $name = "dsm.tif"
raster-feet = { $name }: heights in feet are converted to metres.

# $name = "dsm.tif"
raster-unit_assumed = { $name } does not define the unit of its heights; metres are assumed.
