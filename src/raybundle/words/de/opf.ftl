opf-file_count = Der Ordner hat { $n } .opf-Dateien; nötig ist genau eine.
    .do = Die gewünschte Datei angeben.

opf-not_calibrated = Das Projekt hat kein { $part }.
    .do = Ein kalibriertes Projekt angeben.

opf-path_outside = { $path } führt aus dem Ordner des Projekts.
    .do = Relative Pfade innerhalb des Ordners verwenden.

opf-unknown_camera = Kamera { $camera } oder ihr Sensor { $sensor } fehlt in den Listen.
    .do = Das Projekt neu exportieren.

opf-counts_differ = { $points } Punkte, { $ranges } Bereiche und { $image_points } Bildpunkte passen nicht zusammen.
    .do = Das Projekt neu exportieren.

opf-accessor_type = Der Accessor hat den Typ { $kind } aus { $type }; nötig ist ein anderer.
    .do = Das Projekt neu exportieren.

opf-accessor_size = Der Accessor kündigt { $n } Elemente an; sein Puffer hat { $size_bytes } Bytes.
    .do = Das vollständige Projekt beschaffen.

opf-ranges_overlap = Die Bereiche der Bildpunkte überlappen sich.
    .do = Das Projekt neu exportieren.

opf-not_finite = Eine Koordinate ist nicht endlich.
    .do = Das Projekt neu exportieren.
