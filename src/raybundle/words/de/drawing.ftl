drawing-no_source = Es gibt nichts zu zeichnen.
    .do = Ein maßstäbliches Bild, einen Ergebnisordner oder ein Projekt angeben.

drawing-planes_differ = Das Bild liegt in einer anderen Ebene oder einem anderen Koordinatensystem als { $other }.
    .do = Bilder einer Ebene auf ein Blatt zeichnen.

drawing-no_extent = Es gibt keine Punkte oder Linien zu zeichnen.
    .do = { OPTION("extent", "LEFT", "BOTTOM", "RIGHT", "TOP") } angeben.

drawing-no_area = Die Zeichenfläche ist { $width } x { $height }; beide Werte müssen über 0 liegen.
    .do = { OPTION("extent") } berichtigen.
