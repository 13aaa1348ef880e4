drawing-no_source = Es gibt nichts zu zeichnen.
    .do = Ein maßstäbliches Bild, einen Ergebnisordner oder ein Projekt angeben.

drawing-planes_differ = Das Bild liegt in einer anderen Ebene oder einem anderen Koordinatensystem als { $other }.
    .do = Bilder einer Ebene auf ein Blatt zeichnen.

drawing-no_extent = Es gibt keine Punkte oder Linien zu zeichnen.
    .do = { OPTION("extent", "LEFT", "BOTTOM", "RIGHT", "TOP") } angeben.

drawing-no_area = Die Zeichenfläche ist { $width } x { $height }; beide Werte müssen über 0 liegen.
    .do = { OPTION("extent") } korrigieren.

drawing-several_results = Punkte und Linien eines Ergebnisses lassen sich zeichnen; dies ist das zweite.
    .do = Ein Ergebnis angeben.

drawing-plane_of_picture = { OPTION($setting) } legt die Ebene eines Ergebnisses fest; ein Bild hat seine eigene Ebene.
    .do = Es weglassen oder das Bild damit entzerren.

drawing-grid_too_dense = Linien des Gitters { $grid } lägen auf dem Papier { NUM($apart_mm, digits: 2) } mm auseinander (mindestens { $least_mm } mm).
    .do = { OPTION("grid", $needed) } verwenden.

drawing-does_not_fit = Das Objekt mit { $width_m } x { $height_m } m passt { $scale ->
    [0] in keinem Maßstab
   *[other] im Maßstab 1:{ $scale } nicht
} auf { $paper }{ $sheets ->
    [0] .
   *[other] {" "}mit { $sheets } Blättern.
}
    .do = Eine dieser Möglichkeiten wählen:

drawing-fitting_scale = Ein kleinerer Maßstab passt: { OPTION("scale", $scale) }.

drawing-fitting_paper = Ein größeres Papierformat passt: { OPTION("paper", $paper) }.

drawing-joined_sheets = Mehrere Blätter, die aneinandergelegt werden: { OPTION("several", "True") }.

drawing-title_block = Weniger Text im Schriftfeld.
