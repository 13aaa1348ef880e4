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
