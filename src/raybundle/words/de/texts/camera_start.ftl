camera_start-calibration_differs = Gespeicherte Kalibrierung: c = { $c_px } px, sie gilt. Die Aufnahmen: { $own_px } px nach:

camera_start-copy = EXIF: { $exif_width } x { $exif_height } px, Datei: { $width } x { $height } px; gilt als Kopie, { NUM($ratio, digits: 4) }-fach verkleinert.
    .why = Ein Ausschnitt gleicher Form sieht in EXIF gleich aus; seine Kamerakonstante wäre in Pixeln das { NUM($ratio, digits: 4) }-fache.

camera_start-cropped = EXIF: { $exif_width } x { $exif_height } px, Datei: { $width } x { $height } px: beschnitten.
    .why = Der Bildhauptpunkt kann weit von der Mitte liegen.

camera_start-default = Vorgabe: das 1,2-fache der längeren Seite

camera_start-dewarp_data = DewarpData { $value } in XMP ist kein Datum mit { $n } Zahlen; der Eintrag zählt nicht.

camera_start-digital_zoom = Digitalzoom { NUM($zoom, digits: 6) }: Die Kamerakonstante in Pixeln wächst mit ihm.

camera_start-equivalent = Kleinbildäquivalent

camera_start-equivalent_impossible = Kein Objektiv hat das Kleinbildäquivalent { NUM($equivalent_mm, digits: 6) } mm aus EXIF; es zählt nicht.
    .why = Objektive haben { NUM($least_mm, digits: 6) } bis { NUM($most_mm, digits: 6) } mm.

camera_start-equivalent_taken = Sensorbreite: Auflösung der Bildebene in EXIF { NUM($plane_mm, decimals: 2) } mm, Kleinbildäquivalent { NUM($equivalent_mm, decimals: 2) } mm; das Kleinbildäquivalent gilt.

camera_start-focal_plane = Auflösung der Bildebene

camera_start-focal_plane_impossible = Nach der Auflösung der Bildebene in EXIF wäre der Sensor { $plane_mm } mm breit; sie zählt nicht.

camera_start-focused = Fokussiert auf { NUM($distance_m, digits: 6) } m: c kann bis zu { PERCENT($share) } % länger sein als die Brennweite.

camera_start-no_constant = { $entry } { $value } in XMP ist keine Kamerakonstante dieses Bildes; der Eintrag zählt nicht.

camera_start-no_metadata = Keine Metadaten, anders als bei den übrigen Aufnahmen: vielleicht aus anderer Quelle.

camera_start-no_number = { $entry } in XMP beginnt mit { $value }, keiner Zahl; der Eintrag zählt nicht.

camera_start-no_sensor_size = Ohne Sensorgröße ergibt die Brennweite { NUM($focal_mm, digits: 6) } mm keine Kamerakonstante.

camera_start-not_square = Die Auflösungen der Bildebene in EXIF unterscheiden sich um { PERCENT($share) } %; Pixel gelten als quadratisch.

camera_start-one_camera = { $stated ->
        [yes] Nur in
        *[no] Nicht in
    } { $n ->
        [one] { $first }
        *[other] { $n } Aufnahmen ({ $first } ...)
    }: { $has_serial ->
        [yes] Seriennummer { $serial }
        *[no] {""}
    }{ $has_lens ->
        [yes] { $has_serial ->
            [yes] ,{" "}
            *[no] {""}
        }Objektiv { $lens }
        *[no] {""}
    }; eine Kamera mit { $others } anderen.
    .why = Alles andere in den Metadaten stimmt überein.

camera_start-panorama = XMP: Panorama { $kind }, keine Zentralprojektion; eine gespeicherte Kalibrierung eines anderen Modells angeben.

camera_start-stored = gespeicherte Kalibrierung { $camera }

camera_start-table = Tabelle der Sensorgrößen

camera_start-table_doubtful = Sensorbreite: Kleinbildäquivalent { NUM($equivalent_mm, decimals: 2) } mm, Tabelle { NUM($table_mm, decimals: 2) } mm; die Tabelle gilt mit größerem Sigma.
    .why = Die Kamera hat das Bild beschnitten, oder eines von beiden ist falsch.

camera_start-table_outvoted = Sensorbreite: Tabelle { NUM($table_mm, decimals: 2) } mm, Auflösung der Bildebene und Kleinbildäquivalent in EXIF { NUM($taken_mm, decimals: 2) } mm; EXIF gilt.

camera_start-table_taken = Sensorbreite: Auflösung der Bildebene in EXIF { NUM($plane_mm, decimals: 2) } mm, Tabelle { NUM($table_mm, decimals: 2) } mm; die Tabelle gilt.

camera_start-xmp = Kalibrierung in XMP

camera_start-xmp_contradicts = XMP gibt { $c_px } px, zu erwarten sind { $expected_px } px; XMP zählt nicht.

camera_start-zoom_lens = Zoomobjektiv, { NUM($low_mm, digits: 6) } bis { NUM($high_mm, digits: 6) } mm: Aufnahmen mit { NUM($focal_mm, digits: 6) } mm können leicht verschiedene Brennweiten haben.

camera_start-cameras = { $n ->
        [one] Kamera
        *[other] Kameras
    } { LIST($cameras, most: 20) }: { $photographs } { $photographs ->
        [one] Aufnahme
        *[other] Aufnahmen
    }
