isd-map_projected = Das Bild liegt in einer Kartenprojektion vor; seine Zeilen sind nicht die der Abtastung.
    .do = Das Bild angeben, wie es aufgenommen wurde, mit einer Beschreibung ohne projection.

isd-line_times = Die Tabelle der Zeilenzeiten ist nicht monoton.
    .do = Die Tabelle korrigieren: Zeilen müssen ansteigen, Zeiten je Zeile ein Vorzeichen haben und ungleich 0 sein.

isd-line_times_contradict = Zeile { NUM($line_number, digits: 6) } beginnt { NUM($off_lines, decimals: 1) } Zeilenzeiten neben den vorangehenden Zeilen.
    .why = Diese Zeile beginnt bei { NUM($time_s, digits: 6) } s, die davor bei { NUM($before_s, digits: 6) } s mit { NUM($step_s, digits: 6) } s je Zeile.
    .do = Die Beschreibung mit einer aktuellen Version von ALE neu schreiben.

isd-focal_plane = Die Transformation von der Bildebene in Pixel hat keine Umkehrung.
    .do = focal2pixel_lines und focal2pixel_samples korrigieren.

isd-coefficient_count = Koeffizienten der Verzeichnung: { $n }; höchstens { $most } sind möglich.
    .do = Die überzähligen Koeffizienten löschen.

isd-distortion_folds = Die Verzeichnung ({ $coefficients }) faltet die Bildebene { $radius_mm } mm neben der Achse.
    .why = Der Detektor reicht bis { $detector_mm } mm, was die Koeffizienten mit { $factor } multiplizieren; sie haben andere Einheiten oder gehören zu einer anderen Kamera.
    .do = Eine Beschreibung mit den richtigen Koeffizienten beschaffen.

isd-distortion_folds_detector = Der Koeffizient { $coefficient } faltet einen Detektor, der { $detector_mm } mm von seiner Mitte reicht.
    .do = Eine Beschreibung mit dem richtigen Koeffizienten beschaffen.

isd-distortion_no_inverse = Die Verzeichnung{ $n ->
     [0] { "" }
     *[other] { " " }({ $coefficients })
    } hat über dem Detektor keine Umkehrung.
    .do = Eine Beschreibung mit den Koeffizienten dieses Detektors beschaffen.

isd-position_inside_body = Eine Position liegt { NUM($distance_m, digits: 6) } m vom Mittelpunkt eines Körpers mit Radius { NUM($radius_m, digits: 6) } m.
    .do = Die Einheiten der Positionen und Radien korrigieren.

isd-time_count = Die Tabelle hat { $n } Zeiten für { $entries } Einträge.
    .do = Eine vollständige Datei beschaffen.

isd-time_order = Eintrag { $entry }: Die Zeit { NUM($time_s, digits: 6) } s folgt auf { NUM($before_s, digits: 6) } s.
    .do = Die Einträge nach der Zeit ordnen und wiederholte Zeiten löschen.

isd-quaternion_zero = { $n ->
     [0] Es gibt keine Quaternionen.
     *[other] Ein Quaternion hat die Länge 0.
    }
    .do = Eine vollständige Datei beschaffen.

isd-velocity_count = Die Tabelle hat { $n } Geschwindigkeiten für { $positions } Positionen.
    .do = Eine vollständige Datei beschaffen.

isd-no_model = Dieses JSON ist keine Beschreibung des Community Sensor Model: name_model fehlt.
    .why = { $n ->
     [0] Es hat keine Schlüssel.
     *[other] Seine Schlüssel sind { LIST($names, most: 6) }.
    }
    .do = Die Beschreibung angeben, die ALE für das Bild schreibt (isd_generate).

isd-model_unknown = { $model } ist kein Sensormodell, das gelesen wird.
    .why = Gelesen werden Zeilenscanner, Push-Frame-Kameras, Flächenkameras und Radare (..._LINE_SCANNER_, _PUSH_FRAME_, _FRAME_ und _SAR_SENSOR_MODEL).
    .do = Eine Szene eines davon oder ein RPC dieser Szene angeben.

isd-no_aberration = Weder Aberration noch Refraktion werden angebracht, wie in USGSCSM.

isd-kilometres_assumed = Die Einheit der Positionen ist nicht angegeben; Kilometer werden angenommen, wie ALE sie schreibt.
    .why = Der Sensor ist { NUM($distance_km, digits: 6) } km vom Mittelpunkt eines Körpers mit Radius { NUM($radius_km, digits: 6) } km entfernt.

isd-detector_turned = Die dritte Achse des Detektors zeigt vom Körper weg; sie wird umgekehrt, wie in USGSCSM.

isd-scan_reverses = Die Abtastung kehrt bei Zeile { LIST($lines, most: 6) } um; das Gelände dort erscheint zweimal.
    .why = Ein Geländepunkt dort hat zwei Bildpunkte; berechnet wird der, der dem Anfang der Abbildung näher ist.

isd-distortion_unknown = Die optische Verzeichnung { $name } wird nicht unterstützt.
    .why = { $incomplete ->
     [yes] ISIS korrigiert sie mit weiteren Koeffizienten, die die Beschreibung nicht enthält.
     *[no] Unterstützt werden { LIST($known, most: 12) }.
    }
    .do = Stattdessen ein RPC der Szene verwenden.

isd-attitude_gap = Die Lagewinkel haben { $n } { $n ->
     [one] Lücke
     *[other] Lücken
    }, die größte von { NUM($steps, decimals: 1) } Schritten von { NUM($from_s, decimals: 3) } bis { NUM($to_s, decimals: 3) } s.
    .why = { $measured ->
     [yes] In einer solchen Zeit weichen die Lagewinkel um { NUM($error_px, decimals: 2) } px (quadratisches Mittel) von der Interpolation ab (Grenze { $limit_px } px).
     *[no] Die Tabelle ist zu kurz, um den Fehler der Interpolation zu schätzen.
    }
    .do = Eine vollständige Tabelle beschaffen.

isd-attitude_gap_bridged = { $n } { $n ->
     [one] Lücke
     *[other] Lücken
    } der Lagewinkel interpoliert, die größte von { NUM($steps, decimals: 1) } Schritten von { NUM($from_s, decimals: 3) } bis { NUM($to_s, decimals: 3) } s.
    .why = In einer solchen Zeit weichen die Lagewinkel um { NUM($error_px, decimals: 3) } px (quadratisches Mittel) von der Interpolation ab.

isd-framelets = Teilbilder von { NUM($height, digits: 4) } Zeilen alle { NUM($delay_s, digits: 4) } s, davon { NUM($overlap, digits: 3) } überlappend, füllen kein Bild von { $lines } Zeilen.
    .do = framelet_height, interframe_delay oder num_lines_overlap (eine gerade Zahl) korrigieren.
