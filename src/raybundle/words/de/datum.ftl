datum-unknown_points = { $n } { $n ->
        [one] Datumspunkt geht
       *[other] Datumspunkte gehen
     } nicht in die Ausgleichung ein: { LIST($points, most: 5) }.
    .do = Gemessene Datumspunkte wählen.

datum-points_in_line = Die Objektpunkte liegen an einem Ort oder auf einer Geraden und legen das Datum nicht fest.
    .do = Punkte neben dieser Geraden messen.

datum-fixed = Die Beobachtungen legen das Datum dieses Blocks fest; ein anderes ist nicht wählbar.
    .do = Die Standardabweichungen des Ergebnisses verwenden oder den Block ohne Passpunkte und Maßstab ausgleichen.

datum-part = { $part ->
        [position_x] Lage in X
        [position_y] Lage in Y
        [position_z] Lage in Z
        [rotation_x] Drehung um X
        [rotation_y] Drehung um Y
        [rotation_z] Drehung um Z
        [scale] Maßstab
        [about_line] Drehung um eine Gerade
       *[several] mehrere Datumsparameter
     }

datum-combination = { $n } { $n ->
        [one] Kombination
       *[other] Kombinationen
     } von { LIST($among, most: 7) } (t Verschiebung, r Drehung, m Maßstabsfaktor)

datum-too_few_points = { $points } Datumspunkte reichen für { $constraints } innere Bedingungen nicht aus.
    .do = Mindestens drei Punkte wählen, die nicht auf einer Geraden liegen.

datum-no_scale = Keine Beobachtung bestimmt den Maßstab.
    .why = Standardabweichungen in { $unit } haben ohne ihn keine Bedeutung.
    .do = Eine Maßstabsstrecke, Passpunkte oder beobachtete Projektionszentren angeben oder diese Beobachtungen entfernen.

datum-not_by_control = Nicht durch Passpunkte bestimmt: { datum-part }.
    .why = { $free } von 7 Datumsparametern { $free ->
        [one] ist
       *[other] sind
     } frei.
    .do = Mehr Passpunkte, eine Maßstabsstrecke oder beobachtete Projektionszentren angeben oder { OPTION("datum", "auto") } verwenden.

datum-misalignment_unknown = Nicht bestimmt: { datum-part }; die Einbauwinkel der IMU sind unbekannt.
    .why = Die Flugrichtungen der Bilder sind zu ähnlich, um sie von einer Drehung des Blocks zu trennen.
    .do = Passpunkte oder beobachtete Projektionszentren angeben, bz festhalten oder den Einbauwinkeln ein Sigma geben.

datum-antennas_unknown = Nicht bestimmt: { datum-part }; die Versätze der GNSS-Antennen sind unbekannt.
    .why = Verschiebungen, Driften oder Hebelarme der Projektionszentren sind für jeden Flugstreifen frei.
    .do = Passpunkte angeben, die Verschiebung einer Antenne festhalten oder den Verschiebungen ein Sigma geben.

datum-directions_unknown = Nicht bestimmt: { datum-part }; die Orientierungen der Richtungssätze sind unbekannt.
    .why = Keine andere Beobachtung bestimmt die Drehung um die Lotrichtung.
    .do = Zwei Lagepasspunkte angeben.
