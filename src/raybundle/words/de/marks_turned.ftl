marks_turned = { $marks } { $marks ->
     [one] Messung aus { $table } stammt aus gedreht angezeigten Aufnahmen und ist
     *[other] Messungen aus { $table } stammen aus gedreht angezeigten Aufnahmen und sind
    } zurückgedreht.
    .why = { $photographs } { $photographs ->
     [one] Aufnahme hat
     *[other] Aufnahmen haben
    } die EXIF-Orientierung { LIST($orientations, most: 8) }.{ $outside ->
     [yes] { "" } Wie gespeichert liegen die Messungen außerhalb des Formats.
     *[no] { "" }
    }{ $compared ->
     [yes] { "" } Wie gespeichert weichen sie um { $before_px } px ab, zurückgedreht um { $after_px } px (Median).
     *[no] { "" }
    }
    .do = In den Pixeln messen, wie sie gespeichert sind, mit einem Programm, das die EXIF-Orientierung nicht anwendet.

marks_turned-undecided = { $marks } { $marks ->
     [one] Messung aus { $table } stammt
     *[other] Messungen aus { $table } stammen
    } vielleicht aus gedreht angezeigten Aufnahmen; unverändert.
    .why = { $photographs } { $photographs ->
     [one] Aufnahme hat
     *[other] Aufnahmen haben
    } die EXIF-Orientierung { LIST($orientations, most: 8) }.{ $compared ->
     [yes] { "" } Wie gespeichert weichen sie um { $before_px } px ab, zurückgedreht um { $after_px } px (Median, Grenze { $limit_px } px).
     *[no] { "" }
    } Innerhalb der Grenze liegen { $before_near } und { $after_near }.
    .do = In den Pixeln messen, wie sie gespeichert sind, oder mehr Punkte in drei Aufnahmen oder mehr messen.
