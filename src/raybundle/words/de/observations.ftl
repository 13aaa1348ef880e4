observations-covariance_not_positive = Beobachtungen ({ observations-kind }): Die Kovarianzmatrix ist nicht positiv definit.
    .do = Diese Kovarianzen korrigieren.

observations-none_of_kind = Der Block { $block } hat keine Beobachtungen der Art { $kind }.
    .do = Die Tabelle dieser Art ergänzen: block.having(table).

observations-without_partials = Die Beobachtungen der Art { $kind } haben zu keiner Unbekannten eine Ableitung.
    .do = Die Ableitungen der Art angeben.

observations-kind = { $kind ->
        [image_observations] Bildpunkte
        [camera] Bildpunkte
        [control] Passpunktkoordinaten
        [distances] Maßstabsstrecken
        [stations] Projektionszentren
        [attitudes] Drehwinkel
        [planes] Punkte auf Ebenen
        [straight_lines] Punkte auf Geraden
        [plumb_lines] Punkte auf Lotlinien
        [levels] Punkte gleicher Höhe
        [coordinates_of_networks] Koordinaten von Netzen
        [deviations_of_single_images] Abweichungen einzelner Bilder
        [parameters] beobachtete Parameter
        [relations] Beziehungen zwischen Parametern
        [directions] Horizontalrichtungen
        [zenith_angles] Zenitwinkel
        [slope_distances] Schrägstrecken
       *[other] { $kind }
     }

observations-astray = Bildbeobachtungen hinter der Kamera: { $behind }; von Punkten, die ins Unendliche laufen: { $diverging }.
    .why = Diese Beobachtungen stehen in den Zeilen { LIST($rows, most: 5) } der Beobachtungen.
    .do = Die Punktnummern prüfen oder diese Beobachtungen weglassen.
