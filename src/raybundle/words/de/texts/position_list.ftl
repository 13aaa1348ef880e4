position_list-clock = Die Zeiten sind { $clock }, nicht GPS-Zeit, und zählen nicht.

position_list-correlations = Korrelationen der Positionen in { $name } zählen nicht, Standardabweichungen schon.
    .do = Damit sie zählen, die Positionen als stations.csv eines Bildverbands angeben.

position_list-disabled = { $n } von { $of } Positionen sind in der Liste abgeschaltet und zählen nicht.

position_list-ellipsoid = Die Höhen gelten als Höhen über dem Ellipsoid von WGS 84.

position_list-estimated = Die Liste enthält nur geschätzte Koordinaten: Sie sind keine Beobachtungen eines Empfängers.

position_list-exposures_without = { $n } von { $of } Belichtungen haben keine Position.

position_list-heights_open = Die Datei gibt die Bezugsfläche ihrer Höhen nicht an.

position_list-no_fix = { $n } von { $of } Positionen sind 0, 0 und zählen nicht: Der Empfänger hatte keinen Fix.

position_list-not_fixed = { $n } von { $of } Positionen haben keine feste Lösung.

position_list-of_antenna = Die Positionen gelten für die Antenne, in der Reihenfolge der Namen der Aufnahmen; ellipsoidische Höhen.

position_list-of_camera = Die Positionen gelten für die Kamera, von der Antenne reduziert; Höhen über dem Ellipsoid.

position_list-order_of_pix4d = Keine Spaltennamen: Breite, Länge, Höhe, die Reihenfolge von Pix4D; erster Ort { NUM($latitude_deg, digits: 6) } { $south ->
        [yes] S
        *[no] N
    }; { NUM($longitude_deg, digits: 6) } { $west ->
        [yes] W
        *[no] O
    }.

position_list-sigma_columns = Die Spalten der Standardabweichungen haben andere Namen und zählen nicht.

position_list-unnamed = Keine Spaltennamen: gelesen als { $order ->
        [xyz] X, Y, Z
        [latitude_longitude] Breite, Länge, Höhe
        *[longitude_latitude] Länge, Breite, Höhe
    }.

position_list-used = { $n } von { $of } Aufnahmen erhalten ihre Position aus { $name }.

position_list-orientations = Die äußeren Orientierungen sind als { $reading } gelesen{ $by_size ->
     [yes] , die Einheit nach der Größe der Winkel
     *[no] { "" }
    }.

position_list-orientations_open = Die äußeren Orientierungen können { LIST($readings) } sein (Spalten: { $columns }); die Aufnahmen entscheiden.
