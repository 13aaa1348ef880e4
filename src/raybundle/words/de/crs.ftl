crs-outside_area = { NUM($x, decimals: 2) }, { NUM($y, decimals: 2) } sind keine Koordinaten in { $system }.
    .why = { $on_earth ->
        [yes] Der Ort wäre geographische Länge { NUM($longitude_deg, decimals: 2) }, Breite { NUM($latitude_deg, decimals: 2) }; der Geltungsbereich ist Länge { $longitudes_deg }, Breite { $latitudes_deg }
       *[no] Kein Ort der Erde hat diese Koordinaten
     }.
    .do = { $hint ->
        [named] Das System der Koordinaten angeben; { OPTION("crs") } weglassen bei Metern in lokalen Achsen
        [named_exchanged] Ost- und Nordwert vertauschen oder mit { OPTION("crs") } das System der Koordinaten angeben
        [degrees] Das System der Koordinaten angeben, die wie Grad oder Meter in lokalen Achsen aussehen
        [exchanged] Ostwert oder geographische Länge zuerst schreiben oder das System korrigieren
        [feet] Meter schreiben: Als Fuß passen sie
       *[system] Das System der Koordinaten angeben
     }.

crs-beyond_circle = { NUM($x, decimals: 2) }, { NUM($y, decimals: 2) } liegt außerhalb von { $system }: Die { $quantity ->
        [latitude] geographische Breite
       *[longitude] geographische Länge
     } endet bei { $limit }.
    .do = { $swapped ->
        [yes] Prüfen, ob geographische Länge und Breite vertauscht sind
       *[no] Das ebene Koordinatensystem angeben, etwa EPSG:32633
     }.

crs-undulation_of_ellipsoid = { $system } hat bereits ellipsoidische Höhen.
    .do = { OPTION("undulation") } weglassen oder +ellipsoid im Namen des Systems.

crs-other_datum = { $own } und { $system } unterscheiden sich nicht nur in der Projektion.
    .why = Datum oder Höhen sind verschieden; die Genauigkeit einer solchen Transformation ist zu wählen.
    .do = Eine Projektion desselben Datums angeben oder das Ergebnis mit ogr2ogr -t_srs transformieren.

crs-incomplete = Das Koordinatensystem ist unvollständig.
    .do = crs = "EPSG:..." und origin = [east, north, height] angeben.

crs-geoid_missing = { $heights } braucht ein Geoid, das nicht installiert ist.
    .why = Ohne dieses wären Höhen um bis zu 100 m falsch.
    .do = { $kind ->
        [known] pyproj sync --file { $grid } ausführen oder https://cdn.proj.org/{ $grid } nach { $folder } kopieren
        [own] Den Pfad des Geoidrasters { $grid } korrigieren
       *[unknown] Die Undulation zu allen Höhen addieren ({ OPTION("undulation", "METRES") } von convert und rpc) und { $ellipsoidal } angeben
     }.

crs-coordinate_shape = Nötig sind Koordinaten der Dimension (n, 3), nicht ({ $shape }).
    .do = Ein Feld mit drei Spalten angeben: X, Y und Z.

crs-not_transformed = Punkt { $number } bei { NUM($x, decimals: 2) }, { NUM($y, decimals: 2) } liegt außerhalb von { $system }.
    .do = Koordinatensystem und Reihenfolge der Koordinaten prüfen (Ostwert oder geographische Länge zuerst).

crs-unknown = { $text } ist kein bekanntes Koordinatensystem.
    .do = EPSG:CODE, einen PROJ-Text oder WKT angeben.

crs-heights_of_proj_string = { $text } hinter einem PROJ-Text wird nicht unterstützt.
    .do = Das Lagesystem als EPSG:CODE angeben oder ellipsoidische Höhen als { $ellipsoid }.

crs-utm_zone = Die UTM-Zone { $zone } liegt nicht zwischen 1 und 60.
    .do = Die Zone korrigieren.

crs-not_on_earth = { $text } hat keine Lage auf der Erde.
    .do = Ein projiziertes, geographisches oder geozentrisches System angeben.

crs-heights_twice = { $system } legt seine Höhen bereits fest.
    .do = { $ellipsoid } weglassen.

crs-no_local_frame = { NUM($x, digits: 10) }, { NUM($y, digits: 10) } hat in { $system } kein lokales System.
    .do = Koordinaten und Koordinatensystem prüfen.

crs-origin_height_unknown = Die Höhe des Ursprungs ist unbekannt; 0 angenommen.

crs-heights_above_geoid = Höhenbezug: durch { $system } nicht festgelegt; Höhen in { $unit } über einem Geoid { $undulation_m } m über dem Ellipsoid{ $older ->
     [yes] { "" } (WGS 84)
     *[no] { "" }
    } angenommen.

crs-heights_assumed = Höhenbezug: durch { $system } nicht festgelegt; ellipsoidische Höhen in { $unit } angenommen.
    .do = { $coded ->
     [yes] Das System { $ellipsoidal } nennen, wenn das stimmt, oder mit dem Höhensystem, etwa { $sea } (EGM96)
     *[no] { $ellipsoidal } hinter das System schreiben, wenn das stimmt; zu Meereshöhen die Geoidhöhe addieren ({ OPTION("undulation") } von convert und rpc)
    }.

crs-undulation_added = { $heights }: Höhen über dem Geoid; eine konstante Undulation von { $undulation_m } m wird addiert{ $older ->
     [yes] { "" } (WGS 84)
     *[no] { "" }
    }.

crs-outside_use = { $table }: { NUM($x, digits: 10) }, { NUM($y, digits: 10) } liegt außerhalb des Anwendungsbereichs von { $system }.
    .why = Der Ort hat die geographische Länge { NUM($longitude_deg, decimals: 2) }°, Breite { NUM($latitude_deg, decimals: 2) }°.
    .do = { $exchanged ->
     [yes] Prüfen, ob Ost- und Nordwerte vertauscht sind
     *[no] Das Koordinatensystem prüfen
    }.

crs-needed_by_settings = { OPTION("frame_origin") } und { OPTION("undulation") } brauchen ein Koordinatensystem.
    .do = { OPTION("crs") } angeben.

crs-not_projected = { $system } ist kein projiziertes Koordinatensystem.
    .why = Eine Zeichnung hat nur in einem projizierten System einen Maßstab.
    .do = Ein projiziertes System wie UTM verwenden.

crs-plane_needed = { OPTION("crs", $system) } ist kein ebenes Koordinatensystem; eine Karte benötigt eines.
    .do = Ein ebenes oder geographisches System ohne Höhen angeben.
