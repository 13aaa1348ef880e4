figure-wrong_type = figure ist vom Typ { $type }, nicht Figure oder SubFigure.
    .why = Jede Abbildung hat mehrere Achsen.
    .do = Eine Figure oder SubFigure von matplotlib angeben.

figure-no_image_points = Kein Bildpunkt ging in die Ausgleichung ein; es gibt nichts zu zeichnen.
    .do = Eine andere Abbildung wählen oder einen Block mit Bildpunkten ausgleichen.

figure-camera_without_points = Kamera { $camera } hat keine Bildpunkte in der Ausgleichung.
    .do = Eine von { LIST($known, most: 20) } angeben.

figure-no_control = Es gibt keine Passpunkte mit Standardabweichung und keine Kontrollpunkte; es gibt nichts zu zeichnen.
    .do = Passpunkte mit Standardabweichung oder Kontrollpunkte angeben und neu ausgleichen.

figure-no_distortion = { $name } hat weder Verzeichnung noch Standardabweichungen; es gibt nichts zu zeichnen.
    .do = Eine andere Kamera wählen oder mit freien Verzeichnungsparametern ausgleichen.

figure-no_camera = Keine Kamera der Ausgleichung hat eine Verzeichnung, die sich zeichnen lässt.
    .why = Szenen und Instrumente haben keine; Parameter einzelner Bilder haben keine gemeinsame Abbildung.
    .do = Eine andere Abbildung wählen.

figure-none_of_camera = Es gibt keine Abbildungen der inneren Orientierung { $name }.
    .do = Eine von { LIST($known, most: 20) } angeben.

figure-no_network = Kein Objektpunkt mit Strahlen hat Koordinaten; es gibt kein Netz zu zeichnen.
    .do = Punkte in mindestens zwei Aufnahmen messen und neu ausgleichen.

figure-no_redundancy_numbers = Die Ausgleichung hat keine Redundanzanteile.
    .why = Die Ausgleichung wurde ohne Statistik berechnet.
    .do = Mit AdjustmentOptions(statistics=True) ausgleichen.

figure-no_adjustment = Das Argument ist vom Typ { $type }, nicht Adjustment.
    .do = Das Ergebnis von adjust angeben oder das Attribut .adjustment des Ergebnisses von orient, calibrate oder measure.
