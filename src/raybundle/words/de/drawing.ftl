drawing-no_source = Es gibt nichts zu zeichnen.
    .do = Ein maßstäbliches Bild, einen Ergebnisordner oder ein Projekt angeben.

drawing-planes_differ = Das Bild liegt in einer anderen Ebene oder einem anderen Koordinatensystem als { $other }.
    .do = Bilder einer Ebene auf ein Blatt zeichnen.

drawing-no_extent = Es gibt keine Punkte oder Linien zu zeichnen.
    .do = { OPTION("extent", "LEFT", "BOTTOM", "RIGHT", "TOP") } angeben.

drawing-no_area = Die Zeichenfläche ist { $width } x { $height }; beide Werte müssen über 0 liegen.
    .do = { OPTION("extent") } berichtigen.

drawing-several_results = Punkte und Linien eines Ergebnisses lassen sich zeichnen; dies ist das zweite.
    .do = Ein Ergebnis angeben.

drawing-plane_of_picture = { OPTION($setting) } legt die Ebene eines Ergebnisses fest; ein Bild hat seine eigene Ebene.
    .do = Es weglassen oder das Bild damit entzerren.
