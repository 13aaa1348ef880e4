not_oriented-not_connected = Das Bild hat keine Verbindung zu den anderen Bildern.
    .do = Punkte messen, die dieses Bild mit zwei anderen Bildern gemeinsam hat.

not_oriented-no_second_image = Das Bild hat { $n } bekannte { $n ->
        [one] Punkt
        *[other] Punkte
    }, und kein zweites Bild hat genügend gemeinsame Punkte.
    .do = Mehr Punkte messen, die dieses Bild mit anderen Bildern gemeinsam hat.

not_oriented-few_common = Das Bild hat { $n } { $n ->
        [one] gemeinsamen Punkt
        *[other] gemeinsame Punkte
    } mit den anderen; { $least } sind nötig.
    .do = Mehr gemeinsame Punkte messen oder Aufnahmen mit mehr Überdeckung hinzufügen.

not_oriented-no_pose = Das Bild hat { $n } gemeinsame Punkte mit den anderen, aber keine Orientierung passt zu { PERCENT($share) } % davon.
    .do = Punktnamen, Kamera und Bildachsen dieses Bildes prüfen.

not_oriented-contradicting_part = Die Punkte dieses Bildes und { $n } weiterer, zusammen orientierter widersprechen den anderen Bildern.
    .do = Punktnamen und Kameras dieser Bilder prüfen.

not_oriented-axes = { $n } Punkte des Bildes passen, wenn { $axes ->
        [mirrored] y nach oben oder x nach links zählt
        [exchanged] x und y vertauscht sind
        [middle] der Ursprung die Bildmitte ist
        *[middle_mirrored] der Ursprung die Bildmitte ist und y nach oben zählt
    }.
    .do = Die Bildpunkte korrigieren: Pixel zählen von der linken oberen Ecke, x nach rechts und y nach unten.

not_oriented-no_base = Bilder { $first } und { $second }: Strahlen zu gemeinsamen Punkten sind auf { NUM($angle_deg, decimals: 2) }° parallel, ohne Basis.
    .why = Vielleicht ist es zweimal dieselbe Aufnahme; aus Aufnahmen vom selben Standpunkt lässt sich keine Tiefe bestimmen.
    .do = Eine von zwei Kopien löschen oder von einem anderen Standpunkt aufnehmen.

not_oriented-other_cameras = Das Bild hat keine gemeinsamen Punkte mit den anderen Kameras; zu wenige Standpunkte oder Drehungen verbinden sie.
    .do = Mehr Standpunkte mit allen Kameras aufnehmen oder gemeinsame Punkte der Kameras messen.

not_oriented-station = Der Standpunkt des Bildes hat { $n } { $n ->
        [one] Bildpunkt
        *[other] Bildpunkte
    } in { $images } { $images ->
        [one] Bild
        *[other] Bildern
    }.
    .do = Mehr Punkte in den Bildern dieses Standpunkts messen.

not_oriented-contradicting_orientations = Relative Orientierungen der Aufnahme widersprechen denen der anderen Aufnahmen.
    .do = Prüfen, ob die Aufnahme sich wiederholende Strukturen oder ein bewegtes Objekt zeigt.

not_oriented-contradicting_points = Punkte der Aufnahme widersprechen denen der anderen Aufnahmen.
    .do = Prüfen, ob die Aufnahme sich wiederholende Strukturen oder ein bewegtes Objekt zeigt.

not_oriented-no_distance = Weniger als { $least } Punkte der Aufnahme sind in zwei anderen; die Entfernung der Aufnahme ist nicht bestimmt.
    .do = Mit 60 % Überdeckung oder mehr aufnehmen.

not_oriented-separate_part = Der Teil dieser Aufnahme (insgesamt { $n }) hat keine Verbindung zum größten Teil ({ $largest } Aufnahmen).
    .do = Aufnahmen zwischen den beiden Teilen hinzufügen.

not_oriented-wide_baseline = { $n } Punkte der Aufnahme sind aus { NUM($angle_deg, decimals: 0) }° verschiedenen Richtungen gesehen (Median; Grenze { NUM($limit_deg, decimals: 0) }°).
    .why = Solche Zuordnungen sind falsch.
    .do = Aufnahmen dazwischen hinzufügen.

not_oriented-few_fit = Nur { $n } { $n ->
        [one] Punkt der Aufnahme passt
        *[other] Punkte der Aufnahme passen
    } zu den anderen Aufnahmen.
    .do = Aufnahmen mit mehr Überdeckung hinzufügen.

not_oriented-same_picture = Die Aufnahme zeigt dasselbe Bild wie { $other }.
    .do = Eine Aufnahme, die keine Kopie ist, von einem anderen Standpunkt wiederholen.

not_oriented-mirrored = Die Aufnahme ist gegenüber den anderen gespiegelt.
    .do = In einem Bildprogramm links und rechts vertauschen oder das Dia von der anderen Seite scannen.

not_oriented-alone = Eine einzelne Aufnahme lässt sich nicht orientieren; nötig sind zwei.
    .do = Aufnahmen desselben Objekts von anderen Standpunkten hinzufügen.

not_oriented-not_joined = Die Szene hat keine Verbindung zu den Aufnahmen.
    .do = Drei Punkte in der Szene und in zwei Aufnahmen markieren oder Passpunkte für die Aufnahmen angeben.

not_oriented-board = Die Aufnahme zeigt { $n } { $n ->
        [one] Punkt
        *[other] Punkte
    } der Kalibriertafel; { $least } sind nötig.
    .do = Die ganze Kalibriertafel scharf und gleichmäßig beleuchtet aufnehmen.

not_oriented-few_targets = { $n } { $n ->
        [one] Zielmarke
        *[other] Zielmarken
    } mit Namen in der Aufnahme erkannt; { $least } sind nötig.
    .do = Mehr Zielmarken scharf und groß genug aufnehmen.

not_oriented-contradicting_share = { $n } von { $points } Punkten der Aufnahme widersprechen den anderen Aufnahmen.
    .do = Prüfen, ob die Aufnahme gespiegelt, beschnitten oder von einer anderen Kamera ist oder ob Zoom oder Objekt bewegt wurden.
