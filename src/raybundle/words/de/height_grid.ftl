height_grid-too_small = Das Höhenraster hat { $rows } Zeilen und { $columns } Spalten.
    .do = Ein Raster mit mindestens zwei Zeilen und zwei Spalten angeben.

height_grid-no_cell_area = Die Zellen des Höhenrasters haben keine Fläche: Schritte { $across } und { $down } m.
    .do = Die Zellgröße in der Georeferenzierung des Rasters korrigieren.

height_grid-empty = Das Höhenraster enthält keine Höhe: Alle Zellen sind leer.
    .do = Ein Raster mit Höhen angeben.

height_grid-no_four_cells = Höhenraster { $name }: Keine vier benachbarten Zellen haben Höhen.
    .why = Es lässt sich keine Fläche interpolieren.
    .do = Ein Raster mit weniger leeren Zellen angeben.

height_grid-void_cells = { $n } von { $total } Zellen haben keine Höhe.
    .do = Diese Zellen weglassen oder füllen.

height_grid-no_common_cell = Keine Zelle hat hier und in { $other } eine Höhe.
    .do = Höhenraster desselben Gebiets angeben.

height_grid-identical = Alle Höhen sind gleich denen von { $other }.
    .why = Es ist dieselbe Messung.
    .do = Ein anderes Höhenraster angeben.

height_grid-file = Dies ist eine Datei. Verlangt ist eine Oberfläche: der Ordner von raybundle surface.
    .why = Standardabweichungen und Korrelationen einer Oberfläche stehen in ihrem Ordner.
    .do = { $model ->
        [yes] Sie mit einer Oberfläche vergleichen: raybundle heights difference, oder heights volume mit { OPTION("above", "FILE") }.
        *[no] Den Ordner angeben.
    }
