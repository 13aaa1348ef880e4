raster-height_unit_missing = Die Einheit der Höhen ist unbekannt; die Koordinaten sind in { $unit }.
    .do = Die Einheit in die Datei schreiben, zum Beispiel mit gdal_edit.py -units m.

raster-dem_unit_missing = Die Einheit der Höhen ist unbekannt; die Koordinaten sind in { $unit }.
    .do = { OPTION("dem_unit", "m") }, { OPTION("dem_unit", "ft") } oder { OPTION("dem_unit", "us-ft") } angeben.

raster-ellipsoidal_heights = Die Höhen sind bereits ellipsoidisch ({ $system }).
    .do = { OPTION("undulation") } weglassen.

raster-geoid_and_undulation = Geoid und Undulation schließen einander aus.
    .do = { OPTION("geoid") } oder { OPTION("undulation") } angeben.

raster-geoid_unknown = { $geoid } ist kein bekanntes Höhensystem.
    .do = EPSG:5773 (EGM96), EPSG:3855 (EGM2008) oder das des Landes angeben.

raster-geoid_differs = Die Höhen der Datei sind { $own }, nicht { $geoid }.
    .do = { OPTION("geoid") } weglassen oder die Datei korrigieren.

raster-degrees = Das Raster ist in Grad ({ $system }); nötig ist ein ebenes System.
    .do = { OPTION("crs", "EPSG:CODE") } angeben.

raster-no_system = Das Raster hat kein Koordinatensystem.
    .do = Es in die Datei schreiben, zum Beispiel mit gdal_edit.py -a_srs EPSG:CODE.

raster-band_missing = Das Raster hat keinen Kanal { $band }; vorhanden: { $n }.
    .do = Einen vorhandenen Kanal wählen.

raster-unit_unknown = Die Einheit { $unit } der Höhen ist unbekannt.
    .do = m, ft oder us-ft in die Datei schreiben.

raster-unit_differs = Die Höhen der Datei sind in { $own }, nicht in { $unit }.
    .do = { OPTION("dem_unit") } oder die Datei korrigieren.

raster-too_many_cells = Das Gebiet hat { $n } Zellen; höchstens { $most } werden gelesen.
    .do = Das Raster verkleinern, zum Beispiel mit gdalwarp -tr 5 5.

raster-no_overlap = Das Raster deckt das Gebiet nicht ab.
    .why = Es deckt { $covered } seines eigenen Systems ab; nötig ist { $wanted } (West, Süd, Ost, Nord).
    .do = Prüfen, ob es das richtige Raster ist.

raster-no_height = Das Raster hat im Gebiet keine Höhe: Alle Zellen dort sind leer.
    .do = Ein anderes Raster angeben.

raster-impossible_heights = Eine Höhe von { $height_m } m kommt auf der Erde nicht vor (Höhen { $lowest_m } bis { $highest_m } m).
    .do = Wenn sie leere Zellen bezeichnet, gdal_edit.py -a_nodata VALUE ausführen.

raster-not_readable = Das Raster ist nicht lesbar ({ $detail }).
    .do = Prüfen, ob die Datei vollständig ist und ein unterstütztes Format hat.

raster-transformed = { $name } ist in { $system ->
        [degrees] Grad
        *[other] { $system }
    }; seine Höhen sind nach { $target } transformiert, Zellen von { $cell_m } m.

raster-feet = { $name }: Höhen in Fuß sind in Meter umgerechnet.

raster-unit_assumed = { $name } nennt keine Einheit der Höhen; Meter werden angenommen.
