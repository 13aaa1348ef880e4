sheet-unknown_paper = Das Papierformat { $name } ist unbekannt.
    .do = Eines von { LIST($known, most: 20) } verwenden.

sheet-dot_radius_not_positive = Der Radius der Punkte ist { $radius_mm } mm.
    .do = Einen Radius über 0 angeben: { OPTION("dot_radius") }.

sheet-target_too_large = Eine Zielmarke mit einem Punkt von { $radius_mm } mm Radius ({ $side_mm } mm) passt nicht auf { $paper }.
    .why = Das Papierformat hat { $width_mm } x { $height_mm } mm.
    .do = Einen Radius von höchstens { NUM($most_mm, decimals: 1) } mm ({ OPTION("dot_radius") }) oder ein größeres Papierformat verwenden.

sheet-spacing_not_positive = Der Abstand der Kalibriertafel ist { $spacing_mm } mm.
    .do = Einen Abstand über 0 angeben: { OPTION("spacing") }.

sheet-board_too_large = { $board } mit { $spacing_mm } mm braucht { $width_mm } x { $height_mm } mm; { $paper } hat { $room_width_mm } x { $room_height_mm } mm.
    .do = Einen Abstand von höchstens { NUM($most_mm, decimals: 1) } mm, ein größeres Papierformat oder { OPTION("lying", "True") } verwenden.

sheet-side_not_positive = Die Seite einer Marke ist { $side_mm } mm.
    .do = Eine Seite über 0 angeben.

sheet-no_such_tag = { $family } hat keine Marke { $tag }.
    .do = Nummern von 0 bis { $last } verwenden.

sheet-tag_too_large = Eine Marke von { $side_mm } mm mit ihrem hellen Rand passt nicht auf { $paper }.
    .do = Eine kleinere Seite oder ein größeres Papierformat verwenden.

sheet-dots_too_large = Punkte mit { $radius_mm } mm Radius sind zu groß für einen Abstand von { $spacing_mm } mm.
    .why = Die Punkte brauchen einen Zwischenraum.
    .do = Einen Radius von höchstens { NUM($most_mm, decimals: 1) } mm verwenden: { OPTION("dot_radius") }.

sheet-too_many_dots = { $paper } hat Platz für { $most } Punkte im Abstand von { $spacing_mm } mm; verlangt sind { $n }.
    .do = Einen kleineren Abstand oder ein größeres Papierformat verwenden.

sheet-boards_are_dark = Kalibriertafeln und quadratische Marken lassen sich nur dunkel auf hell drucken.
    .do = { OPTION("polarity", "light") } weglassen.

sheet-not_printable = { $family } lässt sich nicht drucken.
    .do = Eine Kalibriertafel, Marken oder Ringe verwenden.

sheet-file_type = Ein Blatt lässt sich im Format dieses Namens nicht schreiben (Endung „{ $ending }“).
    .do = .pdf oder .svg verwenden.

sheet-print_factor = Der Druck ist das { NUM($factor, decimals: 3) }-fache des Entwurfs (Grenzen 0,95 und 1,05).
    .do = Die Maßstabsstrecke des Blattes nochmals messen.

sheet-no_sidecar = Das ist nicht die Datei eines Zielmarkenblattes: family oder [[pages]] fehlt.
    .do = Die .toml-Datei angeben, die mit dem Blatt geschrieben wurde.

sheet-target_twice = Die Zielmarke { $name } kommt zweimal vor.
    .do = Einen der beiden Einträge löschen.

sheet-ring_radii = Ringe von { $radii } mm sind mit einem Punkt von { $radius_mm } mm Radius nicht möglich.
    .do = ring_radii_mm oder dot_radius_mm korrigieren.

sheet-name_no_number = Die Zielmarke { $name } einer eigenen Codetabelle hat einen Namen, der keine Zahl ist.
    .do = Die Zielmarke in ihre Nummer umbenennen.

sheet-same_ring = Zwei Zielmarken haben denselben Ring.
    .do = Den Code einer der beiden korrigieren.

sheet-place_out_of_range = { $value_mm } mm ist keine Position auf einem Blatt.
    .do = Einen Wert zwischen -{ $most_mm } und { $most_mm } mm angeben.

sheet-length_out_of_range = { $value_mm } mm ist keine Länge auf einem Blatt.
    .do = Einen Wert von 0 bis { $most_mm } mm angeben.

sheet-spacing_missing = { $family }: Die Seite eines Quadrats oder der Abstand der Punkte fehlt.
    .do = { OPTION("spacing", "25mm") } angeben.

sheet-dots_without_numbers = Punkte haben keine Nummern, die { OPTION("codes") } wählen könnte.
    .do = { OPTION("count") } angeben, oder nichts für so viele, wie Platz haben.

sheet-board_without_numbers = { $family } ist eine Kalibriertafel; ihre Punkte haben keine Nummern zur Auswahl.
    .do = { OPTION("codes") } und { OPTION("count") } weglassen.

sheet-other_targets = Die Aufnahmen zeigen Zielmarken, die nicht auf dem Blatt sind: { LIST($names, most: 10) }.
    .do = Die Datei des aufgenommenen Blatts angeben oder nur die Markenfamilie: { OPTION("target") }.
