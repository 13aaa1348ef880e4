format-unknown = Das Format { $format } ist unbekannt.
    .do = Eines von { LIST($known, most: 40) } verwenden.

format-only_written = Das Format { $format } wird geschrieben, aber nicht gelesen.
    .do = Eines von { LIST($known, most: 40) } verwenden.

format-only_read = Das Format { $format } wird gelesen, aber nicht geschrieben.
    .do = Ein anderes Format wählen.

format-needs_crs = Das Format { $format } braucht das Koordinatensystem des Blocks.
    .do = { OPTION("crs", "EPSG:25832") } angeben, bei einem lokalen System auch { OPTION("frame_origin", "E", "N", "H") }.

format-free_scale = Das Format { $format } hat Koordinaten in Metern, aber der Maßstab des Blocks ist nicht bestimmt.
    .do = Mit Maßstabsstrecke, zwei Passpunkten oder beobachteten Positionen ausgleichen oder { OPTION("free_scale", "True") } angeben.

format-camera_deviation = Eine Kamera dieses Formats weicht bis zu { $deviation_px } px vom Original ab (Grenze { $limit_px } px).
    .do = { $undistort ->
        [yes] Die Aufnahmen entzerren ({ OPTION("photos", "FOLDER") } { OPTION("undistort", "inside") }), ein anderes Format wählen
       *[no] Ein anderes Format wählen
     } oder die Abweichung mit { OPTION("approximate", "True") } zulassen.

format-needs_folder = { $format } ist ein Ordner mit den Dateien { $files }.
    .do = Den Ordner angeben.

format-degrees = { $format } hat Koordinaten als Längen; { $system } ist in Grad.
    .do = Ein projiziertes System desselben Datums angeben, etwa { OPTION("crs", "EPSG:32632") }.

format-not_in_plane = { OPTION("within", flag: "in") } gehört zu Zeichnungen; das Format { $format } ist keine.
    .do = Es weglassen oder eines von { LIST($known, most: 20) } verwenden.

format-no_tables = { OPTION("tables") } gehört zu Blockordnern; das Format { $format } ist keiner.
    .do = Es weglassen.

format-csv = Es gibt kein Format csv.
    .why = Ein Blockordner (Format block) und ein Ergebnisordner bestehen aus CSV-Tabellen: images.csv, points.csv, observations.csv.
    .do = Die gewünschte Tabelle kopieren.

format-file_suffix = Das Format { $format } ist eine Datei mit der Endung { $suffix }.
    .do = Einen Namen mit der Endung { $suffix } angeben.

format-no_scenes = Das Format { $format } kennt keine Satellitenszenen; der Block hat { $scenes }.
    .do = { $whole } für die Szenen oder eines von { LIST($points, most: 20) } für die Punkte wählen.

format-ambiguous = Die Datei passt zu mehreren Formaten: { $names }.
    .do = Eines davon angeben: { OPTION("read_as", flag: "from") }.

format-not_recognised = Das Format ist nicht erkannt.
    .do = { OPTION("read_as", flag: "from") } angeben, eines von { LIST($known, most: 60) }.
