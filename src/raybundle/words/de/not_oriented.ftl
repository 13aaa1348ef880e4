not_oriented-not_connected = Es hat keine Verbindung zu den anderen Bildern.

not_oriented-no_second_image = { $n } bekannte { $n ->
        [one] Punkt
       *[other] Punkte
    } und kein zweites Bild mit genügend gemeinsamen Punkten.

not_oriented-few_common = { $n } gemeinsame { $n ->
        [one] Punkt
       *[other] Punkte
    } mit den anderen; { $least } sind nötig.

not_oriented-no_pose = { $n } gemeinsame Punkte mit den anderen, aber keine Orientierung passt zu { PERCENT($share) } % davon.

not_oriented-contradicting_part = Mit { $n } anderen orientiert, aber ihre Punkte widersprechen denen der anderen Bilder.

not_oriented-axes = { $n } davon passen, wenn { $axes ->
        [mirrored] y nach oben oder x nach links zählt
        [exchanged] x und y vertauscht sind
        [middle] der Ursprung die Bildmitte ist
       *[middle_mirrored] der Ursprung die Bildmitte ist und y nach oben zählt
    }.
    .do = Die Bildpunkte berichtigen: Pixel zählen von der linken oberen Ecke, x nach rechts und y nach unten.

not_oriented-no_base = Bilder { $first } und { $second }: Strahlen zu gemeinsamen Punkten sind auf { NUM($angle_deg, decimals: 2) }° parallel, ohne Basis.
    .why = Vielleicht ist es zweimal dieselbe Aufnahme.

not_oriented-other_cameras = Es hat keine gemeinsamen Punkte mit den anderen Kameras, und zu wenige Standpunkte oder Drehungen verbinden sie.

not_oriented-station = Sein Standpunkt hat { $n } { $n ->
        [one] Bildpunkt
       *[other] Bildpunkte
    } in { $images } { $images ->
        [one] Bild
       *[other] Bildern
    }.

not_oriented-contradicting_orientations = Ihre relativen Orientierungen widersprechen denen der anderen Aufnahmen.

not_oriented-contradicting_points = Ihre Punkte widersprechen denen der anderen Aufnahmen.

not_oriented-no_distance = Weniger als { $least } ihrer Punkte sind in zwei anderen Aufnahmen; ihre Entfernung ist nicht bestimmt.
    .do = Mit 60 % Überdeckung oder mehr aufnehmen.

not_oriented-separate_part = Sie hat keine Verbindung zum größten Teil ({ $largest } Aufnahmen); ihr eigener Teil hat { $n }.

not_oriented-wide_baseline = Ihre { $n } Punkte sind aus { NUM($angle_deg, decimals: 0) }° verschiedenen Richtungen gesehen (Median; Grenze { NUM($limit_deg, decimals: 0) }°).
    .why = Solche Zuordnungen sind falsch.
    .do = Aufnahmen dazwischen hinzufügen.

not_oriented-few_fit = Nur { $n } ihrer Punkte { $n ->
        [one] passt
       *[other] passen
    } zu den anderen.

not_oriented-same_picture = Sie zeigt dasselbe Bild wie { $other }.

not_oriented-alone = Eine einzelne Aufnahme lässt sich nicht orientieren; nötig sind zwei.

not_oriented-not_joined = Sie hat keine Verbindung zu den Aufnahmen.
    .do = Drei Punkte in ihr und in zwei Aufnahmen markieren oder Passpunkte für die Aufnahmen angeben.

not_oriented-board = Sie zeigt { $n } { $n ->
        [one] Punkt
       *[other] Punkte
    } der Tafel; { $least } sind nötig.

not_oriented-few_targets = { $n } { $n ->
        [one] Zielmarke
       *[other] Zielmarken
    } mit Namen erkannt; { $least } sind nötig.

not_oriented-contradicting_share = { $n } ihrer { $points } Punkte widersprechen den anderen Aufnahmen.
    .do = Prüfen, ob sie gespiegelt, beschnitten oder von einer anderen Kamera ist oder ob Zoom oder Objekt bewegt wurden.
