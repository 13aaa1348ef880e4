photo_entry-altitude_no_fix = Die Höhe aus { $source } zählt nicht: GPSMeasureMode 2, der Empfänger hatte nur einen Lagefix.

photo_entry-altitudes_contradict = Die Höhen widersprechen sich, keine gilt: { $first }; { $second }; Abstand { $apart_m } m.
    .do = Eine berichtigen oder eine Positionsliste angeben.

photo_entry-altitudes_differ = Die Höhen unterscheiden sich, die von { $source } gilt: { $first }; { $second }; Abstand { $apart_m } m.

photo_entry-angle = Die { $longitude ->
        [yes] Länge
        *[no] Breite
    } aus { $source } zählt nicht:

photo_entry-angle_beyond = { NUM($value_deg, digits: 7) }° liegt über { NUM($limit_deg, digits: 7) }°.

photo_entry-angle_contradicts = Die { $longitude ->
        [yes] Länge
        *[no] Breite
    } aus { $source } zählt nicht: { NUM($value_deg, digits: 7) }° widerspricht der Angabe { $letter }.

photo_entry-angle_decimals = auf einen Teil mit Nachkommastellen folgt ein kleinerer ({ $values }).

photo_entry-angle_fraction = Grad oder Minuten sind x/0.

photo_entry-angle_numbers = { $n } Zahlen; nötig sind Grad, Minuten und Sekunden.

photo_entry-angle_sixty = Minuten oder Sekunden liegen nicht in 0 bis 60 ({ $values }).

photo_entry-dop = GPSDOP { $dop } liegt über { $limit }: Die Position ist eine grobe Schätzung mit dem üblichen Sigma.

photo_entry-exif_cut = EXIF: { $n } von { $of } Einträgen des Verzeichnisses { $directory } sind lesbar.

photo_entry-exif_damaged = EXIF: { $n } von { $of } Einträgen des Verzeichnisses { $directory } sind beschädigt.

photo_entry-exif_no_tiff = EXIF beginnt nicht als TIFF (II oder MM, 42) und wird nicht gelesen.

photo_entry-exif_outside = EXIF: Verzeichnis { $directory } liegt außerhalb der Daten.

photo_entry-exif_twice = EXIF: Verzeichnis { $directory } ist schon unter anderem Namen gelesen.

photo_entry-half_missing = { $source } zählt nicht: Die { $longitude ->
        [yes] Länge
        *[no] Breite
    } fehlt.

photo_entry-jpeg_taken = { $folder }: Neben { $n } { $n ->
        [one] Datei
        *[other] Dateien
    } liegt ein JPEG gleichen Namens, das gilt ({ $first }).

photo_entry-moved = Die Position aus { $source } wird um { $shift_m } m nach WGS 84 verschoben: GPSMapDatum { $map_datum } ist { $system }.

photo_entry-no_fix = Die Position 0, 0 aus { $source } zählt nicht: Der Empfänger hatte keinen Fix.

photo_entry-no_fix_status = Die Position aus { $source } zählt nicht: GPSStatus { $status }, der Empfänger hatte keinen Fix.

photo_entry-no_hemisphere = Die Position aus { $source } ohne Halbkugel zählt nicht, es fehlt { $missing }: { $position }.

photo_entry-no_place = { $source } zählt nicht, kein Ort auf der Erde: { NUM($latitude_deg, digits: 9) }; { NUM($longitude_deg, digits: 9) }.

photo_entry-no_transformation = Die Position aus { $source } zählt nicht: keine Transformation von GPSMapDatum { $map_datum } nach WGS 84.

photo_entry-orientation = Die EXIF-Orientierung { $orientation } liegt nicht in 1 bis 8; sie gilt als 1.

photo_entry-other_files = { $folder }: { $n } { $n ->
        [one] andere Datei wird
        *[other] andere Dateien werden
    } nicht gelesen ({ $suffixes }).

photo_entry-position_contradicts = Die Position aus { $source } zählt nicht, sie widerspricht den anderen: { $first }; { $second }; Abstand { $apart_m } m.

photo_entry-position_rounded = Position auf { $step_m } m gerundet: { $position }.

photo_entry-positions_contradict = Die Positionen widersprechen sich, keine gilt: { $first }; { $second }; Abstand { $apart_m } m.
    .do = Eine berichtigen oder eine Positionsliste angeben.

photo_entry-positions_differ = Die Positionen unterscheiden sich, die von { $source } gilt: { $first }; { $second }; Abstand { $apart_m } m.

photo_entry-sub_folders = { $folder }: { $n } { $n ->
        [one] Unterordner wird
        *[other] Unterordner werden
    } nicht gelesen ({ $names }).
    .do = Unterordner als eigene Eingaben angeben.

photo_entry-xmp_damaged = XMP ist ab hier beschädigt und wird nicht weiter gelesen: { $detail }.

photo_entry-xmp_long = XMP von { $bytes } Byte ist länger als { $most } und wird nicht gelesen.

photo_entry-xmp_no_number = XMP { $entry }: { $value } ist keine Zahl und zählt nicht.

photo_entry-bands = Zugeordnet wird { $colour ->
     [yes] die Luminanz aus Rot, Grün, Blau (von { $bands } Kanälen)
     *[no] Kanal { $band } von { $bands }
    } ({ $numbers }{ $scaled ->
     [yes] ; 0,1 bis 99,9 % als 0 bis 65535, wenn nicht ganzzahlig darin
     *[no] { "" }
    }).
