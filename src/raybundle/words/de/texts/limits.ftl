limits-precision = Präzision ist nicht Genauigkeit.

limits-independent_errors = Standardabweichungen beschreiben unabhängige zufällige Fehler der Bildpunkte.
    .why = Gemeinsame Fehler vieler Punkte (Verzeichnung, exzentrische Zielmarken, Refraktion, instabile Kamera) sind nicht enthalten.

limits-common_errors = Standardabweichungen enthalten glatte Fehler, die sich von Bild zu Bild unterscheiden.
    .why = Gemeinsame Fehler aller Bilder (Verzeichnung, exzentrische Zielmarken, Refraktion) sind nicht enthalten.

limits-small_sigma0 = Ein kleines σ₀ beweist keine richtigen Koordinaten.

limits-hidden_blunders = Eine Verbesserung zeigt nur den Anteil r (Redundanzanteil) eines Fehlers.
    .why = Grobe Fehler unterhalb der kleinsten aufdeckbaren bleiben im Ergebnis.

limits-weakest_control = Schwächste geprüfte Passpunktkoordinate: { $component } von { $point }. Jeder fünfte Fehler von { NUM($mdb, digits: 2) } { $unit } bleibt unentdeckt.

limits-no_comparison = Es gab keine unabhängige Kontrolle.

limits-own_accuracy = Ohne Kontrollpunkte oder unabhängige Längen ist nur die Präzision des Netzes bekannt.

limits-datum = Die Standardabweichungen gelten für dieses Datum.

limits-datum_scaled = Sie beschreiben die Form, nicht deren Lage in einem anderen System.
    .why = Strecken und Winkel hängen nicht vom Datum ab.

limits-datum_unscaled = Sie beschreiben die Form, nicht deren Lage in einem anderen System und nicht deren Größe.
    .why = Winkel und Streckenverhältnisse hängen nicht vom Datum ab, Strecken schon.

limits-no_scale = Längen sind nicht absolut.

limits-scale_chosen = Der Maßstab wurde gewählt, nicht gemessen.
    .do = Eine Maßstabsstrecke oder zwei Passpunkte angeben.

limits-nominal_scale = Der Maßstab wurde angegeben, nicht gemessen.

limits-nominal_length = Ein Fehler der angegebenen Länge der Zielmarke verändert alle Längen; keine Standardabweichung enthält ihn.

limits-held_control = Festgehaltene Passpunkte gelten als fehlerfrei.

limits-control_sigma = Die Standardabweichungen enthalten ihre Unsicherheit nicht.
    .do = Passpunkte mit ihrer Standardabweichung angeben.

limits-held_interior = Die innere Orientierung gilt als fehlerfrei.

limits-interior_errors = Ihre Fehler gehen unerkannt in die Objektkoordinaten ein.

limits-rejection = Nach Verwerfungen wirken die übrigen Beobachtungen besser.

limits-sigma0_after_rejection = σ₀ nach dem Data-Snooping ist aus den behaltenen Beobachtungen geschätzt.
