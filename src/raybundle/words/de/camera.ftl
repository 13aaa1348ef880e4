camera-panorama_not_supported = Kamera { $camera }: Dieses Format hat kein Modell für Rotationspanoramen.
    .do = Nur die Flächenbilder ausgeben.

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
    .do = Ihre Bilder weglassen oder ein anderes Format wählen.

camera-constant_unknown = Kamera { $camera }: Die Kamerakonstante ist unbekannt.
    .do = [cameras.{ $camera }] in { $table } dieses Ordners ergänzen.

camera-format_size = Kamera { $camera }: Ein Bildformat von { $width_px } x { $height_px } px ist nicht möglich.
    .do = Breite und Höhe berichtigen.

camera-equirectangular_size = Kamera { $camera }: Die Parameter { $parameters } weichen vom Bildformat { $width_px } x { $height_px } px ab.
    .do = Eine der Angaben berichtigen.

camera-principal_distance = Kamera { $camera }: Die Kamerakonstante ist { $fx_px }, { $fy_px } px.
    .do = Werte über 0 angeben.

camera-parameter_limits = Kamera { $camera }: { $parameter } des Modells { $model } ist { $value }, außerhalb { $least } bis { $most }.
    .do = Den Wert berichtigen.

camera-model_unknown = Kamera { $camera }: Das Kameramodell { $model } wird nicht unterstützt.
    .do = Eines von { LIST($known, most: 20) } verwenden.

camera-parameter_count = Kamera { $camera }: { $n } Parameter sind angegeben; das Modell { $model } hat { $needed }.
    .do = Die Zeile berichtigen.

camera-pixel_size_missing = Breite und Höhe eines Pixels sind nötig.
    .do = Zum Beispiel pixel_mm = [0.005, 0.005] angeben.

camera-pattern_without_photograph = Keine Aufnahme passt zum Muster { $pattern } einer Kamera.
    .do = Das Muster berichtigen; Namen sind { LIST($names, most: 3) }.

camera-two_patterns = Die Aufnahme { $photograph } passt zu zwei Kameramustern, { $first } und { $second }.
    .do = Die Muster eindeutig machen.
