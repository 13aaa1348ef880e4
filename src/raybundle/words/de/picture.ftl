picture-no_scale = Der Maßstab des Bildes ist unbekannt: { $plane } und { $world } fehlen daneben.
    .do = Die Aufnahme zuerst entzerren oder eine dieser Dateien ergänzen.

picture-other_system = Das Bild ist in { $picture }, der Block in { $block }.
    .do = Den Block transformieren: { OPTION("crs", "EPSG:25832") }.

picture-earlier_adjustment = Das Bild gehört zu einer früheren Ausgleichung: Die Aufnahme { $photograph } hat sich um { $offset } { $unit } verschoben.
    .why = Punkte dieser Ausgleichung passen nicht zum Bild (Pixel { $pixel } { $unit }).
    .do = Neu entzerren.

picture-suffix = Der Name des Bildes endet nicht auf { LIST($known, most: 8) }.
    .do = Einen Namen mit einer dieser Endungen angeben.

picture-not_geotiff = Das Bild lässt sich nicht als GeoTIFF schreiben ({ $detail }).
    .do = Ein Raster angeben, das GDAL liest, oder NAME_RPC.TXT, NAME.RPB oder NAME.geom schreiben.
