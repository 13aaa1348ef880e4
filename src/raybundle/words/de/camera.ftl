camera-panorama_not_supported = Kamera { $camera } ist eine Panoramakamera; dieser Schritt oder dieses Format kann sie nicht verwenden.
    .why = Die Kamera wird nicht automatisch weggelassen; es gibt kein Ergebnis.
    .do = Die Bilder dieser Kamera aus dem Block entfernen, dann den Befehl erneut ausführen.

camera-no_lens = Kamera { $camera }: c = { $c_mm } mm und A = { $A } sind keine gültige innere Orientierung.
    .do = c über 0 und A nahe 0 angeben.

camera-distortion_not_invertible = { $name }: Die Verzeichnung ist nur in { PERCENT($covered) } % des Bildformats umkehrbar (nötig: { PERCENT($least) } %).
    .do = Mit weniger Koeffizienten neu kalibrieren.

camera-wider_than_projection = { $name } bildet Richtungen 89° und mehr neben der Achse ab.
    .why = Eine Zentralprojektion kann sie nicht darstellen.
    .do = Ein Fischaugenmodell verwenden oder die Bilder weglassen.

camera-opencv_deviation = Kamera { $camera }: Das Modell von OpenCV mit { $n } Koeffizienten weicht bis zu { NUM($deviation_px, digits: 2) } px ab (Grenze { $limit_px } px).
    .do = Mehr Koeffizienten verwenden oder mit dem Modell rational kalibrieren.

camera-opencv_coefficients = OpenCV hat kein { $fisheye ->
        [yes] Fischaugenmodell
       *[no] Kameramodell
     } mit { $n } Koeffizienten.
    .do = Eine der Anzahlen { LIST($known, most: 8) } verwenden.

camera-not_in_format = Kamera { $camera } ist eine { $kind ->
        [scene] Satellitenszene
       *[fisheye] Fischaugenkamera
     }; { $format } kann sie nicht darstellen.
    .do = Die Bilder dieser Kamera weglassen oder ein anderes Format wählen.

camera-constant_unknown = Kamera { $camera }: Die Kamerakonstante ist unbekannt.
    .do = [cameras.{ $camera }] in { $table } dieses Ordners ergänzen.

camera-format_size = Kamera { $camera }: Ein Bildformat von { $width_px } x { $height_px } px ist nicht möglich.
    .do = Breite und Höhe korrigieren.

camera-equirectangular_size = Kamera { $camera }: Die Parameter { $parameters } weichen vom Bildformat { $width_px } x { $height_px } px ab.
    .do = Eine der Angaben korrigieren.

camera-principal_distance = Kamera { $camera }: Die Kamerakonstante ist { $fx_px }, { $fy_px } px.
    .do = Werte über 0 angeben.

camera-parameter_limits = Kamera { $camera }: { $parameter } des Modells { $model } ist { $value }, außerhalb { $least } bis { $most }.
    .do = Den Wert korrigieren.

camera-model_unknown = Kamera { $camera }: Das Kameramodell { $model } wird nicht unterstützt.
    .do = Eines von { LIST($known, most: 20) } verwenden.

camera-parameter_count = Kamera { $camera }: { $n } Parameter sind angegeben; das Modell { $model } hat { $needed }.
    .do = Die Zeile korrigieren.

camera-pixel_size_missing = Breite und Höhe eines Pixels sind nötig.
    .do = Zum Beispiel pixel_mm = [0.005, 0.005] angeben.

camera-pattern_without_photograph = Keine Aufnahme passt zum Muster { $pattern } einer Kamera.
    .do = Das Muster korrigieren; Namen sind { LIST($names, most: 3) }.

camera-two_patterns = Die Aufnahme { $photograph } passt zu zwei Kameramustern, { $first } und { $second }.
    .do = Die Muster eindeutig machen.

camera-no_turned_copy = Das Format der Kamera { $camera } ist nicht das um { $turned_deg }° gedrehte von { $other }.
    .why = Die Formate sind { $width_px } x { $height_px } px und { $other_width_px } x { $other_height_px } px.
    .do = Für diese Aufnahmen eine eigene Kamera verwenden.

camera-scans_not_transformed = Kamera { $camera }: Die Dateien sind Scans, deren Lage von Datei zu Datei verschieden ist.
    .why = Andere Programme kennen keine affine innere Orientierung eines Bildes.
    .do = Die Scans zuerst in das Kamerasystem transformieren.

camera-turned_only_brown = Kamera { $camera }: Gedrehte Aufnahmen sind nur mit dem Modell brown möglich, nicht mit { $model }.
    .do = Die Aufnahmen so verwenden, wie der Sensor sie gespeichert hat.

camera-covariance_not_positive = Kamera { $camera }: Die Kovarianzmatrix der Kalibrierung ist nicht positiv definit.
    .do = Die Kalibrierung erneut exportieren.

