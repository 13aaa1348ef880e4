epochs-datum_points_missing = Datumspunkte sind nicht in allen Epochen gemessen: { $names }.
    .do = Datumspunkte wählen, die alle Epochen haben.

epochs-only_one = Ein Kongruenztest braucht mindestens zwei Epochen.
    .do = Zwei oder mehr Messungen angeben.

epochs-too_few_common = { $epochs }: { $n } Punkte haben gemeinsame Namen; nötig sind { $least }.
    .why = Drei Punkte bestimmen das Datum, ein weiterer lässt sich prüfen.
    .do = In allen Epochen dieselben Punktnamen verwenden.

epochs-no_sigmas = { $first } und { $second } haben keine Standardabweichungen.
    .why = Ohne sie lässt sich keine Verschiebung prüfen.
    .do = Ergebnisse mit Kovarianzen angeben.

epochs-covariance_singular = Die gemeinsame Kovarianzmatrix der Epochen ist über das Datum hinaus singulär.
    .why = Fehlerfrei festgehaltene Punkte lassen sich nicht prüfen.
    .do = Die Epochen als freie Netze ausgleichen.

epochs-mirrored = Die Punkte von { $first } und { $second } sind Spiegelbilder: Gespiegelt passen sie auf { NUM($rms_mm, digits: 2) } mm (rms).
    .do = Die Achsen beider Epochen prüfen und ob Bilder gespiegelt wurden.

epochs-scattered = Die Punkte von { $first } und { $second } passen nicht: Nur { $agree } von { $n } stimmen überein.
    .why = Die Namen gehören zu anderen Objekten oder sind vertauscht.
    .do = Die Punktnamen beider Epochen prüfen.

epochs-other_unit = Strecken in { $first } sind { NUM($factor, digits: 6) }-mal so lang wie in { $second }.
    .why = Die Längeneinheit einer Epoche ist falsch (vermutlich { $units }).
    .do = Die Längeneinheit oder die Maßstabsstrecke korrigieren.

epochs-points_in_line = Die { $n } gemeinsamen Punkte liegen in { $epoch } auf einer Geraden oder sind ein Punkt.
    .why = Ein Datum braucht drei Punkte, die nicht auf einer Geraden liegen ({ $names }).
    .do = Gemeinsame Punkte neben dieser Geraden messen.

epochs-same_observations = { $first } und { $second } sind dieselbe Messung (Differenzen { NUM($apart_mm, digits: 2) } mm, Sigma { NUM($sigma_mm, digits: 2) } mm).
    .why = Eine Messung, mit sich selbst verglichen, zeigt keine Verschiebung.
    .do = Das Ergebnis einer anderen Epoche angeben.

epochs-faulty = { $name } hat selbst { $n } { $n ->
        [one] Fehler
        *[other] Fehler
    }.
    .why = Verschiebungen dagegen sind nicht verlässlich.
    .do = Zuerst die Fehler von { $name } beheben.

epochs-stable_points_differ = Stabile Punkte weichen um mehr als ihre Standardabweichungen ab ({ P($p) }).
    .why = Die Standardabweichungen sind zu klein, oder viele Punkte haben sich wenig verschoben.
    .do = Die stabilen Punkte mit { OPTION("datum_points", "A", "B", "C") } angeben.

epochs-stable_ambiguous = Zwei Mengen stabiler Punkte passen gleich gut: { $stable } und { $other } von { $points } Punkten.
    .why = Fast die Hälfte hat sich gleich verschoben. Was als verschoben berichtet ist, kann stabil sein.
    .do = Die stabilen Punkte mit { OPTION("datum_points", "A", "B", "C") } angeben.

epochs-free_scale = Der Maßstab von { $names } ist nicht festgelegt: eine gleichmäßige Dehnung bleibt unentdeckt ({ $scale_ppm } ppm).
    .why = Passpunkte sind in diesem Test frei; Längen sind die der ersten Epoche.
    .do = In jeder Epoche eine Maßstabsstrecke messen.

epochs-points_unknown = Keine Messung hat { LIST($points, most: 10) }.
    .do = { OPTION("points") } korrigieren.

epochs-joint_order = Die gemeinsame Kovarianz von { $epochs } verlangt dieselben Punkte in derselben Reihenfolge.
    .do = Alle Epochen mit denselben Punkten angeben.

epochs-group_empty = Kein Punkt der Gruppe { $name } hat an jedem Tag eine Lage.
    .do = { OPTION("group") } korrigieren.

epochs-group_without = Gruppe { $name } ist ohne { LIST($names, most: 5) } geprüft.
    .why = Kein Punkt dieses Namens hat an jedem Tag eine Lage.
    .do = { OPTION("group") } korrigieren.

epochs-group_text = { $text } ist keine Gruppe.
    .do = { OPTION("group", "NAME:A,B,C") } oder { OPTION("group", "NAME:outline.csv") } angeben.

