two_cameras = Kamera { $camera }: { $n } und { $others } Aufnahmen haben verschiedene innere Orientierungen.
    .why = c weicht um { NUM($dc_px, decimals: 1) } px ab, der Bildhauptpunkt um { NUM($dx0_px, decimals: 1) }, { NUM($dy0_px, decimals: 1) } px; { $by ->
        [names] Aufnahmen, deren Name nicht mit { $name } beginnt,
        [order] Aufnahmen nach { $name }
       *[values] die der zweiten Gruppe
    } wurden Kamera { $other }.
    .do = Sind es zwei Kameras oder wurden Zoom oder Fokus geändert, das angeben: { OPTION("own_camera", "PATTERN") }.