camera-unknown_scene_parameter = Kamera { $camera }: Diese Szene hat keinen Parameter { $name }.
    .do = Einen von { LIST($known, most: 20) } verwenden.

camera-not_in_block = Kamera { $camera } ist nicht im Block.
    .do = { $n ->
        [0] Einen Block mit Kameras angeben
       *[other] Eine von { LIST($known, most: 9) } verwenden
     }.

camera-no_parameter = Kamera { $camera } hat keinen Parameter { $name }.
    .do = Einen von { LIST($known, most: 30) } verwenden.

camera-constant_missing = Kamera { $camera }: Die Kamerakonstante { $parameter } ist 0; das Modell { $model } braucht einen Wert.
    .do = Den Wert in block.toml eintragen.

camera-several = Das Ergebnis hat { $n } Kameras, und keine ist genannt.
    .do = Eine von { LIST($cameras, most: 10) } nennen.

camera-symbols_unknown = Kamera { $camera }: Das Modell { $model } hat keinen Parameter { LIST($names, most: 3) }.
    .do = { LIST($known, most: 30) } verwenden.

camera-unknown = Es gibt keine Kamera { $camera }.
    .do = Eine von { LIST($known, most: 10) } verwenden.

camera-interior_per_image = Kamera { $camera }: Jedes Bild hat eine eigene innere Orientierung.
    .do = Ein Bild nennen.

camera-no_interior_of_image = Kamera { $camera }: Das Bild { $image } hat keine eigene innere Orientierung.
    .do = Das Bild weglassen.

camera-no_ray = Kamera { $camera }: Mit diesen Parametern hat ein Bildpunkt keinen eindeutigen Strahl.
    .why = Ein Zeilensensor, der sich nicht bewegt (vy = 0), ist ein solcher Fall: { LIST($parameters, most: 30) }.
    .do = Näherungswerte nahe den wahren Werten angeben.

camera-parameters_of_image = Kamera { $camera }: Das Modell { $model } hat keine Parameter einzelner Bilder.
    .do = per_image entfernen oder ein anderes Modell wählen.

camera-too_many_turns = Kamera { $camera }: Das Format ({ NUM($width_mm, digits: 4) } mm) umfasst { $turns } Umdrehungen (Grenze { $limit }).
    .why = Das folgt aus c = { NUM($c_mm, digits: 4) } mm.
    .do = Für eine Umdrehung c = Breite / (2 pi) = { NUM($whole_turn_c_mm, digits: 4) } mm angeben.

camera-no_read_out_time = Kamera { $camera }: Die Auslesezeit r ist 0.
    .why = Keine Beobachtung bestimmt dann { $parameters }.
    .do = r angeben (Auslesezeit durch Formathöhe, s/mm) oder das Modell ohne Rolling Shutter verwenden.

camera-no_motion = Kamera { $camera }: Die Geschwindigkeit vy ist 0.
    .why = Alle Zeilen eines Bildes zeigen dann dieselbe Linie des Objekts.
    .do = vy angeben, die Länge am Objekt je Millimeter im Bild.

camera-no_covariance = Kamera { $camera } hat keine Kovarianzmatrix.
    .do = Die Kamera mit Genauigkeitsangaben kalibrieren.

camera-calibration_model_unknown = Das Sensormodell { $model } ist unbekannt.
    .do = Eines von { LIST($known, most: 30) } angeben.

camera-not_by_targets = Das Sensormodell { $model } lässt sich nicht aus Aufnahmen von Zielmarken kalibrieren.
    .why = Es bildet nicht alles zu einer Zeit von einem Ort ab.
    .do = Eines von { LIST($known, most: 30) } angeben oder raybundle adjust mit einem Block ausführen, der { $model } verwendet.

camera-model_not_fitted = Kamera { $camera }: Das Modell { $model } lässt sich nicht an die Näherungswerte anpassen.
    .do = Ein anderes Modell angeben.

camera-trajectory_unknown = Der Block hat keine Trajektorie { $name }.
    .do = Eine Tabelle [trajectories.ID] ergänzen, oder eine von { LIST($known, most: 20) } nennen.

camera-mount_unknown = Der Block hat keine Halterung { $name }.
    .do = Eine Tabelle [mounts.ID] ergänzen, oder eine von { LIST($known, most: 20) } nennen.

camera-trajectory_of_lines = Nur Zeilenkameras (model = "linescan") teilen eine Trajektorie; { $name } wurde von einer anderen Szene genannt.
    .do = Den Schlüssel löschen, oder eine Datei mit Bahn oder Flug einer Zeilenkamera angeben.

camera-instrument_missing = Kamera { $camera } hat Parameter von { $name }, das nicht im Block steht.
    .do = { $name } zu den Instrumenten des Blocks hinzufügen.