epochs-dates_not_joined = { $date } hat { $common } Punkte mit anderen Tagen gemeinsam, alle Tage { $n } (nötig sind { $least }).
    .why = Der Tag hat { $photographs } { $photographs ->
        [one] Foto
        *[other] Fotos
    }; zwei müssen einen Punkt zeigen.
    .do = An jedem Tag dieselbe Stelle von ähnlichen Seiten aufnehmen, oder { $date } aus [epochs] in project.toml löschen.

epochs-one_date = Verschiebungen verlangen Bilder von mindestens zwei Tagen; vorhanden ist { LIST($dates, most: 1) }.
    .do = Fotos eines weiteren Tages hinzufügen.

epochs-no_date_text = { $text } ist kein Datum.
    .do = Als JJJJ-MM-TT angeben.

epochs-photographs_without_date = { $n } { $n ->
        [one] Foto hat
        *[other] Fotos haben
    } kein Datum: { LIST($names, most: 5) }.
    .do = Mit { OPTION("date", "JJJJ-MM-TT") } hinzufügen.

epochs-dates_contradict = EXIF widerspricht { $start } und { $end }: die Fotos wurden am { $first } und am { $last } aufgenommen.
    .why = Zwischen den Daten liegen { $days } Tage, zwischen den Fotos { $taken }. Verschiebungen und Geschwindigkeiten gelten für die Daten.
    .do = { OPTION("date", "JJJJ-MM-TT") } prüfen. Wenn die Uhr der Kamera neu gestellt wurde, ist nichts falsch.

epochs-date_of_many_days = Fotos von { $date } wurden vom { $first } bis zum { $last } aufgenommen (EXIF).
    .why = Was sich zwischen diesen Tagen bewegt hat, widerspricht sich innerhalb des Datums.
    .do = Die Fotos jedes Datums in einen eigenen Ordner legen.

epochs-dates_not_paired = { $add } Ordner werden mit { $dates } { $dates ->
        [one] Datum
        *[other] Daten
    } hinzugefügt.
    .do = Für jeden Ordner ein Datum angeben, oder keines.

epochs-no_photographs = { $project } hat keine Fotos.
    .do = Fotos mit { OPTION("add", "PHOTOS") } hinzufügen.

epochs-photographs_left_out = { $date }: { $n } von { $total } Fotos nehmen nicht teil: { LIST($names, most: 3) }{ $copies ->
        [0] {""}
       *[other] ; Kopien: { $copies }
    }{ $unusable ->
        [0] {""}
       *[other] ; unbrauchbar: { $unusable }
    }{ $lost ->
        [0] {""}
       *[other] ; nicht orientiert: { $lost }
    }.
    .why = { $whole ->
        [yes] Verschiebungen dieses Tages gibt es nicht
       *[no] Verschiebungen dieses Tages sind weniger genau
    }.
    .do = Fotos, die nicht teilnehmen, ersetzen oder löschen.

epochs-source_empty = { $folder } hat keine eigenen Fotos.
    .why = Der Ordner ist leer, oder seine Fotos sind Verknüpfungen mit früheren.
    .do = { OPTION("add", "PHOTOS") } korrigieren.

epochs-limit = { $text } ist keine Länge.
    .do = { OPTION("limit", "10mm") } angeben.

epochs-limit_not_tested = { $limit } wird nicht geprüft: Längen haben keinen Maßstab.
    .do = Passpunkte, eine Maßstabsstrecke oder Positionen der Fotos hinzufügen.

epochs-no_scale = Längen haben keinen Maßstab und keine Einheit.
    .do = Passpunkte, eine Maßstabsstrecke oder Positionen der Fotos hinzufügen.

epochs-camera_changed = Kamera { $camera } hat an jedem Tag eine andere innere Orientierung (F { NUM($F) }, { P($p) }).
    .why = Jeder Tag hat eigene Kameraparameter; sie sind weniger genau.
    .do = Fokus und Zoom zwischen den Tagen festhalten.

epochs-limit_exceeded = { $n } { $n ->
        [one] Verschiebung überschreitet
        *[other] Verschiebungen überschreiten
    } { $limit }: { $name } { NUM($length_mm, digits: 3) } mm bis { $end } (Wahrscheinlichkeit über { PERCENT($confidence) } %).
    .do = { $name } prüfen.

epochs-limit_kept = An { $tested } von { $points } Punkten ist die Grenze { $limit } geprüft; keine Verschiebung überschreitet sie dort ({ PERCENT($confidence) } %).

epochs-limit_below_detection = { $limit } ist an { $n } von { $points } Punkten nicht geprüft: unter der Nachweisgrenze.
    .why = Die kleinste nachweisbare Verschiebung beträgt bis zu { NUM($largest_mm, digits: 3) } mm.
    .do = Zu jedem Datum mehr Fotos aufnehmen oder eine größere Grenze angeben. Spalte `detectable` in displacements.csv.

epochs-no_animation = Die Animation der Tage wurde nicht geschrieben.
    .do = Prüfen, ob Fotos aller Tage denselben Teil des Objekts zeigen.
