board-view_too_few_points = Ansicht { $view } der Kalibriertafel zeigt { $n } Punkte; nötig sind { $least }.
    .do = Die Ansicht weglassen.

board-no_lens = Kein Objektivmodell passt zu den Ansichten der Kalibriertafel: Die beste Näherung hat Verbesserungen von { $residual_px } px.
    .do = Zeilen und Spalten der Ecken prüfen, und ob alle Ansichten dieselbe Kalibriertafel zeigen.

board-charuco_name = { $name } ist kein Name einer ChArUco-Kalibriertafel.
    .do = Die Kalibriertafel nach Feldern und Marken benennen, z. B. charuco-8x6-5x5_100; -0.8 anhängen, wenn Marken nicht 0,75 eines Feldes sind.

board-charuco_size = { $name } ist als ChArUco-Kalibriertafel nicht möglich.
    .do = Mindestens 3 x 3 Felder verwenden und Marken von 0,3 bis 0,95 eines Feldes.

board-charuco_tags = { $name } braucht { $n } Marken; { $tags } hat { $most }.
    .do = Ein größeres Verzeichnis oder weniger Felder verwenden.

board-chessboard_name = { $name } ist kein Name eines Schachbretts.
    .do = Es nach den inneren Ecken benennen, z. B. chessboard-9x6.

board-chessboard_size = { $name }: Ein Schachbrett braucht mindestens 3 x 3 innere Ecken.
    .do = Eine Kalibriertafel mit mehr Feldern verwenden.

board-dots_name = { $name } ist kein Name eines Punktrasters.
    .do = Es nach den Punktzahlen benennen, z. B. circles-7x5 oder acircles-4x11.

board-dots_size = { $name }: Ein Raster braucht mindestens 3 x 3 Punkte.
    .do = Ein Raster mit mehr Punkten verwenden.

board-not_alone = Eine Kalibriertafel ({ $board }) lässt sich in einer Kalibrierung nicht mit anderen Zielmarken verbinden.
    .do = { OPTION("target") } mit einer Kalibriertafel oder nur mit einzelnen Zielmarken angeben.
