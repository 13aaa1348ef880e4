mask_orientation = Die Lage von { $n } { $n ->
        [one] Maske
       *[other] Masken
    } ist mehrdeutig (EXIF-Orientierung { $orientations }): { LIST($ids, most: 3) }.
    .why = Masken gelten für die Pixel, wie gespeichert, wie bei COLMAP und Metashape; Masken über dem aufrechten Bild verdecken den falschen Teil.
    .do = Solche Masken zurückdrehen oder mit EXIF-Orientierung 1 speichern.
