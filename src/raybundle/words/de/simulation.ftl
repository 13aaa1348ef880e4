simulation-too_few_points = Simulation: Nur { $n } Punkte haben { $rays } Strahlen.
    .why = Nötig sind Punkte für { $control } Passpunkte, { $check } Kontrollpunkte und { $bars } Maßstabsstrecken (je zwei).
    .do = Punkte oder Standpunkte ergänzen oder die Standpunkte näher legen.

simulation-point_not_visible = Block { $block }: Aufnahme { $image } kann Punkt { $point } von ihrem Standpunkt aus nicht zeigen.
    .why = Das betrifft { $n } von { $total } Bildpunkten.
    .do = Den Block zuerst ausgleichen.

simulation-has_scenes = Block { $block } hat Satellitenszenen; nur Aufnahmen lassen sich simulieren.
    .do = Einen Block ohne Szenen verwenden.

simulation-point_unknown = Block { $block }: Punkt { $point } hat keine Koordinaten.
    .do = Den Block zuerst ausgleichen.

simulation-control_without_sigma = Block { $block }: Passpunkt { $point } hat keine Standardabweichung.
    .do = sX, sY und sZ ergänzen.

simulation-control_layout = Für { $n } Passpunkte gibt es keine Anordnung.
    .do = Eines von { LIST($known, most: 20) } angeben: { OPTION("control_points") }.

simulation-too_few_photographs = { $n } von { $total } Aufnahmen des Flugs zeigen { $least } Verknüpfungspunkte; nötig sind zwei Aufnahmen.
    .why = Eine Aufnahme bedeckt { $across_m } m; Verknüpfungspunkte liegen { $spacing_m } m auseinander auf { $width_m } x { $length_m } m, Aufnahmen { $base_m } m, Streifen { $lines_m } m.
    .do = { OPTION("height") }, { OPTION("base") }, { OPTION("line_spacing") }, { OPTION("ground") }, { OPTION("tie_points") } oder { OPTION("jitter") } anpassen.

simulation-unknown_scene = { $name } ist weder eine Szene noch der Ordner einer Planung oder eines Blocks.
    .do = Eine von { LIST($known, most: 20) } oder einen solchen Ordner angeben.

simulation-setting_of_scenes = { OPTION($setting) } gehört zu Szenen; { $folder } hat eigene Passpunkte und Maßstabsstrecken.
    .do = Es weglassen oder damit planen.
