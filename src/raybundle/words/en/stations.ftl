stations-no_crs = Stations on a map need the coordinate system of the block.
    .do = Give { OPTION("crs", "EPSG:25832") }.
